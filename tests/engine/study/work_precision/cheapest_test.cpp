#include "engine/study/work_precision/cheapest.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace study_cheapest_test {

WorkPrecisionRun with_step(double step) {
  WorkPrecisionRun run;
  run.method.step = step;
  run.elements = 4;
  return run;
}

TEST(StudyCheapest, EachDecadeNamesTheQuickestRunThatStaysBelowIt) {
  WorkPrecision study;
  study.runs = {with_step(1e-2), with_step(1e-3), with_step(5e-4), with_step(1e-4)};
  const std::vector<WorkError> points{{1e-4, 0.05}, {1e-3, 3e-3}, {4.1e-4, 4e-5}, {2, 5e-7}};
  const auto cheapest = cheapest_runs(study, {"a", "b", "rk4", "c"}, points, 0, 0.1);
  ASSERT_EQ(cheapest.size(), 5U);
  EXPECT_NEAR(cheapest[0].error, 1e-2, 1e-17);
  for (const std::size_t k : {0U, 1U, 2U}) EXPECT_EQ(cheapest[k].run, 2U) << "the dearer run b is of no use";
  EXPECT_EQ(cheapest[2].in_words, "below 1e-4 m: rk4 with 4 elements, step 0.0005 s, 410 µs");
  EXPECT_EQ(cheapest[4].in_words, "below 1e-6 m: c with 4 elements, step 0.0001 s, 2 s");
  study.timed = false;
  EXPECT_EQ(cheapest_runs(study, {"a"}, {{1520, 0.005}}, 0, 0.1)[0].in_words,
            "below 1e-2 m: a with 4 elements, step 0.01 s, 1520 force evaluations");
}

TEST(StudyCheapest, NothingIsSaidBelowTheFloorOrWhereNothingWasTimed) {
  WorkPrecision study;
  study.runs = {with_step(1e-2)};
  EXPECT_EQ(cheapest_runs(study, {"a"}, {{1, 1e-9}}, 1e-5, 1).size(), 5U) << "1e-1 to 1e-5";
  EXPECT_TRUE(cheapest_runs(study, {"a"}, {{-1, 1e-9}}, 0, 1).empty());
  EXPECT_TRUE(cheapest_runs(study, {"a"}, {{1, -1}}, 0, 1).empty());
}

}  // namespace study_cheapest_test
}  // namespace plumb
