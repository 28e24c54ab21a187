#include "engine/study/journal.h"

#include <sys/stat.h>

#include "engine/base/errors.h"
#include "tests/engine/study/journal_file.h"

namespace plumb {
namespace journal_test {

namespace fs = std::filesystem;

TEST(Journal, OfAnotherCaseProgramOrMachineIsStartedAnew) {
  const JournalPath path;
  {
    Journal journal(path.string(), "a");
    journal.add("one", "1");
  }
  EXPECT_EQ(Journal(path.string(), "a").found(), 1U);
  EXPECT_EQ(Journal(path.string(), "b").found(), 0U);
  EXPECT_EQ(Journal(path.string(), "a").found(), 0U) << "b has taken its place";
  const CaseSource source{{"a.toml", "title = \"A\""}, {}, {{"r.toml", "x"}}};
  CaseSource set = source, held_against_other = source;
  set.overrides = {"cable.elements=3"};
  held_against_other.references[0].text = "y";
  EXPECT_NE(study_identity(source), study_identity(set));
  EXPECT_NE(study_identity(source), study_identity(held_against_other));
  EXPECT_EQ(study_identity(source), study_identity(source));
}

TEST(Journal, LinesOfNonsenseAreLeftOut) {
  const JournalPath path;
  { Journal journal(path.string(), "a"); }
  std::vector<std::string> lines = lines_of(path.string());
  for (const char* bad : {"", "{", "[]", "{\"point\":1}", "00000000 {\"point\":\"one\",\"result\":1}",
                          "{\"result\":\"x\"}", "\xff\xfe", "{\"point\":[]}"})
    lines.emplace_back(bad);
  write_lines(path.string(), lines, "");
  const Journal journal(path.string(), "a");
  EXPECT_EQ(journal.found(), 0U);
  EXPECT_EQ(journal.damaged(), 8U);
}

TEST(Journal, ALineThatWasChangedIsNotTrusted) {
  const JournalPath path;
  {
    Journal journal(path.string(), "a");
    journal.add("one", "[1,\"nan\"]");
    journal.add("two", "{\"b\":2}");
  }
  const std::vector<std::string> lines = lines_of(path.string());
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(Journal(path.string(), "a").found(), 2U);
  EXPECT_EQ(Journal(path.string(), "a").damaged(), 0U);
  for (std::size_t at = 0; at < lines[1].size(); at += 3) {
    std::vector<std::string> changed = lines;
    changed[1][at] = static_cast<char>(changed[1][at] ^ 1);
    write_lines(path.string(), changed, "");
    const Journal journal(path.string(), "a");
    EXPECT_EQ(journal.found(), 1U) << "byte " << at << " of " << lines[1];
    EXPECT_EQ(journal.damaged(), 1U);
    EXPECT_FALSE(journal.find("one")) << "byte " << at;
    EXPECT_EQ(journal.find("two"), "{\"b\":2}");
  }
}

TEST(Journal, ALineOfAnotherJournalDoesNotCount) {
  const JournalPath path;
  std::vector<std::string> lines;
  {
    Journal journal(path.string(), "a");
    journal.add("one", "1");
  }
  lines = lines_of(path.string());
  { Journal journal(path.string(), "b"); }
  write_lines(path.string(), {lines_of(path.string())[0], lines[1]}, "");
  const Journal journal(path.string(), "b");
  EXPECT_EQ(journal.found(), 0U);
  EXPECT_EQ(journal.damaged(), 1U);
}

TEST(Journal, WhatIsNoJournalStaysAsItIs) {
  const JournalPath path;
  const std::string precious = path.string() + "-precious";
  const auto refused = [&](const char* what) {
    EXPECT_THROW(Journal(path.string(), "a"), OutputError) << what;
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
  { Journal journal(precious + ".jsonl", "b"); }
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
    EXPECT_EQ(Journal(path.string(), "a").found(), 0U) << text;
    EXPECT_EQ(lines_of(path.string()).size(), 1U) << text;
  }
}

TEST(Journal, ThatCannotBeWrittenIsAnOutputError) {
  EXPECT_THROW(Journal("/nowhere/journal", "a"), OutputError);
}

TEST(Journal, TakesOverWhatAnotherOfTheSameIdentityHolds) {
  Journal own, other, strange;
  own.add("one", "1");
  own.add("two", "[2.5]");
  const std::string text = own.text("a");
  other.take_over(text, "a");
  EXPECT_EQ(other.find("one"), "1");
  EXPECT_EQ(other.find("two"), "[2.5]");
  strange.take_over(text, "b");
  EXPECT_TRUE(strange.empty());
  strange.take_over("nonsense", "a");
  EXPECT_TRUE(strange.empty());
}

}  // namespace journal_test
}  // namespace plumb
