#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "render/gl/environment.h"
#include "report/program/installed_cases.h"
#include "report/program/study_kinds.h"
#include "report/program/verbs.h"
#include "tests/report/program/program.h"

namespace plumb::command_line_texts_test {
namespace {

std::string said(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "plumb");
  return parse_command(static_cast<int>(arguments.size()), arguments.data()).said;
}

TEST(CommandLineTexts, ManualHasEveryVerbOptionAndVariable) {
  const std::string page = said({"--manual"});
  for (const Verb& verb : verbs()) {
    EXPECT_NE(page.find("\n.SS " + verb.name + "\n"), page.npos) << verb.name;
    const std::string help = said({verb.name.c_str(), "--help"});
    for (std::size_t at = help.find("  --"); at != help.npos; at = help.find("  --", at + 1)) {
      std::string option = help.substr(at + 2, help.find_first_of(" \n", at + 2) - at - 2), roff;
      for (const char c : option) roff += c == '-' ? std::string("\\-") : std::string(1, c);
      EXPECT_NE(page.find(roff), page.npos) << option << " of " << verb.name;
    }
  }
  for (const EnvironmentVariable& variable : environment_variables())
    EXPECT_NE(page.find(std::string("\n.B ") + std::string(variable.name)), page.npos) << variable.name;
}

TEST(CommandLineTexts, SchemaHasEveryTableOfACaseAndEveryKindOfStudy) {
  const auto schema = nlohmann::json::parse(said({"--schema"}));
  const auto& study = schema.at("$defs").at("study");
  EXPECT_EQ(study.at("oneOf").size(), study_kinds().size());
  const auto& tables = schema.at("$defs").at("case").at("properties");
  for (const char* table : {"cable", "start", "supports", "loads", "time"})
    EXPECT_FALSE(tables.at(table).at("required").empty()) << table;
  EXPECT_EQ(tables.at("cable").at("properties").at("density").at("description"), "kg/m³");
}

TEST(CommandLineTexts, BashCompletesVerbsOptionsAndCases) {
  TemporaryFolder folder;
  write_text(folder / "completion", said({"--completion", "bash"}));
  const auto completed = [&](const std::string& words, int at) {
    const Ended ended =
        run_command({"bash", "-c",
                     "plumb() { echo pendulum; }; source ./completion; COMP_WORDS=(" + words +
                         "); COMP_CWORD=" + std::to_string(at) + "; _plumb plumb; echo ${COMPREPLY[*]}"},
                    folder.path());
    return ended.out + ended.err;
  };
  EXPECT_EQ(completed("plumb ren", 1), "render\n");
  EXPECT_EQ(completed("plumb render --vi", 2), "--video\n");
  EXPECT_EQ(completed("plumb run pen", 2), "pendulum\n");
  EXPECT_EQ(completed("plumb report comp", 2), "completion\n");
}

TEST(CommandLineTexts, OtherShellsAreRefusedByName) {
  for (const char* shell : {"tcsh", ""}) {
    try {
      said({"--completion", shell});
      FAIL() << shell;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("bash, zsh or fish"), std::string::npos) << error.what();
    }
  }
  for (const char* shell : {"zsh", "fish"})
    for (const Verb& verb : verbs())
      EXPECT_NE(said({"--completion", shell}).find(verb.name), std::string::npos) << shell << verb.name;
}

TEST(InstalledCases, AreFoundByNameFromAnywhere) {
  TemporaryFolder folder;
  for (const char* name : {"pendulum", "failure/slack_cable", "shelf/elastica"}) {
    const Ended ended = plumb_in(folder.path(), {"check", name});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find(std::string("cases/") + name + ".toml is valid"), std::string::npos)
        << ended.out;
  }
  const std::string all = plumb_in(folder.path(), {"--cases"}).out;
  EXPECT_NE(all.find("shelf/elastica\n"), std::string::npos) << all;
  EXPECT_EQ(all.find("references"), std::string::npos) << "they are no cases: " << all;
}

TEST(InstalledCases, GiveWayToAFileOfThatName) {
  TemporaryFolder folder;
  write_text(folder / "pendulum", "title = 3\n");
  const Ended ended = plumb_in(folder.path(), {"check", "pendulum"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find("pendulum:1:9"), std::string::npos) << ended.err;
}

TEST(InstalledCases, UnknownNamesAreRefusedWithTheNearest) {
  TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"solve", "pendulun"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find("did you mean \"pendulum\"?"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(folder / "output"));
}

}  // namespace
}  // namespace plumb::command_line_texts_test
