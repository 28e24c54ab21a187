#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "engine/base/errors.h"
#include "report/program/command_line_texts.h"

namespace plumb {
namespace {

/// Every option as it is typed: "-o", "--output".
std::vector<std::string> typed_names(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string typed_options(const CLI::App& verb) {
  std::string words;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : typed_names(*option)) words += (words.empty() ? "" : " ") + name;
  return words;
}

bool takes_case(const CLI::App& verb) {
  const auto options = verb.get_options();
  return std::any_of(options.begin(), options.end(), [](const CLI::Option* option) {
    return option->get_positional() && option->get_name(true) == "CASE";
  });
}

/// Text within single quotes of a shell.
std::string for_shell(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string for_bash(const CLI::App& app) {
  std::string words, options, with_cases;
  for (const CLI::App* verb : verbs_of(app)) {
    words += (words.empty() ? "" : " ") + verb->get_name();
    options += fmt::format("    {}) words={} ;;\n", verb->get_name(), for_shell(typed_options(*verb)));
    if (takes_case(*verb)) with_cases += (with_cases.empty() ? "" : "|") + verb->get_name();
  }
  return fmt::format(R"(# bash completion for plumb
_plumb() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words=''
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W {} -- "$word"))
    return
  fi
  if [[ $word == -* ]]; then
    case ${{COMP_WORDS[1]}} in
{}    esac
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
    {}) words=$("$1" --cases 2>/dev/null) ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word") $(compgen -f -- "$word"))
}}
complete -o filenames -F _plumb plumb
)",
                     for_shell(words + " " + typed_options(app)), options, with_cases);
}

/// A description in a list of zsh: colons part it from the word, brackets end it.
std::string zsh_description(std::string text) {
  for (char& c : text)
    if (c == '[' || c == ']' || c == ':' || c == '\n') c = ' ';
  return text;
}

std::string for_zsh(const CLI::App& app) {
  std::string list, verbs;
  for (const CLI::App* verb : verbs_of(app)) {
    list +=
        fmt::format("    {}\n", for_shell(verb->get_name() + ":" + zsh_description(verb->get_description())));
    std::string arguments;
    for (const CLI::Option* option : verb->get_options())
      for (const std::string& name : typed_names(*option))
        arguments +=
            fmt::format(" \\\n        {}",
                        for_shell(fmt::format("*{}[{}]{}", name, zsh_description(option->get_description()),
                                              option->get_items_expected_max() > 0 ? ":value:_files" : "")));
    verbs += fmt::format("    {}) _arguments{} \\\n        {} ;;\n", verb->get_name(), arguments,
                         for_shell(takes_case(*verb) ? "*:case:_plumb_cases" : "*:file:_files"));
  }
  return fmt::format(R"zsh(#compdef plumb
_plumb_cases() {{
  local -a cases
  cases=(${{(f)"$(plumb --cases 2>/dev/null)"}})
  _alternative 'cases:case:compadd -a cases' 'files:file:_files'
}}
_plumb() {{
  local -a verbs
  verbs=(
{}  )
  if (( CURRENT == 2 )); then
    _describe verb verbs
    return
  fi
  local verb=$words[2]
  shift words
  (( CURRENT-- ))
  case $verb in
{}  esac
}}
_plumb "$@"
)zsh",
                     list, verbs);
}

std::string for_fish(const CLI::App& app) {
  std::string text = "# fish completion for plumb\n", with_cases;
  for (const CLI::App* verb : verbs_of(app)) {
    text += fmt::format("complete -c plumb -f -n __fish_use_subcommand -a {} -d {}\n", verb->get_name(),
                        for_shell(verb->get_description()));
    if (takes_case(*verb)) with_cases += (with_cases.empty() ? "" : " ") + verb->get_name();
    for (const CLI::Option* option : verb->get_options()) {
      if (option->get_positional()) continue;
      std::string names;
      for (const std::string& name : option->get_snames()) names += " -s " + name;
      for (const std::string& name : option->get_lnames()) names += " -l " + name;
      text += fmt::format("complete -c plumb -n '__fish_seen_subcommand_from {}'{}{} -d {}\n",
                          verb->get_name(), names, option->get_items_expected_max() > 0 ? " -r" : "",
                          for_shell(option->get_description()));
    }
  }
  return text +
         fmt::format(
             "complete -c plumb -n '__fish_seen_subcommand_from {}' -a '(plumb --cases 2>/dev/null)'\n",
             with_cases);
}

}  // namespace

std::string completion(const CLI::App& app, std::string_view shell) {
  if (shell == "bash") return for_bash(app);
  if (shell == "zsh") return for_zsh(app);
  if (shell == "fish") return for_fish(app);
  throw UsageError(fmt::format("--completion {}: must be bash, zsh or fish", shell));
}

}  // namespace plumb
