#include "engine/base/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <numbers>

namespace plumb {
namespace {

/// True for what no expression needs: muParser's character classes are not made for other alphabets.
bool is_odd(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\t') || code >= 0x7f;
}

/// muParser's message without its own count of the position, which the caller turns into a column.
ExpressionError translated(const mu::ParserError& error, const std::string& expression) {
  std::string what = error.GetMsg();
  for (std::string_view tail : {" found at position", " at position", " at expression position"}) {
    what = what.substr(0, what.find(tail));
  }
  while (!what.empty() && (what.back() == '.' || what.back() == '!')) what.pop_back();
  if (!what.empty()) what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
  const std::size_t last = expression.size();
  const std::size_t position =
      error.GetPos() < 0 ? 0 : std::min(last, static_cast<std::size_t>(error.GetPos()));
  return {what, position};
}

mu::Parser parser_for(const std::string& expression) {
  constexpr std::size_t longest = 1000;
  if (expression.find_first_not_of(" \t") == std::string::npos)
    throw ExpressionError("the expression is empty", 0);
  const auto odd = std::find_if(expression.begin(), expression.end(), is_odd);
  if (odd != expression.end()) {
    throw ExpressionError("an expression holds plain characters only",
                          static_cast<std::size_t>(odd - expression.begin()));
  }
  if (expression.size() > longest) {
    throw ExpressionError(fmt::format("an expression has at most {} characters", longest), longest);
  }
  mu::Parser parser;
  parser.DefineConst("pi", std::numbers::pi);
  parser.SetExpr(expression);
  return parser;
}

double only_result(const mu::Parser& parser, const std::string& expression) {
  int count = 0;
  const double* results = parser.Eval(count);
  if (count != 1) {
    throw ExpressionError(fmt::format("gives {} numbers instead of one (the decimal mark is a point)", count),
                          std::min(expression.find(','), expression.size()));
  }
  return results[0];
}

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::size_t first_use(const std::string& expression, const std::string& name) {
  for (std::size_t at = expression.find(name); at != std::string::npos; at = expression.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool starts = at == 0 || !is_name_character(expression[at - 1]);
    if (starts && (end == expression.size() || !is_name_character(expression[end]))) return at;
  }
  return 0;
}

}  // namespace

std::vector<UsedName> names_in(const std::string& expression) {
  try {
    mu::Parser parser = parser_for(expression);
    std::vector<UsedName> names;
    for (const auto& [name, unused] : parser.GetUsedVar()) {
      const std::size_t position = first_use(expression, name);
      if (std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
        throw ExpressionError(fmt::format("\"{}\" is not a number", name), position);
      }
      names.push_back({name, position});
    }
    std::sort(names.begin(), names.end(),
              [](const UsedName& a, const UsedName& b) { return a.position < b.position; });
    return names;
  } catch (const mu::ParserError& error) {
    throw translated(error, expression);
  }
}

double evaluate(const std::string& expression, const std::map<std::string, double>& values) {
  try {
    mu::Parser parser = parser_for(expression);
    // Constants rather than variables: an expression cannot assign to them.
    for (const auto& [name, value] : values) parser.DefineConst(name, value);
    return only_result(parser, expression);
  } catch (const mu::ParserError& error) {
    throw translated(error, expression);
  }
}

bool is_built_in(std::string_view name) {
  const mu::Parser parser;
  const std::string text(name);
  return name == "pi" || parser.GetFunDef().contains(text) || parser.GetConst().contains(text);
}

}  // namespace plumb
