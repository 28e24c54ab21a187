#include <sys/mount.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/report/program.h"

namespace plumb {
namespace {

struct Fault {
  std::vector<std::string> arguments;
  int status;
  std::string says;
};

TEST(ProgramFaults, EachEndsWithOneLineAndItsStatus) {
  const TemporaryFolder folder;
  const std::string good = case_path("pendulum.toml");
  write_text(folder / "half.toml", read_text(good).substr(0, 700));
  write_text(folder / "not_a_run.h5", "hello");
  write_text(folder / "mine/thesis.tex", "years of work");
  write_text(folder / "plain", "a file");
  const Fault faults[] = {
      {{}, 2, "plumb --help"},
      {{"rnu", good}, 2, "'rnu' is no verb; did you mean \"run\"?"},
      {{"run"}, 2, "CASE"},
      {{"run", good, "--jsno"}, 2, "--jsno"},
      {{"run", good, good}, 2, good},
      {{"solve", good, "--json", "--csv", "-"}, 2, "standard output"},
      {{"run", good, "--set", "cable.elements"}, 2, "cable.elements"},
      {{"run", "nothing.toml"}, 3, "nothing.toml: "},
      {{"run", "half.toml"}, 3, "half.toml:"},
      {{"run", good, "--set", "cable.elements=0"}, 3, "--set cable.elements=0: must be"},
      {{"run", good, "--set", "cable.elemnts=4"}, 3, "did you mean \"elements\"?"},
      {{"check", good, "--set", "method.name=rk5"}, 3, "did you mean \"rk4\"?"},
      {{"report", "nothing"}, 3, "nothing: there is no such run file"},
      {{"report", "not_a_run.h5"},
       3,
       "not_a_run.h5: cannot be used: it is no HDF5 file, or it was cut short"},
      {{"render", good}, 3, "cannot be used"},
      {{"run", good, "-o", "mine"}, 5, "it has no run.h5"},
      {{"run", good, "-o", "plain"}, 5, "plain: cannot be written"},
      {{"run", good, "-o", "plain/below"}, 5, "cannot be written"},
      {{"run", good, "-o", "/proc/plumb"}, 5, "/proc/plumb: cannot be written"},
      {{"solve", good, "--quiet", "--csv", "/nowhere/out.csv", "--set", "time.end=0.02"},
       5,
       "/nowhere/out.csv: cannot be written"},
  };
  for (const Fault& fault : faults) {
    const Ended ended = plumb_in(folder.path(), fault.arguments);
    EXPECT_EQ(ended.status, fault.status) << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(fault.says), std::string::npos)
        << "'" << fault.says << "' is not in: " << ended.err;
  }
  EXPECT_EQ(read_text(folder / "mine/thesis.tex"), "years of work");
  EXPECT_FALSE(fs::exists(folder / "output")) << "nothing may be left half written";
}

TEST(ProgramFaults, RunFileCutAnywhereIsRefused) {
  const TemporaryFolder folder;
  ASSERT_EQ(plumb_in(folder.path(), {"solve", case_path("pendulum.toml"), "-o", "a", "--set", "time.end=0.1"})
                .status,
            0);
  const std::string whole = read_text(folder / "a/run.h5");
  for (const double share : {0.0, 0.01, 0.1, 0.5, 0.9, 0.99}) {
    const auto kept = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    write_text(folder / "a/run.h5", whole.substr(0, kept));
    const Ended ended = plumb_in(folder.path(), {"report", "a"});
    EXPECT_EQ(ended.status, 3) << "cut to " << kept << " of " << whole.size() << " bytes: " << ended.err;
    expect_one_line(ended.err);
    EXPECT_FALSE(fs::exists(folder / "a/index.html"));
  }
}

TEST(ProgramFaults, InterruptedRunLeavesTheEarlierOutputAsItWas) {
  const TemporaryFolder folder;
  const std::string good = case_path("pendulum.toml");
  ASSERT_EQ(plumb_in(folder.path(), {"solve", good, "-o", "a", "--set", "time.end=0.02"}).status, 0);
  const std::string before = read_text(folder / "a/probes.csv");
  for (const int signal : {SIGINT, SIGTERM}) {
    // A run that would take minutes.
    const pid_t child = start(
        {PLUMB_PROGRAM, "run", good, "-o", "a", "--set", "method.name=rk4", "--set", "method.step=1e-8"},
        folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ::kill(child, signal);
    const Ended ended = finish(child, folder.path());
    EXPECT_EQ(ended.status, 130) << ended.err;
    EXPECT_NE(ended.err.find("plumb: interrupted\n"), std::string::npos) << ended.err;
    EXPECT_EQ(read_text(folder / "a/probes.csv"), before);
    int entries = 0;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      entries += entry.path().filename().string().find("part") != std::string::npos;
    EXPECT_EQ(entries, 0) << "a temporary folder was left behind";
  }
}

TEST(ProgramFaults, FullDiskEndsWithFiveAndLeavesTheEarlierOutputAsItWas) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "small");
  const std::string good = case_path("pendulum.toml");
  // Big enough for an earlier solve and the run file of the next, too small for its pictures.
  const std::string script =
      "mount -t tmpfs -o size=600k plumb-test small && " + std::string(PLUMB_PROGRAM) + " solve " + good +
      " -o small/a --set time.end=0.02 --quiet && cp small/a/probes.csv before.csv && " + PLUMB_PROGRAM +
      " run " + good +
      " -o small/a --quiet 2>error.txt; echo $? >status.txt; cp small/a/probes.csv after.csv; ls -A small "
      ">left.txt";
  const Ended ended =
      run_command({"unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script}, folder.path());
  if (!fs::exists(folder / "before.csv"))
    GTEST_SKIP() << "a small file system cannot be mounted here: " << ended.err;
  EXPECT_EQ(read_text(folder / "status.txt"), "5\n");
  const std::string error = read_text(folder / "error.txt");
  expect_one_line(error);
  EXPECT_NE(error.find("No space left on device"), std::string::npos) << error;
  EXPECT_EQ(read_text(folder / "after.csv"), read_text(folder / "before.csv"));
  EXPECT_EQ(read_text(folder / "left.txt"), "a\n");
}

}  // namespace
}  // namespace plumb
