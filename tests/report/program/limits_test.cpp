#include "report/program/limits.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <limits>

#include "engine/base/errors.h"
#include "engine/case/case_source.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace limits_test {

Estimate estimate_of(Resource resource, double amount) {
  Estimate made;
  made.parts.push_back({resource, "", "states: 2 outputs × 3 nodes", "cable.elements", amount});
  return made;
}

std::string refusal(double wanted, double allowed) {
  try {
    refuse_beyond(estimate_of(Resource::memory, wanted), {{Resource::memory, allowed, "--limit"}}, "a.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Limits, AreThemselvesAllowedAndNothingBeyondThem) {
  EXPECT_EQ(refusal(2e9, 2e9), "");
  EXPECT_NE(refusal(std::nextafter(2e9, 3e9), 2e9), "");
  EXPECT_EQ(refusal(0, 0), "");
}

TEST(Limits, RefuseWhatOverflowsOrIsNoNumber) {
  EXPECT_NE(refusal(std::numeric_limits<double>::infinity(), 1e300), "");
  EXPECT_NE(refusal(std::numeric_limits<double>::quiet_NaN(), 1e300), "");
}

TEST(Limits, NameTheFiguresAndTheKeysToChange) {
  EXPECT_EQ(
      refusal(3e9, 2e9),
      "a.toml: would take some 3 GB of memory, more than --limit, 2 GB; most of it: states: 2 outputs × 3 "
      "nodes (3 GB); less with other cable.elements");
}

TEST(Limits, CountWhatIsOnlyMappedWhereTheAddressSpaceIsLimited) {
  Estimate made = estimate_of(Resource::memory, 100);
  made.drawing_address_space = 50;
  EXPECT_NO_THROW(refuse_beyond(made, {{Resource::memory, 149, "the machine"}}, "a.toml"));
  EXPECT_NO_THROW(refuse_beyond(made, {{Resource::memory, 150, "ulimit -v", true}}, "a.toml"));
  EXPECT_THROW(refuse_beyond(made, {{Resource::memory, 149, "ulimit -v", true}}, "a.toml"), InputError);
}

TEST(Limits, AreReadWithTheirUnits) {
  const std::vector<Bound> bounds = asked_bounds({"memory=2GB,disk=1.5TB", "time=30min"});
  ASSERT_EQ(bounds.size(), 3U);
  EXPECT_EQ(bounds[0].amount, 2e9);
  EXPECT_EQ(bounds[1].amount, 1.5e12);
  EXPECT_EQ(bounds[2].amount, 1800);
  EXPECT_EQ(bounds[2].resource, Resource::time);
  for (const char* wrong :
       {"", "memory", "memory=", "memory=2", "memory=GB", "memory=-1GB", "memory=0GB", "memory=nanGB",
        "memory=infGB", "memory=1e400GB", "memory=1 GB", "memory=1gb", "memory=1h", "time=1GB", "room=1GB",
        "memory=1GB,", ",memory=1GB", "memory=1GB,memory=2GB", "memory=1GB;disk=2GB"})
    EXPECT_THROW(asked_bounds({wrong}), UsageError) << wrong;
  EXPECT_THROW(asked_bounds({"time=1h", "time=2h"}), UsageError);
}

TEST(Limits, OfThisMachineAreKnown) {
  bool memory = false, disk = false;
  for (const Bound& bound : machine_bounds("not/there/yet")) {
    memory = memory || (bound.resource == Resource::memory && bound.amount > 1e7);
    disk = disk || bound.resource == Resource::disk;
    EXPECT_GE(bound.amount, 0) << bound.source;
  }
  EXPECT_TRUE(memory);
  EXPECT_TRUE(disk);
}

class LimitedProgram : public ::testing::Test {
 protected:
  void SetUp() override { write_text(folder_ / "a.toml", made_case); }

  Ended plumb(const std::string& arguments, const std::string& before = "") {
    return run_command({"sh", "-c", before + " exec " + PLUMB_PROGRAM + " " + arguments}, folder_.path());
  }
  /// Nothing but the case and what the program said.
  void expect_nothing_left() const {
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 3);
  }

  TemporaryFolder folder_;

 private:
  static constexpr const char* made_case = R"(title = "Limited"
[cable]
length = 1.0
area = 1.6e-3
density = 8000
youngs_modulus = 1.6e6
elements = 8
[supports]
first = "pinned"
[loads]
gravity = [0, -9.81, 0]
[method]
name = "rk4"
step = 1e-4
[time]
end = 0.01
output_interval = 1e-3
[[probe]]
name = "tip"
at = 1
[scene]
size = [64, 48]
)";
};

