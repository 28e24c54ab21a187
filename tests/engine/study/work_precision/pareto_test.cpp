#include "engine/study/work_precision/pareto.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace plumb {
namespace study_pareto_test {

bool beats(const WorkError& a, const WorkError& b) {
  return a.work <= b.work && a.error <= b.error && (a.work < b.work || a.error < b.error);
}

/// Few values, so that equal costs and errors are common.
std::vector<WorkError> some_runs() {
  const auto numbers = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-1, 12), rc::gen::inRange(-1, 12)));
  std::vector<WorkError> runs;
  for (const auto& [seconds, error] : numbers) runs.push_back({0.1 * seconds, 0.1 * error});
  return runs;
}

bool counts(const WorkError& run) {
  return run.work >= 0 && run.error >= 0;
}

TEST(StudyPareto, NoRunBeatsOneOfTheFront) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<WorkError> runs = some_runs();
    for (const std::size_t k : pareto_front(runs)) {
      RC_ASSERT(counts(runs[k]));
      for (const WorkError& other : runs) RC_ASSERT(!counts(other) || !beats(other, runs[k]));
    }
  }));
}

TEST(StudyPareto, EveryOtherRunIsBeatenOrEqualledByOneOfTheFront) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<WorkError> runs = some_runs();
    const std::vector<std::size_t> front = pareto_front(runs);
    for (const WorkError& run : runs)
      RC_ASSERT(!counts(run) || std::any_of(front.begin(), front.end(), [&](std::size_t k) {
        return runs[k].work <= run.work && runs[k].error <= run.error;
      }));
  }));
}

TEST(StudyPareto, TheFrontRisesInCostAndFallsInError) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<WorkError> runs = some_runs();
    const std::vector<std::size_t> front = pareto_front(runs);
    for (std::size_t k = 1; k < front.size(); ++k) {
      RC_ASSERT(runs[front[k - 1]].work < runs[front[k]].work);
      RC_ASSERT(runs[front[k - 1]].error > runs[front[k]].error);
    }
  }));
}

TEST(StudyPareto, RunsWithoutCostOrErrorAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pareto_front(std::vector<WorkError>{{-1, 1}, {1, -1}, {nan, 1}, {1, nan}}),
            std::vector<std::size_t>{});
  EXPECT_EQ(pareto_front(std::vector<WorkError>{{2, 1}, {1, 2}, {3, 1}}), (std::vector<std::size_t>{1, 0}));
}

}  // namespace study_pareto_test
}  // namespace plumb
