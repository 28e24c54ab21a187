#include "engine/study/work_precision/observed_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumb {
namespace study_observed_order_test {

std::vector<StepError> power_law(double order, double largest, double ratio, int runs) {
  std::vector<StepError> curve;
  for (int k = 0; k < runs; ++k) {
    const double step = largest * std::pow(ratio, -k);
    curve.push_back({step, 30 * std::pow(step, order)});
  }
  return curve;
}

TEST(StudyObservedOrder, IsThatOfAPowerLaw) {
  for (const double order : {1.0, 2.0, 4.0, 8.0}) {
    const ObservedOrder seen = observed_order(power_law(order, 0.1, 1.5, 6), 0, 1e3);
    EXPECT_NEAR(seen.order, order, 1e-12);
    EXPECT_NEAR(seen.deviation, 0, 1e-6);
    EXPECT_DOUBLE_EQ(seen.largest_step, 0.1);
    EXPECT_DOUBLE_EQ(seen.smallest_step, 0.1 * std::pow(1.5, -5));
  }
}

TEST(StudyObservedOrder, LeavesOutAFloorAndCoarseRunsOfAnotherSlope) {
  std::vector<StepError> curve = power_law(2, 1e-2, 2, 9);
  curve[0].error *= 20;
  curve[1].error *= 0.3;
  for (std::size_t k = 6; k < 9; ++k) curve[k].error = 1.1 * curve[6].error;
  const ObservedOrder seen = observed_order(curve, 0, 1e3);
  EXPECT_NEAR(seen.order, 2, 0.05) << "the last run above the floor feels it a little";
  EXPECT_DOUBLE_EQ(seen.largest_step, curve[2].step);
  EXPECT_DOUBLE_EQ(seen.smallest_step, curve[6].step);
}

TEST(StudyObservedOrder, BeyondWhatTheMethodCanChooseIsNone) {
  for (const auto& [order, seen] : {std::pair{4.0, 4.0}, {5.4, 5.4}, {5.6, -1.0}, {17.86, -1.0}})
    EXPECT_NEAR(observed_order(power_law(order, 0.1, 1.5, 6), 0, 1e3, 5).order, seen, 1e-9) << order;
}

TEST(StudyObservedOrder, AStretchBelowWhichTheErrorFallsFasterIsNotAsymptotic) {
  // Order 1 down to the fourth run, then one step of each slope.
  for (const auto& [slope, seen] : {std::pair{0.1, 1.0}, {1.19, 1.0}, {1.35, -1.0}, {4.0, -1.0}}) {
    std::vector<StepError> curve = power_law(1, 1e-2, 2, 6);
    curve[4].error = curve[3].error * std::pow(2, -slope);
    curve[5].error = curve[4].error * std::pow(2, -0.2);
    EXPECT_NEAR(observed_order(curve, 0, 1e3).order, seen, 0.05) << slope;
  }
}

TEST(StudyObservedOrder, UsesOnlyErrorsBetweenFloorAndCeiling) {
  const std::vector<StepError> curve = power_law(3, 1e-1, 2, 8);
  const ObservedOrder seen = observed_order(curve, 0.9 * curve[6].error, 1.1 * curve[2].error);
  EXPECT_NEAR(seen.order, 3, 1e-12);
  EXPECT_DOUBLE_EQ(seen.largest_step, curve[2].step);
  EXPECT_DOUBLE_EQ(seen.smallest_step, curve[6].step);
}

TEST(StudyObservedOrder, ARunThatFailedParts) {
  std::vector<StepError> curve = power_law(2, 1e-2, 2, 7);
  curve[3].error = -1;
  EXPECT_DOUBLE_EQ(observed_order(curve, 0, 1e3).largest_step, curve[4].step);
  curve[5].error = -1;
  EXPECT_DOUBLE_EQ(observed_order(curve, 0, 1e3).largest_step, curve[0].step);
}

TEST(StudyObservedOrder, TwoRunsAPlateauOrScatterGiveNone) {
  EXPECT_EQ(observed_order(power_law(2, 1e-2, 2, 2), 0, 1e3).order, -1);
  EXPECT_EQ(observed_order(power_law(0.01, 1e-2, 2, 6), 0, 1e3).order, -1)
      << "a method that does not converge";
  std::vector<StepError> scatter = power_law(2, 1e-2, 2, 6);
  for (std::size_t k = 0; k < scatter.size(); ++k) scatter[k].error *= k % 2 == 0 ? 5 : 1;
  EXPECT_EQ(observed_order(scatter, 0, 1e3).order, -1);
  EXPECT_EQ(observed_order({}, 0, 1).order, -1);
}

TEST(StudyObservedOrder, ScatterWithinThePartIsItsDeviation) {
  std::vector<StepError> curve = power_law(2, 1e-2, 2, 6);
  for (std::size_t k = 0; k < curve.size(); ++k) curve[k].error *= k % 2 == 0 ? 1.05 : 1 / 1.05;
  const ObservedOrder seen = observed_order(curve, 0, 1e3);
  EXPECT_NEAR(seen.order, 2, 0.05);
  EXPECT_GT(seen.deviation, 0.005);
  EXPECT_LT(seen.deviation, 0.05);
}

}  // namespace study_observed_order_test
}  // namespace plumb