TEST_F(LimitedProgram, RefusesBeforeAnyWorkWhatIsBeyondThem) {
  for (const std::string arguments :
       {"run a.toml --limit memory=1MB", "solve a.toml --limit disk=1kB", "study a.toml --limit time=1s",
        "check a.toml --limit memory=1MB",
        "run a.toml --set cable.elements=1000000 --set time.output_interval=2e-8",
        "solve a.toml --set method.step=1e-10 --limit time=1min"}) {
    const Ended ended = plumb(arguments + " --quiet");
    EXPECT_EQ(ended.status, 3) << arguments << ": " << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find("would take some"), std::string::npos) << ended.err;
    expect_nothing_left();
  }
  EXPECT_EQ(plumb("check a.toml --limit memory=2GB,disk=1GB,time=1h").status, 0);
}

TEST_F(LimitedProgram, CheckShowsTheEstimate) {
  const Ended ended = plumb("check a.toml");
  for (const char* said : {"memory: some", "disk: some", "time: some", "run.h5: 12 outputs × 9 nodes"})
    EXPECT_NE(ended.out.find(said), std::string::npos) << ended.out;
}

TEST_F(LimitedProgram, RefusesValuesOfOptionsThatMeanNothing) {
  ASSERT_EQ(plumb("solve a.toml -o run --quiet").status, 0);
  for (const std::string arguments : {"render run --size 0x0",
                                      "render run --size 1e9x1",
                                      "render run --size -1x5",
                                      "render run --size 20000x20000",
                                      "render run --size ''",
                                      "render run --frames 0:99",
                                      "render run --frames 99",
                                      "render run --frames 1:0",
                                      "render run --frames ''",
                                      "render run --camera tpo",
                                      "render run --camera ''",
                                      "render run -o ''",
                                      "render run --video ''",
                                      "render run --size 64x64 --size 32x32",
                                      "solve a.toml --csv ''",
                                      "solve a.toml -o ''",
                                      "solve a.toml -o -",
                                      "run a.toml -o -",
                                      "report run -o -",
                                      "run a.toml --baseline ''",
                                      "run ''",
                                      "run a.toml --numbers 1",
                                      "run a.toml --baseline run --numbers nan",
                                      "diff run run --numbers inf",
                                      "diff run run --numbers -1",
                                      "diff run run --density nan",
                                      "diff run run --density 1.1",
                                      "diff run run --channel 256",
                                      "diff run run --channel -1",
                                      "diff run run --channel 1.5",
                                      "diff run run --html ''",
                                      "report --from ''",
                                      "study a.toml ''",
                                      "check a.toml --limit ''",
                                      "check a.toml --limit memory=1",
                                      "solve a.toml --csv - --json"}) {
    const Ended ended = plumb(arguments + " --quiet");
    EXPECT_EQ(ended.status, 2) << arguments << ": " << ended.err;
    expect_one_line(ended.err);
    EXPECT_EQ(ended.err.find("--set"), std::string::npos) << "an option that nobody typed: " << ended.err;
  }
}

TEST_F(LimitedProgram, RefusesWhatIsWrongInTheEnvironmentWhereItMatters) {
  for (const char* wrong :
       {"PLUMB_GL=osmesaa", "PLUMB_GL=egl:", "PLUMB_GL=EGL", "LP_NATIVE_VECTOR_WIDTH=512"}) {
    const Ended refused = plumb("run a.toml -o out --quiet", wrong);
    EXPECT_EQ(refused.status, 2) << wrong << ": " << refused.err;
    expect_one_line(refused.err);
    EXPECT_NE(refused.err.find(wrong), std::string::npos) << refused.err;
    const Ended remarked = plumb("check a.toml", wrong);
    EXPECT_EQ(remarked.status, 0) << wrong;
    EXPECT_NE(remarked.err.find(std::string("note: ") + wrong), std::string::npos) << remarked.err;
  }
  EXPECT_NE(plumb("run a.toml -o out", "PLUMB_GL=osmesaa").err.find("did you mean \"osmesa\"?"),
            std::string::npos);
  EXPECT_NE(plumb("check a.toml", "PLUMB_LG=egl").err.find("did you mean PLUMB_GL?"), std::string::npos);
}

