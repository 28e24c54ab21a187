#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "tests/report/program/program.h"

namespace plumb {
namespace allocation_faults_test {

/// Of how many allocations one is made to fail, in the suite; PLUMB_EVERY_ALLOCATION=1 in the environment
/// tries every one of them.
constexpr long tried_in_suite = 40;

/// Makes single allocations of a command fail, one command after the other, and looks at how it ends.
void expect_every_allocation_may_fail(const std::string& arguments, const std::string& output) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer has allocations of its own";
#endif
  const TemporaryFolder folder;
  const auto plumb = [&](const std::string& variables) {
    return run_command({"sh", "-c",
                        fmt::format("LD_PRELOAD={} {} {} {} --quiet", PLUMB_FAILING_ALLOCATION, variables,
                                    PLUMB_PROGRAM, arguments)},
                       folder.path());
  };
  ASSERT_EQ(plumb("PLUMB_COUNT_ALLOCATIONS=count").status, 0);
  const long count = std::atol(read_text(folder / "count").c_str());
  ASSERT_GT(count, 100) << "nothing was counted";
  fs::remove(folder / "count");
  const std::string whole = output.empty() ? "" : read_text(folder / output);
  const char* every = std::getenv("PLUMB_EVERY_ALLOCATION");
  const long stride = every != nullptr ? 1 : std::max(1L, count / tried_in_suite);
  long failed = 0;
  for (long n = 1; n <= count; n += stride) {
    const Ended ended = plumb(fmt::format("PLUMB_FAIL_ALLOCATION={}", n));
    failed += ended.status != 0;
    const std::string which = fmt::format("allocation {} of {}: {}", n, count, ended.err);
    EXPECT_TRUE(ended.status == 0 || (ended.status >= 3 && ended.status <= 5))
        << ended.status << ", " << which;
    if (ended.status != 0) expect_one_line(ended.err);
    if (!output.empty()) {
      EXPECT_EQ(read_text(folder / output), whole) << which;
    }
    for (const auto& entry : fs::directory_iterator(folder.path()))
      EXPECT_EQ(entry.path().filename().string().find(".part-"), std::string::npos)
          << entry.path() << ", " << which;
  }
  EXPECT_GT(failed, 0) << "no allocation was made to fail";
}

const std::string small = std::string(PLUMB_TEST_DATA) + "/small_case.toml";

TEST(AllocationFaults, OfSolveLeaveTheEarlierRunOrTheNewOne) {
  expect_every_allocation_may_fail("solve " + small + " --set time.output_interval=1 -o out",
                                   "out/probes.csv");
}

TEST(AllocationFaults, OfCheckEndInOneLine) {
  expect_every_allocation_may_fail("check " + small, "");
}

}  // namespace allocation_faults_test
}  // namespace plumb
