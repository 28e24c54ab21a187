#include "engine/study/journal.h"

#include <sys/stat.h>

#include "engine/base/errors.h"
#include "tests/engine/study/journal_file.h"

namespace plumb {
namespace journal_test {

namespace fs = std::filesystem;

StudyIdentity of(const char* name) {
  return {name, "case.toml", "this program"};
}

TEST(Journal, OfAnotherCaseOrProgramIsStartedAnew) {
  const JournalPath path;
  {
    Journal journal(path.string(), of("a"));
    journal.add("one", "1");
  }
  EXPECT_EQ(Journal(path.string(), of("a")).found(), 1U);
  EXPECT_EQ(Journal(path.string(), of("b")).found(), 0U);
  EXPECT_EQ(Journal(path.string(), of("a")).found(), 0U) << "b has taken its place";
  const CaseSource source{{"a.toml", "title = \"A\""}, {}, {{"r.toml", "x"}}};
  CaseSource set = source, held_against_other = source;
  set.overrides = {"cable.elements=3"};
  held_against_other.references[0].text = "y";
  EXPECT_NE(study_identity(source).sum(), study_identity(set).sum());
  EXPECT_NE(study_identity(source).sum(), study_identity(held_against_other).sum());
  EXPECT_EQ(study_identity(source).sum(), study_identity(source).sum());
}

TEST(Journal, LinesOfNonsenseAreLeftOut) {
  const JournalPath path;
  { Journal journal(path.string(), of("a")); }
  std::vector<std::string> lines = lines_of(path.string());
  for (const char* bad : {"", "{", "[]", "{\"point\":1}", "00000000 {\"point\":\"one\",\"result\":1}",
                          "{\"result\":\"x\"}", "\xff\xfe", "{\"point\":[]}"})
    lines.emplace_back(bad);
  write_lines(path.string(), lines, "");
  const Journal journal(path.string(), of("a"));
  EXPECT_EQ(journal.found(), 0U);
  EXPECT_EQ(journal.damaged(), 8U);
}

TEST(Journal, ALineThatWasChangedIsNotTrusted) {
  const JournalPath path;
  {
    Journal journal(path.string(), of("a"));
    journal.add("one", "[1,\"nan\"]");
    journal.add("two", "{\"b\":2}");
  }
  const std::vector<std::string> lines = lines_of(path.string());
  ASSERT_EQ(lines.size(), 4U) << "heading, machine, two points";
  EXPECT_EQ(Journal(path.string(), of("a")).found(), 2U);
  EXPECT_EQ(Journal(path.string(), of("a")).damaged(), 0U);
  for (std::size_t at = 0; at < lines[2].size(); at += 3) {
    std::vector<std::string> changed = lines;
    changed[2][at] = static_cast<char>(changed[2][at] ^ 1);
    write_lines(path.string(), changed, "");
    const Journal journal(path.string(), of("a"));
    EXPECT_EQ(journal.found(), 1U) << "byte " << at << " of " << lines[2];
    EXPECT_EQ(journal.damaged(), 1U);
    EXPECT_FALSE(journal.find("one")) << "byte " << at;
    EXPECT_EQ(journal.find("two"), "{\"b\":2}");
  }
}

TEST(Journal, ALineOfAnotherJournalDoesNotCount) {
  const JournalPath path;
  std::vector<std::string> lines;
  {
    Journal journal(path.string(), of("a"));
    journal.add("one", "1");
  }
  lines = lines_of(path.string());
  { Journal journal(path.string(), of("b")); }
  write_lines(path.string(), {lines_of(path.string())[0], lines[1], lines[2]}, "");
  const Journal journal(path.string(), of("b"));
  EXPECT_EQ(journal.found(), 0U);
  EXPECT_EQ(journal.damaged(), 2U);
}

TEST(Journal, WhatIsNoJournalStaysAsItIs) {
  const JournalPath path;
  const std::string precious = path.string() + "-precious";
  const auto refused = [&](const char* what) {
    EXPECT_THROW(Journal(path.string(), of("a")), OutputError) << what;
  };
  write_lines(precious, {"mine"}, "");
  fs::create_symlink(precious, path.string());
  refused("a link");
  EXPECT_EQ(lines_of(precious), std::vector<std::string>{"mine"});
  fs::remove(path.string());
  write_lines(path.string(), {"mine"}, "");
  refused("a text");
  EXPECT_EQ(lines_of(path.string()), std::vector<std::string>{"mine"});
  for (const char* text :
       {R"({"identity":"my own diary","x":1})", R"({"identity":"a","plumb_study_journal":"no"})"}) {
    write_lines(path.string(), {text}, "");
    refused(text);
    EXPECT_EQ(lines_of(path.string()), std::vector<std::string>{text});
  }
  fs::remove(path.string());
  ASSERT_EQ(::mkfifo(path.string().c_str(), 0600), 0);
  refused("a pipe");
  fs::remove(path.string());
  { Journal journal(precious + ".jsonl", of("b")); }
  fs::create_hard_link(precious + ".jsonl", path.string());
  refused("another study's under two names");
  EXPECT_EQ(lines_of(path.string()).size(), 1U);
  fs::remove(precious);
  fs::remove(precious + ".jsonl");
}

TEST(Journal, CutOffWithinItsHeadingIsStartedAnew) {
  const JournalPath path;
  for (const char* text : {"", "{", "{\"identity\":\"a"}) {
    write_lines(path.string(), {}, text);
    EXPECT_EQ(Journal(path.string(), of("a")).found(), 0U) << text;
    EXPECT_EQ(lines_of(path.string()).size(), 1U) << text;
  }
}

TEST(Journal, ThatCannotBeWrittenIsAnOutputError) {
  EXPECT_THROW(Journal("/nowhere/journal", of("a")), OutputError);
}

/// A file of a journal that was only kept in memory.
void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

TEST(Journal, TakesOverWhatAnotherOfTheSameIdentityHolds) {
  const JournalPath path;
  Journal own, other, strange;
  own.add("one", "1");
  own.add("two \"quoted\" \\ ü", "[2.5]");
  write_text(path.string(), own.text(of("a")));
  other.take_over(path.string(), of("a"));
  EXPECT_EQ(other.find("one"), "1");
  EXPECT_EQ(other.find("two \"quoted\" \\ ü"), "[2.5]");
  strange.take_over(path.string(), of("b"));
  EXPECT_TRUE(strange.empty());
  write_text(path.string(), "nonsense");
  strange.take_over(path.string(), of("a"));
  EXPECT_TRUE(strange.empty());
  strange.take_over("/nowhere", of("a"));
  EXPECT_TRUE(strange.empty());
}

TEST(Journal, OfAnotherCaseOrProgramIsRefusedByNameWhereItIsMerged) {
  const JournalPath path;
  const StudyIdentity own = of("a");
  Journal made;
  made.add("one", "1");
  const auto refusal = [&](const std::string& text) -> std::string {
    write_text(path.string(), text);
    Journal journal;
    try {
      journal.merge(path.string(), own);
    } catch (const InputError& error) {
      EXPECT_TRUE(journal.empty());
      return error.what();
    }
    return "";
  };
  const auto expect_named = [&](const std::string& text, const std::string& what) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find(path.string()), said.npos) << said;
    EXPECT_NE(said.find(what), said.npos) << said << "\nnot: " << what;
  };
  EXPECT_EQ(refusal(made.text(own)), "");
  expect_named(made.text({"b", "other.toml", own.program}), "another case, other.toml");
  expect_named(made.text({"a", own.case_name, "revision 7"}), "another program: revision 7");
  expect_named(made.text({"a", "renamed.toml", own.program}), "renamed.toml");
  expect_named("", "is no journal");
  expect_named("mine\n", "is no journal");
  expect_named(std::string(1 << 20, 'x'), "is no journal");
  expect_named("{\"identity\":\"a\",\"plumb_study_journal\":3}\n", "version 3, this program reads 4");
  Journal journal;
  EXPECT_THROW(journal.merge("/nowhere", own), InputError);
}

