#include "engine/model/support_constraints.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/model/supports.h"

namespace plumb {
namespace support_constraints_test {

const Support every_support[] = {Support::free, Support::pinned, Support::clamped};

TEST(SupportConstraints, HaveOrthonormalRowsThatAreTheComplementOfTheProjection) {
  const Vec3 direction = Vec3(2, -1, 3).normalized();
  constexpr int nodes = 3;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const Support first : every_support)
    for (const Support last : every_support) {
      const SupportConstraints constraints({first, last}, direction, nodes);
      const SupportProjection projection({first, last}, direction, nodes);
      Eigen::VectorXd x(6 * nodes);
      for (double& number : x) number = unit(generator);
      Eigen::VectorXd expected = x, seen = x;
      projection.apply(expected);
      constraints.add_transposed(-constraints.apply(x), seen);
      EXPECT_LE((seen - expected).norm(), 1e-15) << word(first) << ", " << word(last);
      for (Eigen::Index row = 0; row < constraints.count(); ++row) {
        const Eigen::VectorXd one = Eigen::VectorXd::Unit(constraints.count(), row);
        Eigen::VectorXd back = Eigen::VectorXd::Zero(6 * nodes);
        constraints.add_transposed(one, back);
        EXPECT_LE((constraints.apply(back) - one).norm(), 1e-15) << "row " << row;
      }
    }
}

TEST(SupportConstraints, AreThreeOfAPinnedAndFiveOfAClampedEnd) {
  const auto count = [](Support first, Support last) {
    return SupportConstraints({first, last}, Vec3::UnitX(), 2).count();
  };
  EXPECT_EQ(count(Support::free, Support::free), 0);
  EXPECT_EQ(count(Support::pinned, Support::free), 3);
  EXPECT_EQ(count(Support::pinned, Support::clamped), 8);
  EXPECT_EQ(count(Support::clamped, Support::clamped), 10);
}

TEST(GreatestReaction, LooksAtTheForcesOfBothEndsAndNotAtMoments) {
  Eigen::VectorXd quiet = Eigen::VectorXd::Zero(8), loud = quiet;
  quiet << 1, 2, 2, 9, 9, 0, 0, 1;
  loud << 0, 0, 1, 99, 99, 2, 3, 6;
  const SupportsSpec ends{Support::clamped, Support::pinned};
  EXPECT_DOUBLE_EQ(greatest_reaction(ends, {quiet}), 3);
  EXPECT_DOUBLE_EQ(greatest_reaction(ends, {quiet, loud}), 7);
  EXPECT_EQ(greatest_reaction(ends, {}), 0);
}

}  // namespace support_constraints_test
}  // namespace plumb
