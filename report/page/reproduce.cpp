#include "report/page/reproduce.h"

namespace plumb {

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=:,+@%-";
  if (!word.empty() && word.find_first_not_of(plain) == word.npos) return word;
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'')
      quoted += "'\\''";
    else
      quoted += c;
  }
  return quoted + "'";
}

std::string command_of(const Document& document) {
  const Document& the_case = document.at("case");
  std::string command = "plumb run " + shell_word(the_case.at("file").get<std::string>());
  for (const Document& text : the_case.at("overrides"))
    command += " --set " + shell_word(text.get<std::string>());
  return command;
}

}  // namespace plumb