TEST(Journal, KnowsWhereEachPointWasComputed) {
  const JournalPath path;
  const Machine near{"near", "processor A", "r1"}, far{"far", "processor B", "r1"};
  {
    Journal journal(path.string(), of("a"));
    journal.add("one", "1", 0.25, near);
    journal.add("two", "2", 3e-7, far);
    journal.add("three", "3", -1, near);
  }
  Journal again(path.string(), of("a"));
  EXPECT_EQ(again.found(), 3U);
  EXPECT_EQ(again.machine_of("one"), near);
  EXPECT_EQ(again.machine_of("two"), far);
  EXPECT_EQ(again.machine_of("three"), near);
  EXPECT_EQ(again.seconds_of("one"), 0.25);
  EXPECT_EQ(again.seconds_of("two"), 3e-7);
  EXPECT_EQ(again.seconds_of("three"), -1);
  again.add("four", "4", 1, {"third", "processor C", "r1"});
  Journal merged;
  merged.add("two", "second result", 1, near);
  merged.merge(path.string(), of("a"));
  EXPECT_EQ(merged.machine_of("four").host, "third");
  EXPECT_EQ(merged.find("two"), "second result") << "the first one stays";
  std::map<std::string, std::size_t> points;
  for (const auto& [machine, count] : merged.machines()) points[machine.host] = count;
  EXPECT_EQ(points, (std::map<std::string, std::size_t>{{"near", 3}, {"far", 0}, {"third", 1}}));
}

