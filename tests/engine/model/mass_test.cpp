#include "engine/model/mass.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/model/hermite.h"
#include "engine/model/quadrature.h"

namespace plumb {
namespace mass_test {

constexpr double mass_of_a_metre = 0.3, l = 0.4;
const ElementConstants element{.length = l, .mass_per_length = mass_of_a_metre};
const Vec3 direction = Vec3(1, 2, -1).normalized();

// Odd and even numbers of nodes, and the shortest chains, whose halves are empty.
constexpr int element_counts[] = {1, 2, 3, 4, 6, 9, 150};

Eigen::VectorXd random_vector(int elements, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  return Eigen::VectorXd::NullaryExpr(6 * (elements + 1), [&] { return unit(generator); });
}

/// ∫ ρA sᵢsⱼ dx by a rule that is exact for degree 6 and more.
Eigen::MatrixXd integrated_mass(int elements) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(6 * (elements + 1), 6 * (elements + 1));
  for (int e = 0; e < elements; ++e)
    for (const QuadraturePoint& p : gauss_rule(5)) {
      const auto s = Hermite::values(p.x, l);
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          M.block<3, 3>(6 * e + 3 * i, 6 * e + 3 * j).diagonal().array() += mass_of_a_metre * l * p.weight *
                                                                            s[static_cast<std::size_t>(i)] *
                                                                            s[static_cast<std::size_t>(j)];
    }
  return M;
}

TEST(Mass, MultipliesAndMeasuresEnergyAsTheIntegralOfTheShapeFunctionProductsDoes) {
  for (const int elements : element_counts) {
    const MassMatrix mass(element, elements, SupportProjection({}, direction, elements + 1));
    const Eigen::MatrixXd M = integrated_mass(elements);
    const Eigen::VectorXd v = random_vector(elements, 1);
    Eigen::VectorXd y;
    mass.multiply(v, y);
    EXPECT_LE((y - M * v).norm(), 1e-14 * v.norm()) << elements << " elements";
    EXPECT_NEAR(mass.kinetic_energy(v), 0.5 * v.dot(M * v), 1e-14 * v.squaredNorm())
        << elements << " elements";
  }
}

class MassWith : public testing::TestWithParam<SupportsSpec> {};

// The acceleration a is admissible, and the supports take up only what they hold: P (M a − f) = 0.
TEST_P(MassWith, SolvesForTheAdmissibleAcceleration) {
  for (const int elements : element_counts) {
    const SupportProjection supports(GetParam(), direction, elements + 1);
    const MassMatrix mass(element, elements, supports);
    const Eigen::MatrixXd M = integrated_mass(elements);
    Eigen::VectorXd scratch;
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Eigen::VectorXd f = random_vector(elements, seed);
      Eigen::VectorXd a = f;
      mass.solve(a, scratch);
      Eigen::VectorXd admissible = a;
      supports.apply(admissible);
      EXPECT_LE((a - admissible).norm(), 1e-12 * a.norm()) << elements << " elements, seed " << seed;
      Eigen::VectorXd residual = M * a - f;
      supports.apply(residual);
      EXPECT_LE(residual.norm(), 1e-12 * f.norm()) << elements << " elements, seed " << seed;
    }
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

}  // namespace mass_test
}  // namespace plumb
