#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "render/gl/environment.h"
#include "report/program/command_line_texts.h"

namespace plumb {
namespace {

/// Text as roff shows it: no character of it starts a request or an escape.
std::string roff(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\n')
      result += ' ';
    else if ((c == '.' || c == '\'') && result.empty())
      result += std::string("\\&") + c;
    else
      result += c;
  }
  return result;
}

/// "-o, --output DIR", in bold but for what follows the name.
std::string option_heading(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames())
    names += fmt::format("{}\\fB\\-{}\\fR", names.empty() ? "" : ", ", name);
  for (const std::string& name : option.get_lnames())
    names += fmt::format("{}\\fB\\-\\-{}\\fR", names.empty() ? "" : ", ", roff(name));
  if (option.get_positional()) return fmt::format("\\fI{}\\fR", roff(option.get_name(true)));
  if (!option.get_type_name().empty() && option.get_items_expected_max() > 0)
    names += fmt::format(" \\fI{}\\fR", roff(option.get_type_name()));
  return names;
}

std::string list_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    text += fmt::format(".TP\n{}\n{}\n", option_heading(*option), roff(option->get_description()));
  return text;
}

std::string usage_of(const CLI::App& verb) {
  std::string usage = "\\fBplumb " + roff(verb.get_name()) + "\\fR";
  for (const CLI::Option* option : verb.get_options())
    if (option->get_positional())
      usage += fmt::format("{}\\fI{}\\fR{}", option->get_required() ? " " : " [",
                           roff(option->get_name(true)), option->get_required() ? "" : "]");
  return usage + " [\\fIOPTION\\fR ...]";
}

}  // namespace

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string manual_page(const CLI::App& app) {
  std::string page = ".TH PLUMB 1 \"\" \"Plumb " PLUMB_VERSION "\" \"User Commands\"\n";
  page += ".SH NAME\nplumb \\- integrate a flexible cable, draw it, and report how far it can be trusted\n";
  page += ".SH SYNOPSIS\n.B plumb\n.I VERB\n[\\fIARGUMENT\\fR ...] [\\fIOPTION\\fR ...]\n";
  page += ".SH DESCRIPTION\n" + roff(app.get_description()) +
          "\n.PP\nA case is a TOML file, or the name of one that came with the program, such as "
          "\\fBpendulum\\fR.\n";
  page += ".SH VERBS\n";
  for (const CLI::App* verb : verbs_of(app))
    page += fmt::format(".SS {}\n{}.\n.PP\n{}\n{}", roff(verb->get_name()), roff(verb->get_description()),
                        usage_of(*verb), list_of(*verb));
  page += ".SH OPTIONS\n" + list_of(app);
  page += ".SH ENVIRONMENT\n";
  for (const EnvironmentVariable& variable : environment_variables())
    page += fmt::format(".TP\n.B {}\n{}\n", roff(variable.name), roff(variable.meaning));
  page += ".SH EXIT STATUS\n" + roff(app.get_footer()) + "\n";
  return page;
}

}  // namespace plumb
