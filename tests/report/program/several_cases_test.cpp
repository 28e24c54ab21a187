#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/report/program/program.h"

namespace plumb {
namespace several_cases_test {

using Json = nlohmann::json;

std::string tiny_case() {
  std::string text = read_text(fs::path(PLUMB_SOURCE_DIR) / "tests/data/small_case.toml");
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"size = [640, 480]", "size = [32, 24]"},
                                 {"frame_rate = 10", "frame_rate = 0.5"},
                                 {"supersampling = 2", "supersampling = 1"}})
    text.replace(text.find(from), from.size(), to);
  const std::size_t begin = text.find("[[figure]]");
  return text.erase(begin, text.find("[scene]") - begin);
}

/// Of those that a run of its own may have otherwise.
Json without_times(Json document) {
  for (const char* key : {"seconds", "check_sum", "last_run", "history"}) document.erase(key);
  document["provenance"].erase("made at");
  document["solve"].erase("solve_seconds");
  return document;
}

/// A folder of three cases: one that is held against nothing, one that misses its criteria, and one whose
/// integration fails.
void write_cases(const fs::path& folder) {
  const std::string text = tiny_case();
  write_text(folder / "references/small_reference.toml",
             read_text(fs::path(PLUMB_SOURCE_DIR) / "tests/data/small_reference.toml"));
  const auto write = [&](const char* name, std::vector<std::pair<std::string, std::string>> changes) {
    std::string own = text;
    changes.emplace_back("small_reference", "references/small_reference");
    for (const auto& [from, to] : changes)
      if (const std::size_t at = own.find(from); at != std::string::npos) own.replace(at, from.size(), to);
    write_text(folder / (std::string(name) + ".toml"), own);
  };
  const std::size_t begin = text.find("[[reference]]");
  write("free", {{text.substr(begin, text.find("[scene]") - begin), ""}});
  write("missed", {});
  write("unstable", {{"\"generalized-alpha\"", "\"rk4\""},
                     {"step = 1e-3", "step = 0.02"},
                     {"spectral_radius = 0.9\n", ""},
                     {"newton_iterations = 15\n", ""}});
}

bool holds_unfinished(const fs::path& folder) {
  for (const auto& item : fs::directory_iterator(folder))
    if (item.path().filename().string().find(".part-") != std::string::npos) return true;
  return false;
}

class SeveralCases : public ::testing::Test {
 protected:
  SeveralCases() { write_cases(folder_ / "set"); }

  Ended plumb(const std::vector<std::string>& arguments) { return plumb_in(folder_.path(), arguments); }
  Json results(const std::string& name) { return Json::parse(read_text(folder_ / (name + "/results.json"))); }

  TemporaryFolder folder_;
};

TEST_F(SeveralCases, EndAsTheWorstOfThemAndGiveWhatEachGivesAlone) {
  const Ended ended = plumb({"run", "set", "--history", "h.jsonl"});
  EXPECT_EQ(ended.status, 4) << ended.out << ended.err;
  std::map<std::string, int> statuses;
  const Json index = results("output/set");
  for (const Json& report : index.at("reports"))
    statuses[report.at("folder")] = report.at("exit_status").get<int>();
  EXPECT_EQ(statuses, (std::map<std::string, int>{{"free", 0}, {"missed", 1}, {"unstable", 4}}));
  for (const char* said : {"exit 0  free", "exit 1  missed", "exit 4  unstable"})
    EXPECT_NE(ended.out.find(said), std::string::npos) << said << "\n" << ended.out;
  const std::string history = read_text(folder_ / "h.jsonl");
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 3) << history;

  EXPECT_EQ(plumb({"run", "set/missed.toml", "-o", "alone", "--history", "h.jsonl"}).status, 1);
  const Json together = without_times(results("output/set/missed")), alone = results("alone");
  EXPECT_EQ(alone.at("history").at("runs").size(), 2U);
  EXPECT_TRUE(together == without_times(alone)) << Json::diff(together, without_times(alone)).dump(1);
}

