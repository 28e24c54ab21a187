#include "engine/model/mass.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/model/block_tridiagonal.h"
#include "engine/model/hermite.h"
#include "engine/model/quadrature.h"

namespace plumb {
namespace {

constexpr double mass_per_length = 0.3, l = 0.4;
constexpr int elements = 6;
const Vec3 direction = Vec3(1, 2, -1).normalized();

Eigen::VectorXd random_vector(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  return Eigen::VectorXd::NullaryExpr(6 * (elements + 1), [&] { return unit(generator); });
}

Eigen::MatrixXd dense_mass(const MassMatrix& mass) {
  BlockTridiagonal M(elements + 1);
  mass.add_to(M, 1);
  return M.dense();
}

TEST(Mass, IsTheIntegralOfTheShapeFunctionProducts) {
  const SupportProjection free({}, direction, 2);
  const MassMatrix mass(mass_per_length, l, 1, free);
  BlockTridiagonal M(2);
  mass.add_to(M, 1);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      double integral = 0;
      for (const QuadraturePoint& p : gauss_rule(5)) {
        const auto s = Hermite::values(p.x, l);
        integral +=
            mass_per_length * l * p.weight * s[static_cast<std::size_t>(i)] * s[static_cast<std::size_t>(j)];
      }
      EXPECT_NEAR(M.dense()(3 * i, 3 * j), integral, 1e-15) << i << ", " << j;
    }
}

TEST(Mass, MultipliesAndMeasuresEnergyAsTheFullMatrixDoes) {
  const MassMatrix mass(mass_per_length, l, elements, SupportProjection({}, direction, elements + 1));
  const Eigen::MatrixXd M = dense_mass(mass);
  const Eigen::VectorXd v = random_vector(1);
  Eigen::VectorXd y;
  mass.multiply(v, y);
  EXPECT_LE((y - M * v).norm(), 1e-15);
  EXPECT_NEAR(mass.kinetic_energy(v), 0.5 * v.dot(M * v), 1e-15);
}

class MassWith : public testing::TestWithParam<SupportsSpec> {};

// The acceleration a is admissible, and the supports take up only what they hold: P (M a − f) = 0.
TEST_P(MassWith, SolvesForTheAdmissibleAcceleration) {
  const SupportProjection supports(GetParam(), direction, elements + 1);
  const MassMatrix mass(mass_per_length, l, elements, supports);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Eigen::VectorXd f = random_vector(seed);
    Eigen::VectorXd a = f;
    mass.solve(a);
    Eigen::VectorXd admissible = a;
    supports.apply(admissible);
    EXPECT_LE((a - admissible).norm(), 1e-12 * a.norm()) << "seed " << seed;
    Eigen::VectorXd residual = dense_mass(mass) * a - f;
    supports.apply(residual);
    EXPECT_LE(residual.norm(), 1e-12 * f.norm()) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(AllEnds, MassWith,
                         testing::Values(SupportsSpec{}, SupportsSpec{Support::pinned, Support::free},
                                         SupportsSpec{Support::free, Support::pinned},
                                         SupportsSpec{Support::clamped, Support::free},
                                         SupportsSpec{Support::free, Support::clamped},
                                         SupportsSpec{Support::pinned, Support::clamped},
                                         SupportsSpec{Support::clamped, Support::clamped}),
                         [](const auto& ends) {
                           return std::string(word(ends.param.first)) + "_" +
                                  std::string(word(ends.param.last));
                         });

}  // namespace
}  // namespace plumb
