#include "engine/study/reference/grid_convergence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace study_grid_convergence_test {

/// The index of a manufactured sequence f(h) = F + C h^p on three meshes.
GridConvergence manufactured(double order, double h, double ratio21, double ratio32) {
  const auto f = [&](double at) { return 0.7 - 3 * std::pow(at, order); };
  const double h2 = h * ratio21, h3 = h2 * ratio32;
  return grid_convergence(std::abs(f(h2) - f(h)), std::abs(f(h3) - f(h2)), ratio21, ratio32, 1.25);
}

TEST(StudyGridConvergence, FindsOrderErrorAndIndexOfAManufacturedSequence) {
  for (const double order : {0.5, 1.0, 2.0, 3.0, 4.0})
    for (const auto& [ratio21, ratio32] :
         {std::pair{2.0, 2.0}, {1.5, 2.0}, {2.0, 1.5}, {1.3, 1.7}, {2.0, 1.25}}) {
      const double h = 0.05, error = 3 * std::pow(h, order);
      const GridConvergence found = manufactured(order, h, ratio21, ratio32);
      EXPECT_NEAR(found.order, order, 1e-8) << "ratios " << ratio21 << " and " << ratio32;
      EXPECT_NEAR(found.error / error, 1, 1e-7) << "order " << order;
      EXPECT_DOUBLE_EQ(found.index, 1.25 * found.error);
    }
}

TEST(StudyGridConvergence, SaysNothingWhereTheChangesDoNotFall) {
  for (const double change32 : {1e-3, 0.9e-3, 0.0, -1.0, std::nan("")}) {
    const GridConvergence found = grid_convergence(1e-3, change32, 2, 2, 1.25);
    EXPECT_EQ(found.order, -1) << change32;
    EXPECT_EQ(found.error, -1) << change32;
    EXPECT_EQ(found.index, -1) << change32;
  }
  EXPECT_EQ(grid_convergence(0, 1, 2, 2, 1.25).order, -1);
  EXPECT_EQ(grid_convergence(1, 4, 1, 2, 1.25).order, -1);
}

}  // namespace study_grid_convergence_test
}  // namespace plumb