TEST_F(LimitedProgram, NamesALimitOfTheProcessThatIsTooLowForAnyCase) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer needs more address space than there is";
#endif
  for (const std::string limit :
       {"-d 5000", "-d 20000", "-d 60000", "-s 32", "-s 64", "-s 512", "-v 100000", "-v 256000"})
    for (const std::string arguments :
         {"run a.toml -o out --quiet", "doctor --quiet", "check a.toml --quiet"}) {
      if (arguments[0] == 'c' && limit == "-v 256000") continue;  // which draws nothing
      const Ended ended = plumb(arguments, "ulimit " + limit + ";");
      EXPECT_EQ(ended.status, 5) << arguments << " with " << limit << ": " << ended.err;
      expect_one_line(ended.err);
      EXPECT_NE(ended.err.find("ulimit " + limit.substr(0, 2)), std::string::npos) << ended.err;
      expect_nothing_left();
    }
}

TEST_F(LimitedProgram, TakesNoFileOfItsOwnForOneThatIsClosed) {
  for (const std::string closed : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    const bool says = closed.find(">&-") == std::string::npos || closed == "2>&-";
    EXPECT_EQ(plumb("solve a.toml -o out " + closed).status, says ? 0 : 5) << closed;
    const std::string run = read_text(folder_ / "out/run.h5");
    EXPECT_TRUE(run.starts_with("\x89HDF")) << closed << ": " << run.substr(0, 60);
    EXPECT_EQ(plumb("solve no.toml -o out --csv t.csv " + closed).status, 3) << closed;
    fs::remove_all(folder_ / "out");
    expect_nothing_left();
  }
}

TEST_F(LimitedProgram, EndsInOneLineWithAnyLimitOfItsAddressSpace) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer needs more address space than there is";
#endif
  for (int megabytes = 50; megabytes < 4000; megabytes += megabytes / 3)
    for (const char* verb : {"solve", "run"}) {
      // Below some 800 MB nothing is drawn, which is known before any work.
      if (verb == std::string("run") && megabytes > 700) continue;
      const Ended ended =
          plumb(fmt::format("{} a.toml -o out --quiet", verb), fmt::format("ulimit -v {}000;", megabytes));
      EXPECT_LE(ended.status, 5) << verb << " with " << megabytes << " MB: " << ended.err;
      EXPECT_LE(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
      EXPECT_EQ(ended.err.empty(), ended.status == 0) << ended.err;
      EXPECT_EQ(fs::exists(folder_ / "out"), ended.status == 0);
      fs::remove_all(folder_ / "out");
      expect_nothing_left();
    }
}

/// Peak memory of a command, bytes.
double peak_memory(const std::vector<std::string>& command, const fs::path& folder) {
  const pid_t child = start(command, folder);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << read_text(folder / "stderr");
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

TEST_F(LimitedProgram, TakesTheMemoryThatIsEstimatedWithinAFactorOfTwo) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer takes memory of its own";
#endif
  struct Tried {
    const char* method;
    int elements, outputs;
  };
  // Steps so short that every run completes.
  constexpr double step = 1e-9;
  for (const Tried& tried : {Tried{"rk4", 8, 1}, Tried{"rk4", 8, 20000}, Tried{"gauss", 10000, 1},
                             Tried{"generalized-alpha", 5000, 20}, Tried{"velocity-verlet", 5000, 50}}) {
    const std::vector<std::string> settings{
        fmt::format("method.name={}", tried.method), fmt::format("method.step={}", step),
        fmt::format("time.output_interval={}", step), fmt::format("time.end={}", step * tried.outputs),
        fmt::format("cable.elements={}", tried.elements)};
    std::vector<std::string> command{PLUMB_PROGRAM, "solve", "a.toml", "-o", "out", "--quiet"};
    for (const std::string& setting : settings) command.insert(command.end(), {"--set", setting});
    const double measured = peak_memory(command, folder_.path());
    const double expected = estimate(load_case((folder_ / "a.toml").string(), settings).spec,
                                     {.solves = true, .writes_run = true})
                                .total(Resource::memory);
    EXPECT_LT(measured, 2 * expected) << tried.method << ": " << measured << " of " << expected;
    EXPECT_GT(measured, expected / 2) << tried.method << ": " << measured << " of " << expected;
  }
}

}  // namespace limits_test
}  // namespace plumb
