#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/report/program/program.h"

// What a part of a study says and leaves, how parts are put together, and what is refused. That the results
// are those of one machine is held in tests/engine/study/divided_study_test.cpp.

namespace plumb {
namespace shares_test {

using Json = nlohmann::json;

class Shares : public ::testing::Test {
 protected:
  Shares() { write_text(folder_ / "small.toml", case_text("")); }

  static std::string case_text(const std::string& more) {
    return R"(title = "Small"
[cable]
length = 1
area = 2.5e-5
density = 320
youngs_modulus = 1.6e6
elements = 2
[start]
angular_velocity = [0, 4, 0]
[loads]
gravity = [0, -9.81, 0]
[method]
name = "velocity-verlet"
step = 1e-4
[time]
end = 0.02
output_interval = 0.01
[[study.variant]]
name = "as it is"
[[study.variant]]
name = "finer"
set = { method.step = 5e-5 }
[[study.variant]]
name = "coarser"
set = { method.step = 2e-4 }
)" + more;
  }

  Ended study(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"study", "small.toml", "variants"});
    return plumb_in(folder_.path(), arguments);
  }

  /// The journal of a share that was computed.
  std::string share(const std::string& which, const std::string& folder) const {
    const Ended ended = study({"--share", which, "-o", folder});
    EXPECT_EQ(ended.status, 0) << ended.err;
    return (folder_ / folder / "points.jsonl").string();
  }

  void expect_refused(const Ended& ended, int status, const std::vector<std::string>& words) const {
    EXPECT_EQ(ended.status, status) << ended.err << ended.out;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    for (const std::string& word : words) EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Shares, ArePutTogetherAndWhatIsMissingIsListedAndComputed) {
  share("1/3", "one");
  const Ended third = study({"--share", "3/3", "--json"});
  ASSERT_EQ(third.status, 0) << third.err;
  const Json said = Json::parse(third.out);
  EXPECT_EQ(said["points"], 3);
  EXPECT_EQ(said["own_points"], 1);
  EXPECT_NE(said["journal"].get<std::string>().find("output/small_variants.share-3-of-3/points.jsonl"),
            std::string::npos);

  const std::vector<std::string> merge{"-o", "all", "--merge", "one", "output/small_variants.share-3-of-3"};
  const Ended without = study(merge);
  EXPECT_EQ(without.status, 3) << without.out;
  EXPECT_NE(without.err.find("1 of 3 points are missing"), std::string::npos) << without.err;
  EXPECT_NE(without.err.find("runs: finer"), std::string::npos) << without.err;
  EXPECT_FALSE(fs::exists(folder_ / "all"));

  const Ended rest = study({"--only", "all.missing.jsonl"});
  ASSERT_EQ(rest.status, 0) << rest.err;
  std::vector<std::string> with = merge;
  with.emplace_back("output/small_variants.missing");
  const Ended whole = study(with);
  EXPECT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(Json::parse(read_text(folder_ / "all/results.json"))["variants"].size(), 3U);
}

TEST_F(Shares, ComputedAgainDoNothingAndChangeNothing) {
  const std::string before = read_text(share("1/2", "one"));
  EXPECT_EQ(read_text(share("1/2", "one")), before);
}

TEST_F(Shares, ThatAreNotFinishedCountWithWhatTheyHave) {
  const std::string text = read_text(share("1/1", "one"));
  fs::remove_all(folder_ / "one");
  // Killed in the middle of its last line.
  write_text(folder_ / "one.unfinished.jsonl", text.substr(0, text.size() - 10));
  const Ended merged = study({"--merge", "one", "-o", "all"});
  EXPECT_EQ(merged.status, 3);
  EXPECT_NE(merged.err.find("1 of 3 points are missing"), std::string::npos) << merged.err;
  EXPECT_EQ(read_text(folder_ / "one.unfinished.jsonl"), text.substr(0, text.size() - 10))
      << "a merge only reads: the share may be at work";
  share("1/1", "one");
  EXPECT_FALSE(fs::exists(folder_ / "one.unfinished.jsonl"));
  EXPECT_EQ(study({"--merge", "one", "-o", "all"}).status, 0);
}

TEST_F(Shares, OfAnotherCaseOrProgramAreRefusedByName) {
  const std::string journal = share("1/2", "one");
  expect_refused(study({"--merge", "one", "--set", "cable.elements=3"}), 3,
                 {"one/points.jsonl", "another case", "small.toml"});
  expect_refused(study({"--only", journal}), 3, {journal, "names no missing point"});
  std::string text = read_text(journal);
  text.replace(text.find("revision "), 9, "revision of old, ");
  write_text(folder_ / "old.jsonl", text);
  expect_refused(study({"--merge", "one", "old.jsonl"}), 3,
                 {"old.jsonl", "another program: revision of old"});
  fs::create_directories(folder_ / "empty");
  expect_refused(study({"--merge", "empty"}), 3, {"empty/points.jsonl", "no journal"});
  expect_refused(study({"--merge", "small.toml"}), 3, {"small.toml", "no journal"});
  expect_refused(study({"--only", "nowhere"}), 3, {"nowhere", "cannot be read"});
  expect_refused(study({"--merge", "one", "-o", "one"}), 2, {"one/points.jsonl"});
  EXPECT_TRUE(fs::exists(journal));
}

TEST_F(Shares, ThatAreNoneAreRefused) {
  for (const char* word : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "a/b", "-1/2", "1/2000000", "1.5/2"})
    for (const auto& command :
         {std::vector<std::string>{"study", "small.toml"}, {"render", "small"}, {"run", "small.toml"}}) {
      std::vector<std::string> all = command;
      all.insert(all.end(), {"--share", word});
      expect_refused(plumb_in(folder_.path(), all), 2, {std::string("--share ") + word, "K/N"});
    }
  expect_refused(plumb_in(folder_.path(), {"run", "small.toml", "--share", "1/2"}), 2, {"several cases"});
  expect_refused(study({"--share", "1/2", "--merge", "one"}), 2, {"--merge", "--share"});
}

TEST_F(Shares, OfSeveralCasesAreDealtOutWholeAndOnce) {
  std::set<std::string> done;
  for (const char* name : {"a", "b", "c"})
    write_text(folder_ / "list" / (std::string(name) + ".toml"),
               case_text("[scene]\nsize = [32, 24]\nframe_rate = 10\n"));
  for (const char* which : {"1/2", "2/2"}) {
    const Ended ended = plumb_in(folder_.path(), {"run", "list", "--share", which});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const std::string folder = fmt::format("output/list.share-{}-of-2", which[0]);
    EXPECT_TRUE(fs::exists(folder_ / folder / "index.html"));
    for (const auto& entry : fs::directory_iterator(folder_ / folder))
      if (entry.is_directory() && fs::exists(entry.path() / "run.h5")) {
        EXPECT_TRUE(done.insert(entry.path().filename()).second) << entry.path();
      }
  }
  EXPECT_EQ(done, (std::set<std::string>{"a", "b", "c"}));
  expect_refused(plumb_in(folder_.path(), {"run", "list", "--share", "7/7"}), 2, {"of 3 cases"});
}

}  // namespace shares_test
}  // namespace plumb
