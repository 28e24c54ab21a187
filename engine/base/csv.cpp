#include "engine/base/csv.h"

#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "engine/base/message.h"

namespace plumb {
namespace {

constexpr std::size_t most_cells = 10'000'000;

bool blank(char c) {
  return c == ' ' || c == '\t';
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& name, char separator)
      : text_(text), name_(name), separator_(separator) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  }

  std::vector<CsvLine> lines() {
    std::vector<CsvLine> result;
    while (at_ < text_.size()) {
      CsvLine line{line_, {}};
      do {
        // A cell takes some fifty times the memory of the comma that makes it.
        if (++cells_ > most_cells) fail(fmt::format("there are more than {} cells", most_cells));
        if (cells_ % 4096 == 0) stop_if_interrupted();
        line.cells.push_back(cell());
      } while (separates());
      end_line();
      if (line.cells.size() > 1 || !line.cells.front().text.empty()) result.push_back(std::move(line));
    }
    return result;
  }

 private:
  bool at_end_of_line() const { return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }

  bool separates() {
    if (separator_ != ' ') return take(separator_);
    skip_blanks();
    return !at_end_of_line();
  }

  bool ends_cell() const {
    return at_end_of_line() || text_[at_] == separator_ || (separator_ == ' ' && blank(text_[at_]));
  }

  bool take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    advance();
    return true;
  }

  void advance() {
    if (text_[at_] == '\n') {
      ++line_;
      column_ = 1;
    } else if ((static_cast<unsigned char>(text_[at_]) & 0xC0U) !=
               0x80U) {  // not within a character of UTF-8
      ++column_;
    }
    ++at_;
  }

  void skip_blanks() {
    while (at_ < text_.size() && blank(text_[at_]) && (separator_ == ' ' || text_[at_] != separator_))
      advance();
  }

  CsvCell cell() {
    skip_blanks();
    CsvCell result{{}, column_};
    if (at_ < text_.size() && text_[at_] == '"') {
      result.text = quoted();
      skip_blanks();
      if (!ends_cell() && separator_ != ' ') fail("there is text after a closing quote");
      return result;
    }
    const char first = at_end_of_line() ? '\0' : text_[at_];
    const char closing = separator_ != ' ' ? '\0' : first == '(' ? ')' : first == '[' ? ']' : '\0';
    bool closed = closing == '\0';
    while (!at_end_of_line() && (!closed || !ends_cell())) {
      closed = closed || text_[at_] == closing;
      result.text += text_[at_];
      advance();
    }
    while (!result.text.empty() && blank(result.text.back())) result.text.pop_back();
    return result;
  }

  std::string quoted() {
    std::string result;
    const int line = line_, column = column_;
    advance();
    for (;;) {
      if (at_ == text_.size()) {
        line_ = line;
        column_ = column;
        fail("a quote is not closed");
      }
      const char c = text_[at_];
      advance();
      if (c == '"' && !take('"')) return result;
      result += c;
    }
  }

  void end_line() {
    if (at_ < text_.size() && text_[at_] == '\r') advance();
    if (at_ < text_.size() && text_[at_] == '\n')
      advance();
    else if (at_ < text_.size())
      ++line_;  // a lone CR
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(one_line(fmt::format("{}:{}:{}: {}", name_, line_, column_, what)));
  }

  std::string_view text_;
  std::string name_;
  char separator_;
  std::size_t at_ = 0, cells_ = 0;
  int line_ = 1, column_ = 1;
};

}  // namespace

std::vector<CsvLine> parse_csv(std::string_view text, const std::string& name, char separator) {
  return Parser(text, name, separator).lines();
}

std::string csv_cell(const std::string& text) {
  const bool plain = text.find_first_of(",\"\r\n") == std::string::npos &&
                     (text.empty() || (!blank(text.front()) && !blank(text.back())));
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace plumb
