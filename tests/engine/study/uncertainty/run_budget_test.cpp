#include "engine/study/uncertainty/run_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/study/in_memory.h"

namespace plumb {
namespace budget_run_test {

/// The budget of the pendulum without its mesh of 64, which takes longer than all else.
LoadedCase quick_pendulum() {
  LoadedCase loaded = load_case(PLUMB_SOURCE_DIR "/cases/pendulum.toml");
  std::erase_if(loaded.spec.error_budget->items,
                [](const BudgetItemSpec& item) { return item.name == "mesh"; });
  return loaded;
}

const BudgetRun& run_of(const ErrorBudget& budget, const std::string& name) {
  for (const BudgetEntry& entry : budget.entries)
    if (entry.name == name) return entry.run;
  throw std::out_of_range(name);
}

std::string digits(double value, int count) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", count - 1, value);
  return text;
}

TEST(ErrorBudget, OfThePublishedPendulumIsThatOfAnIndependentProgram) {
  const ErrorBudget budget = run_budget(quick_pendulum(), InMemory());
  ASSERT_EQ(budget.left_out, "");
  ASSERT_EQ(budget.series.size(), 3U);
  ASSERT_EQ(budget.series[0].column, "mid.y");
  ASSERT_EQ(budget.series[2].column, "tip.z");
  // Greatest changes of the middle's height and of the tip across, m, every 1e-3 s over 2 s, to two digits as
  // an independent program has them.
  struct Known {
    const char* name;
    double mid_y, tip_z;
  };
  for (const Known& known : {Known{"strain", 3.0e-4, 8.7e-4}, Known{"gravity", 9.2e-4, 2.2e-3},
                             Known{"start", 2.3e-3, 1.2e-2}, Known{"time integration", 5.6e-3, 1.7e-2}}) {
    const BudgetRun& run = run_of(budget, known.name);
    ASSERT_EQ(run.outcome, Outcome::completed) << run.message;
    EXPECT_EQ(digits(run.distances[0].from_base->sampled, 2), digits(known.mid_y, 2))
        << known.name << ", mid.y";
    EXPECT_EQ(digits(run.distances[2].from_base->sampled, 2), digits(known.tip_z, 2))
        << known.name << ", tip.z";
    for (const SeriesDistance& distance : run.distances)
      EXPECT_GE(distance.from_base->sampled, distance.from_base->at_reference) << known.name;
  }
}

TEST(ErrorBudget, TheBaseRepeatsTheReferenceToItsRounding) {
  const ErrorBudget budget = run_budget(quick_pendulum(), InMemory());
  ASSERT_TRUE(budget.base.completed()) << budget.base.message;
  EXPECT_EQ(budget.times.size(), 101U);
  double greatest = 0;
  for (const SeriesDistance& distance : budget.base.distances) {
    greatest = std::max(greatest, distance.from_reference);
    EXPECT_FALSE(distance.from_base) << distance.series;
  }
  EXPECT_NEAR(greatest, 5.5e-6, 0.5e-6);
  EXPECT_GT(budget.together.distances.at(2).from_base.value().at_reference, 1e-3);
}

TEST(ErrorBudget, AnItemThatFailsIsAResultWithoutDistances) {
  LoadedCase loaded = quick_pendulum();
  loaded.spec.error_budget->items = {
      {"too long a step", {"method.name=rk4", "method.step=0.02"}, "beyond its limit of stability", false}};
  const ErrorBudget budget = run_budget(loaded, InMemory());
  const BudgetRun& run = budget.entries.at(0).run;
  EXPECT_NE(run.outcome, Outcome::completed);
  EXPECT_TRUE(run.distances.empty());
  EXPECT_FALSE(run.message.empty());
  EXPECT_TRUE(budget.together.completed()) << "it is no part of all together";
}

TEST(ErrorBudget, OfAnotherCableIsNotMade) {
  LoadedCase loaded = load_case(PLUMB_SOURCE_DIR "/cases/pendulum.toml", {"parameters.f=4"});
  const ErrorBudget budget = run_budget(loaded, InMemory());
  EXPECT_EQ(budget.left_out, "the reference is for another cable: EA is 62.5 N, that of the reference 40 N");
  EXPECT_TRUE(budget.entries.empty());
}

}  // namespace budget_run_test
}  // namespace plumb