TEST(Journal, NamesWhatIsMissingAndHoldsOnlyWhatIsWanted) {
  const JournalPath path;
  Journal made;
  made.add("references: one", "1");
  made.add("errors: two", "2");
  write_text(path.string(), made.text(of("a"), [](const std::string& key) { return key.starts_with("ref"); },
                                      {"errors: three", "errors: \"four\""}));
  Journal read;
  read.merge(path.string(), of("a"));
  EXPECT_EQ(read.missing(), (std::set<std::string>{"errors: three", "errors: \"four\""}));
  EXPECT_EQ(read.points(), 1U);
  EXPECT_TRUE(read.find("references: one"));
}

// As network file systems leave it that append where another machine appended at the same time, or end a file
// with a hole.
TEST(Journal, LinesThatTwoMachinesWroteOverOneAnotherAreDoneAgain) {
  const JournalPath path;
  {
    Journal journal(path.string(), of("a"));
    for (const char* key : {"one", "two", "three"}) journal.add(key, "[1,2,3]");
  }
  const std::vector<std::string> lines = lines_of(path.string());
  ASSERT_EQ(lines.size(), 5U);
  std::vector<std::string> overwritten = lines;
  overwritten[3] = lines[4].substr(0, 30) + lines[3].substr(30);
  overwritten.push_back(std::string(100, '\0'));
  write_lines(path.string(), overwritten, std::string(50, '\0'));
  Journal journal(path.string(), of("a"));
  EXPECT_EQ(journal.found(), 2U);
  EXPECT_EQ(journal.damaged(), 2U);
  EXPECT_FALSE(journal.find("two"));
  journal.add("two", "[1,2,3]");
  Journal merged;
  merged.merge(path.string(), of("a"));
  EXPECT_EQ(merged.points(), 3U) << "what comes after a hole is found";
}

TEST(Journal, OfAPointComputedTwiceTheLastResultCountsAndOfSeveralJournalsTheFirst) {
  const JournalPath path;
  {
    Journal journal(path.string(), of("a"));
    journal.add("one", "of another version");
    journal.add("one", "[1]");
  }
  EXPECT_EQ(Journal(path.string(), of("a")).find("one"), "[1]");
  Journal other, merged;
  merged.merge(path.string(), of("a"));
  other.add("one", "[2]");
  write_text(path.string(), other.text(of("a")));
  merged.merge(path.string(), of("a"));
  EXPECT_EQ(merged.find("one"), "[1]");
}

TEST(Journal, IsForOneProgramAtATime) {
  const JournalPath path;
  const Journal journal(path.string(), of("a"));
  EXPECT_THROW(Journal(path.string(), of("a")), OutputError);
}

}  // namespace journal_test
}  // namespace plumb