TEST_F(SeveralCases, OneThatIsKilledLosesItselfAlone) {
  const pid_t all = start({PLUMB_PROGRAM, "run", "set/free.toml", "set/missed.toml", "-o", "all", "--json"},
                          folder_.path());
  ASSERT_GT(all, 0);
  const auto find = [&]() -> pid_t {
    for (const auto& process : fs::directory_iterator("/proc")) {
      const std::string words = read_text(process.path() / "cmdline"),
                        parent = read_text(process.path() / "stat");
      if (words.find(std::string("all/missed") + '\0') != std::string::npos &&
          parent.find(" " + std::to_string(all) + " ") != std::string::npos)
        return std::stoi(process.path().filename());
    }
    return -1;
  };
  pid_t one = -1;
  for (int k = 0; k < 12000 && one < 0; ++k) {
    one = find();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_GT(one, 0);
  ::kill(one, SIGSEGV);
  const Ended ended = finish(all, folder_.path());
  EXPECT_EQ(ended.status, 5) << ended.err;
  EXPECT_EQ(Json::parse(ended.out), results("all"));
  const Json reports = results("all").at("reports");
  ASSERT_EQ(reports.size(), 2U);
  std::map<std::string, std::string> states;
  for (const Json& report : reports) states[report.at("folder")] = report.at("outcome_reason");
  EXPECT_EQ(states.at("missed"), "crashed (signal 11)");
  EXPECT_EQ(states.at("free"), "not held against anything");
  EXPECT_TRUE(fs::exists(folder_ / "all/free/index.html"));
  EXPECT_FALSE(fs::exists(folder_ / "all/missed/index.html"));
}

TEST_F(SeveralCases, ThatAreInterruptedLeaveWhatIsDoneAndNothingHalf) {
  const pid_t all =
      start({PLUMB_PROGRAM, "run", "set", "-o", "all", "--set", "scene.frame_rate=5"}, folder_.path());
  ASSERT_GT(all, 0);
  const auto ended_one = [&] { return read_text(folder_ / "stdout").find("1 of 3") != std::string::npos; };
  for (int k = 0; k < 12000 && !ended_one(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ::kill(all, SIGTERM);
  const Ended ended = finish(all, folder_.path());
  EXPECT_EQ(ended.status, 130) << ended.out << ended.err;
  int whole = 0;
  for (const char* name : {"all/free", "all/missed", "all/unstable"}) {
    whole += fs::exists(folder_ / (std::string(name) + "/index.html")) ? 1 : 0;
    EXPECT_EQ(fs::exists(folder_ / name), fs::exists(folder_ / (std::string(name) + "/manifest.json")))
        << name;
  }
  EXPECT_GE(whole, 1);
  EXPECT_LT(whole, 3) << "nothing was under way any more";
  EXPECT_FALSE(holds_unfinished(folder_ / "all"));
  EXPECT_FALSE(fs::exists(folder_ / "all/index.html"));
  EXPECT_NE(ended.err.find("of 3 cases are done"), std::string::npos) << ended.err;
}

TEST_F(SeveralCases, SayEveryFaultBeforeAnyIsRun) {
  write_text(folder_ / "set/wrong.toml", "title = 3");
  write_text(folder_ / "also.toml", "x");
  write_text(folder_ / "other/free.toml", read_text(folder_ / "set/free.toml"));
  const Ended ended = plumb({"run", "set", "also.toml", "other"});
  EXPECT_EQ(ended.status, 3) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 3) << ended.err;
  for (const char* said : {"plumb: set/wrong.toml:1:9: title = 3", "plumb: also.toml:1:",
                           "set/free.toml and other/free.toml would both be written to output/free"})
    EXPECT_NE(ended.err.find(said), std::string::npos) << said << "\n" << ended.err;
  // What is wrong with all of them alike is said once.
  expect_one_line(plumb({"run", "set/free.toml", "set/missed.toml", "--set", "cable.elements=0"}).err);
  EXPECT_FALSE(fs::exists(folder_ / "output"));
}

TEST_F(SeveralCases, RefuseByNameWhatIsForOne) {
  write_text(folder_ / "other.jsonl", "[]\n");
  fs::create_directory(folder_ / "empty");
  const auto expect_refused = [&](std::vector<std::string> options, int status, const std::string& said) {
    options.insert(options.begin(), {"run", "set"});
    const Ended ended = plumb(options);
    EXPECT_EQ(ended.status, status) << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
  };
  expect_refused({"--baseline", "x"}, 2, "--baseline is for one case");
  expect_refused({"--explain"}, 2, "--explain is for one case");
  expect_refused({"--history", "other.jsonl"}, 3, "other.jsonl: is no history of Plumb's");
  expect_refused({"--limit", "time=1ms"}, 2, "time=1ms");
  expect_refused({"empty"}, 3, "empty: there is no case (*.toml) in this folder");
  expect_refused({"--limit", "disk=5MB"}, 3, "3 cases: would take some");
  EXPECT_EQ(read_text(folder_ / "other.jsonl"), "[]\n");
  EXPECT_FALSE(fs::exists(folder_ / "output"));
}

TEST_F(SeveralCases, AreFoundInAFolderOfCasesByItsName) {
  const auto refused = [&](const std::string& name) {
    return plumb({"run", name, "--limit", "disk=1kB"}).err;
  };
  write_cases(folder_ / "cases/of_mine");
  EXPECT_NE(refused("of_mine").find("plumb: cases/of_mine/free.toml: would take"), std::string::npos)
      << refused("of_mine");
  // Those that came with the program go before it, and what is there itself before those.
  write_cases(folder_ / "cases/economy");
  EXPECT_NE(refused("economy").find("/cases/economy/rod.toml: would take"), std::string::npos)
      << refused("economy");
  write_cases(folder_ / "economy");
  EXPECT_NE(refused("economy").find("plumb: economy/free.toml: would take"), std::string::npos)
      << refused("economy");
}

}  // namespace several_cases_test
}  // namespace plumb
