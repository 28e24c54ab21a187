#include <sys/mount.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/report/program/program.h"

namespace plumb {
namespace program_faults_test {

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
  fs::create_symlink("nowhere", folder / "to_nothing");
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
      {{"report", "nothing"}, 3, "nothing: cannot be used: No such file or directory"},
      {{"report", "not_a_run.h5"}, 3, "not_a_run.h5: cannot be used: it is no run file, or it was cut short"},
      {{"render", good}, 3, "cannot be used"},
      {{"report", "not_a_run.h5\nsecond line"}, 3, "cannot be used"},
      {{"report", "/proc/1/root/nothing/run.h5"}, 3, "cannot be used"},
      {{"run", good, "--set", "figure.0.name=energy"}, 3, "is the name of a figure that every run has"},
      {{"run", good, "--set", "figure.0.name=strain_map"}, 3, "is the name of a figure that every run has"},
      {{"run", good, "--set", "scene.frame_rate=0.001"}, 3, "scene.frame_rate"},
      {{"run", good, "--set", "scene.size=[20000,20000]"}, 3, "scene.size"},
      {{"run", good, "-o", "mine"}, 5, "mine: cannot be written: it holds thesis.tex and no manifest.json"},
      {{"run", good, "-o", "/proc"}, 5, "cannot be written"},
      {{"run", good, "-o", "to_nothing"}, 5, "it is a link to nothing"},
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

/// Waits until a temporary folder shows that a run is at work.
bool wait_for_part(const fs::path& folder) {
  for (int i = 0; i < 3000; ++i) {
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().find(".part-") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
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
    ASSERT_TRUE(wait_for_part(folder.path())) << "the run never began to write";
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

TEST(ProgramFaults, DamagedRunFileIsRefused) {
  const TemporaryFolder folder;
  ASSERT_EQ(plumb_in(folder.path(),
                     {"solve", case_path("pendulum.toml"), "-o", "a", "--quiet", "--set", "time.end=0.1"})
                .status,
            0);
  const std::string whole = read_text(folder / "a/run.h5");
  for (std::size_t k = 1; k < 20; ++k) {
    std::string damaged = whole;
    damaged[k * whole.size() / 20] ^= 0x10;
    write_text(folder / "a/run.h5", damaged);
    const Ended ended = plumb_in(folder.path(), {"report", "a"});
    EXPECT_EQ(ended.status, 3) << "byte " << k * whole.size() / 20 << ": " << ended.err;
    expect_one_line(ended.err);
  }
}

TEST(ProgramFaults, OutputThatCannotBeWrittenIsNoSuccess) {
  const TemporaryFolder folder;
  const std::string plumb = std::string(PLUMB_PROGRAM) + " ", good = case_path("pendulum.toml");
  for (const std::string& arguments :
       {"check " + good + " --json", "check " + good, "solve " + good + " --quiet --csv -",
        "solve " + good + " --quiet --json --set time.end=0.02", std::string("doctor --json"),
        std::string("--help"), std::string("--version"), std::string("diff --json stdout stdout")}) {
    const Ended ended = run_command({"sh", "-c", plumb + arguments + " >/dev/full"}, folder.path());
    EXPECT_EQ(ended.status, 5) << arguments;
    EXPECT_NE(ended.err.find("standard output: cannot be written"), std::string::npos) << ended.err;
  }
}

TEST(ProgramFaults, CsvThatCannotBeWrittenLeavesTheEarlierFileAsItWas) {
  const TemporaryFolder folder;
  write_text(folder / "out.csv", "earlier");
  const std::string script = "ulimit -f 1; exec " + std::string(PLUMB_PROGRAM) + " solve " +
                             case_path("pendulum.toml") + " --quiet --csv out.csv";
  const Ended ended = run_command({"sh", "-c", script}, folder.path());
  EXPECT_EQ(ended.status, 5) << ended.err;
  EXPECT_EQ(read_text(folder / "out.csv"), "earlier");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 3) << "out.csv, stdout and stderr";
}

TEST(ProgramFaults, LinkToAnOutputFolderIsFollowed) {
  const TemporaryFolder folder;
  ASSERT_EQ(plumb_in(folder.path(),
                     {"solve", case_path("pendulum.toml"), "-o", "run1", "--quiet", "--set", "time.end=0.1"})
                .status,
            0);
  fs::create_directory_symlink("run1", folder / "latest");
  ASSERT_EQ(plumb_in(folder.path(), {"solve", case_path("pendulum.toml"), "-o", "latest", "--quiet", "--set",
                                     "time.end=0.2"})
                .status,
            0);
  EXPECT_TRUE(fs::is_symlink(folder / "latest"));
  EXPECT_NE(read_text(folder / "run1/probes.csv").find("\n0.2"), std::string::npos);
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
  Ended ended =
      run_command({"unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script}, folder.path());
  // Where that is not allowed, root may do without a user namespace.
  if (!fs::exists(folder / "before.csv"))
    ended = run_command({"unshare", "--mount", "sh", "-c", script}, folder.path());
  if (!fs::exists(folder / "before.csv"))
    GTEST_SKIP() << "a small file system cannot be mounted here: " << ended.err;
  EXPECT_EQ(read_text(folder / "status.txt"), "5\n");
  const std::string error = read_text(folder / "error.txt");
  expect_one_line(error);
  EXPECT_NE(error.find("what is free on the disk"), std::string::npos) << error;
  EXPECT_EQ(read_text(folder / "after.csv"), read_text(folder / "before.csv"));
  EXPECT_EQ(read_text(folder / "left.txt"), "a\n");
}

}  // namespace program_faults_test
}  // namespace plumb
