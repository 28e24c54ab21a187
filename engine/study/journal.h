#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "engine/case/case_source.h"

namespace plumb {

/// What a study under way has computed, so that one that is interrupted can go on from there: a line of JSON
/// a point behind its check sum, written as soon as it is done. A last line that was cut off is left out, and
/// so is any whose check sum is not its own. Safe to use from several threads, and from a process and those
/// that it has forked.
class Journal {
 public:
  /// Kept in memory only.
  Journal() = default;
  /// Goes on with the file at `path` if it is of the same `identity`, and starts it anew otherwise.
  /// Throws OutputError if it cannot be written, here and in every `add`, and for a link or what is no
  /// journal, which stay as they are.
  Journal(std::string path, const std::string& identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Takes over what the text of another journal of the same `identity` holds, if it is one.
  void take_over(const std::string& text, const std::string& identity);

  /// The result of a point as JSON, if it is known.
  std::optional<std::string> find(const std::string& key) const;
  /// Takes JSON without a line break.
  void add(const std::string& key, const std::string& result);

  bool empty() const;

  /// How many lines were found in the file, and how many of it are damaged: what they held is done again.
  std::size_t found() const { return found_; }
  std::size_t damaged() const { return damaged_; }
  const std::string& path() const { return path_; }

  /// All that it holds, as the text of a journal.
  std::string text(const std::string& identity) const;

  /// Removes the file: the study is done and its results are written.
  void remove();

 private:
  void go_on();
  std::string read(long size) const;
  void write(std::string_view rest);
  /// False if the line is damaged.
  bool take(const std::string& line, const std::string& identity);
  [[noreturn]] void fail(const std::string& why) const;

  std::string path_;
  std::string identity_;
  int file_ = -1;
  std::size_t found_ = 0;
  std::size_t damaged_ = 0;
  mutable std::mutex guard_;
  std::map<std::string, std::string> results_;
};

/// What a journal must have been made of for its points to count: texts and overrides of the case, the
/// program and the processor.
std::string study_identity(const CaseSource& source);

}  // namespace plumb
