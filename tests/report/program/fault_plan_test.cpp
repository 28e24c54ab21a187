#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <map>
#include <thread>

#include "engine/base/folder_survey.h"
#include "engine/base/sha256.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace fault_plan_test {

/// What is done at each call of a program that touches a file.
struct Plan {
  int error = EIO;  ///< 0: the program is killed
  bool on = false;  ///< all later calls that need room fail as well
};

/// Runs a command whose `at`-th call fails.
Ended run_with_fault(const fs::path& folder, const fs::path& below, const std::vector<std::string>& arguments,
                     int at, const Plan& plan) {
  std::vector<std::string> command{"env",
                                   "LD_PRELOAD=" PLUMB_FAULT_LIBRARY,
                                   "PLUMB_FAULT_UNDER=" + below.string() + "/",
                                   "PLUMB_FAULT_AT=" + std::to_string(at),
                                   "PLUMB_FAULT_ERROR=" + std::to_string(plan.error),
                                   "PLUMB_FAULT_ON=" + std::to_string(plan.on),
                                   "PLUMB_FAULT_LOG=" + (folder / "fault.txt").string(),
                                   PLUMB_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_command(command, folder);
}

using Files = std::map<std::string, std::string>;

/// All below a folder, by name.
Files files_below(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    files[entry.path().lexically_relative(folder).generic_string()] =
        entry.is_regular_file() ? read_text(entry.path()) : "(folder)";
  return files;
}

std::string names(const Files& files) {
  std::string text;
  for (const auto& [name, bytes] : files) text += "\n  " + name;
  return text;
}

/// A command that changes what is below a folder, tried with a fault at each of its calls in turn.
class FaultPlan : public ::testing::Test {
 protected:
  /// The folder as it is before each try.
  void start_from(const Files& files) {
    fs::remove_all(below_);
    fs::create_directories(below_);
    for (const auto& [name, bytes] : files)
      if (bytes == "(folder)")
        fs::create_directories(below_ / name);
      else
        write_text(below_ / name, bytes);
  }

  static constexpr int few = 7;

  /// Tries each `step`-th call, or all with PLUMB_FAULTS=all, and returns how many. What differs between runs
  /// (run.h5 says when it was made) is compared by the folder's own manifest.
  int try_all(const std::vector<std::string>& arguments, const Files& before, const Plan& plan,
              int step = few) {
    start_from(before);
    const Ended good = plumb_in(folder_.path(), arguments);
    EXPECT_EQ(good.status, 0) << good.err;
    const Files after = files_below(below_);
    const char* all = std::getenv("PLUMB_FAULTS");
    if (all != nullptr && std::string(all) == "all") step = 1;
    int tried = 0;
    for (int at = 1;; at += step) {
      start_from(before);
      fs::remove(folder_ / "fault.txt");
      const Ended ended = run_with_fault(folder_.path(), below_, arguments, at, plan);
      const std::string call = read_text(folder_ / "fault.txt");
      if (call.empty()) {
        EXPECT_EQ(ended.status, 0) << ended.err;
        EXPECT_GT(tried, 0) << "the plan never came to a call";
        return tried;
      }
      ++tried;
      SCOPED_TRACE("call " + std::to_string(at) + ": " + call);
      if (plan.error == 0)
        after_kill(arguments, before, after);
      else
        after_error(ended, before, after);
      if (HasFailure()) return tried;
    }
  }

  /// In memory where that can be, as each try waits for the disk.
  static fs::path quick_disk() {
    return ::access("/dev/shm", W_OK) == 0 ? fs::path("/dev/shm") : fs::temp_directory_path();
  }

  TemporaryFolder folder_{quick_disk()};
  const fs::path below_ = folder_ / "below";
  bool reads_what_it_changes_ = false;

 private:
  static bool same(const Files& a, const Files& b) {
    if (names(a) != names(b)) return false;
    for (const auto& [name, bytes] : a)
      if (bytes != b.at(name) && !name.ends_with("run.h5") && !name.ends_with("manifest.json")) return false;
    return true;
  }

  /// Everything that is listed is what the list says, and nothing else has a name of ours.
  void expect_sound(const Files& files) {
    for (const auto& [name, bytes] : files) {
      if (!name.ends_with("manifest.json") || name.find(".part-") != std::string::npos) continue;
      const fs::path folder = (below_ / name).parent_path();
      const FolderSurvey survey = look_into(folder.string(), FolderContent::copies);
      EXPECT_EQ(survey.manifest.fault, "");
      EXPECT_EQ(survey.ours.size(), survey.manifest.manifest.files.size());
      EXPECT_TRUE(survey.manifest.manifest.next.empty());
    }
  }

  void after_error(const Ended& ended, const Files& before, const Files& after) {
    const Files now = files_below(below_);
    expect_sound(now);
    if (ended.status == 0) {
      EXPECT_TRUE(same(without_empty_folders(without_leftovers(now)), without_empty_folders(after)))
          << names(now);
      return;
    }
    // What cannot be read is told from what cannot be written.
    EXPECT_TRUE(ended.status == 5 || (ended.status == 3 && reads_what_it_changes_))
        << ended.status << ended.err;
    expect_one_line(ended.err);
    EXPECT_EQ(ended.err.find(".part-"), std::string::npos) << ended.err;
    EXPECT_TRUE(same(without_leftovers(now), before)) << names(now) << "\nbefore:" << names(before);
  }

  /// What a killed program leaves, the next one clears.
  void after_kill(const std::vector<std::string>& arguments, const Files& before, const Files& after) {
    for (const auto& [name, bytes] : without_leftovers(files_below(below_))) {
      if (name.ends_with("manifest.json") || bytes == "(folder)" || name.ends_with("run.h5")) continue;
      const bool old = before.contains(name) && before.at(name) == bytes,
                 changed = after.contains(name) && after.at(name) == bytes;
      EXPECT_TRUE(old || changed) << name << " is neither the old nor the new one: " << bytes.size()
                                  << " bytes";
    }
    const Ended next = plumb_in(folder_.path(), arguments);
    EXPECT_EQ(next.status, 0) << next.err;
    const Files now = files_below(below_);
    expect_sound(now);
    EXPECT_TRUE(same(without_empty_folders(now), without_empty_folders(after)))
        << names(now) << "\nafter:" << names(after);
  }

  /// A folder that is empty but for the killing of a program loses nothing.
  static Files without_empty_folders(Files files) {
    std::erase_if(files, [](const auto& file) { return file.second == "(folder)"; });
    return files;
  }

  static Files without_leftovers(Files files) {
    std::erase_if(files, [](const auto& file) { return file.first.find(".part-") != std::string::npos; });
    return files;
  }
};

/// A comparison of two folders that makes the second the baseline.
class AcceptedBaseline : public FaultPlan {
 protected:
  AcceptedBaseline() { reads_what_it_changes_ = true; }
  /// Puts the first baseline in place as the program does, with more files beside.
  Files baseline(const Files& beside) {
    start_from({});
    write_text(folder_ / "b/x.csv", "t,x\n0,1\n");
    write_text(folder_ / "b/frames/0000.csv", "t,x\n0,3\n");
    write_text(folder_ / "b/gone/y.csv", "t,x\n0,5\n");
    const Ended made = plumb_in(folder_.path(), accept_);
    EXPECT_EQ(made.status, 0) << made.err;
    for (const auto& [name, bytes] : beside) write_text(below_ / name, bytes);
    fs::remove_all(folder_ / "b/gone");
    write_text(folder_ / "b/x.csv", "t,x\n0,2\n");
    write_text(folder_ / "b/new/z.csv", "t,x\n0,7\n");
    return files_below(below_);
  }
  const std::vector<std::string> accept_{"diff", "below/a", "b", "--accept", "--quiet"};
};

TEST_F(AcceptedBaseline, IsOldOrNewWhicheverCallFails) {
  EXPECT_GT(try_all(accept_, baseline({}), {.error = EIO}), 150 / few);
}

TEST_F(AcceptedBaseline, IsOldOrNewOnADiskThatIsFullFromAnyCallOn) {
  try_all(accept_, baseline({}), {.error = ENOSPC, .on = true});
}

TEST_F(AcceptedBaseline, BesideFilesOfOthersIsOldOrNewWhicheverCallFails) {
  EXPECT_GT(
      try_all(accept_, baseline({{"a/thesis.txt", "years"}, {"a/frames/mine.txt", "more"}}), {.error = EIO}),
      180 / few);
}

TEST_F(AcceptedBaseline, BesideFilesOfOthersIsOldOrNewOnADiskThatIsFullFromAnyCallOn) {
  try_all(accept_, baseline({{"a/thesis.txt", "years"}}), {.error = ENOSPC, .on = true});
}

TEST_F(AcceptedBaseline, IsMadeWholeByTheNextCommandWhereverOneIsKilled) {
  try_all(accept_, baseline({}), {.error = 0});
}

TEST_F(AcceptedBaseline, BesideFilesOfOthersIsMadeWholeByTheNextCommandWhereverOneIsKilled) {
  try_all(accept_, baseline({{"a/thesis.txt", "years"}, {"a/frames/mine.txt", "more"}}), {.error = 0});
}

class SolvedCase : public FaultPlan {
 protected:
  Files solved(const Files& beside) {
    start_from({});
    const std::vector<std::string> earlier{
        "solve", case_path("pendulum.toml"), "--quiet", "-o", "below/a", "--set", "time.end=0.02"};
    EXPECT_EQ(plumb_in(folder_.path(), earlier).status, 0);
    for (const auto& [name, bytes] : beside) write_text(below_ / name, bytes);
    return files_below(below_);
  }
  const std::vector<std::string> solve_{
      "solve", case_path("pendulum.toml"), "--quiet", "-o", "below/a", "--set", "time.end=0.04"};
  static constexpr int fewer = 11;
};

TEST_F(SolvedCase, IsOldOrNewWhicheverCallFails) {
  try_all(solve_, solved({}), {.error = EIO}, fewer);
}

TEST_F(SolvedCase, BesideFilesOfOthersIsOldOrNewWhicheverCallFails) {
  try_all(solve_, solved({{"a/notes/day.txt", "sunny"}}), {.error = EIO}, fewer);
}

TEST_F(SolvedCase, IsMadeWholeByTheNextCommandWhereverOneIsKilled) {
  try_all(solve_, solved({}), {.error = 0}, fewer);
}

TEST_F(SolvedCase, AsOneFileIsOldOrNewWhicheverCallFailsAndWhereverOneIsKilled) {
  const Files before{{"out.csv", "earlier"}};
  const std::vector<std::string> csv{
      "solve", case_path("pendulum.toml"), "--quiet", "--csv", "below/out.csv", "--set", "time.end=0.02"};
  try_all(csv, before, {.error = EIO});
  try_all(csv, before, {.error = 0});
}

TEST(FaultPlanOfThreads, AThreadThatTheRendererCannotStartIsSaidAndNotWaitedFor) {
  const unsigned threads = std::min(16U, std::thread::hardware_concurrency());
  if (threads < 2) GTEST_SKIP() << "it draws without threads";
  const TemporaryFolder folder;
  // One watches for signals, and as many as the renderer starts are tried first.
  const Ended ended =
      run_command({"timeout", "60", "env", "LD_PRELOAD=" PLUMB_FAULT_LIBRARY, "PLUMB_GL=osmesa",
                   fmt::format("PLUMB_FAULT_THREAD={}", 1 + threads + 1), PLUMB_PROGRAM, "doctor"},
                  folder.path());
  EXPECT_EQ(ended.status, 5) << ended.err;
  expect_one_line(ended.err);
  EXPECT_NE(ended.err.find(fmt::format("of the {} threads of the renderer could be", threads)),
            std::string::npos)
      << ended.err;
}

}  // namespace fault_plan_test
}  // namespace plumb
