#include "engine/model/discrete_gradient.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace discrete_gradient_test {

class DiscreteGradientOf : public testing::TestWithParam<std::tuple<StrainModel, QuadratureRule>> {
 protected:
  DiscreteGradientOf() {
    spec.cable.strain = std::get<0>(GetParam());
    spec.cable.quadrature = std::get<1>(GetParam());
    spec.cable.second_moment *= 1e4;  // so that bending counts beside stretching
  }

  Eigen::VectorXd state(double spread) {
    std::uniform_real_distribution<double> unit(-1, 1);
    Eigen::VectorXd q = cable.start_q(spec.start);
    for (double& x : q) x += spread * unit(generator);
    return q;
  }

  Case spec = pendulum(5, 3);
  Cable cable{spec};
  std::mt19937 generator{42};
};

TEST_P(DiscreteGradientOf, WorkIsTheChangeOfEnergy) {
  const Cable with(spec);
  const DiscreteGradient gradient(with);
  const auto strain_energy = [&](const Eigen::VectorXd& q) {
    const Energies e = with.energies(q, Eigen::VectorXd::Zero(q.size()));
    return e.axial + e.bending;
  };
  for (const double spread : {0.2, 1e-2, 1e-5})
    for (int k = 0; k < 20; ++k) {
      const Eigen::VectorXd q0 = state(spread), q1 = state(spread);
      Eigen::VectorXd f;
      ASSERT_EQ(gradient.force(q0, q1, f), std::nullopt);
      const double change = strain_energy(q1) - strain_energy(q0);
      EXPECT_NEAR(-f.dot(q1 - q0), change, 1e-13 * (strain_energy(q0) + strain_energy(q1)) + 1e-16)
          << "spread " << spread;
    }
}

TEST_P(DiscreteGradientOf, IsTheGradientWhereBothStatesAreOne) {
  const Cable with(spec);
  const DiscreteGradient gradient(with);
  const Eigen::VectorXd q = state(0.1);
  Eigen::VectorXd f, exact;
  gradient.force(q, q, f);
  with.force(q, exact);
  exact -= with.external_force();
  EXPECT_LE((f - exact).norm(), 1e-13 * exact.norm());
}

TEST_P(DiscreteGradientOf, HasNoNetForceAndNoNetMomentAboutTheMeanState) {
  const Cable with(spec);
  const DiscreteGradient gradient(with);
  const Eigen::VectorXd q0 = state(0.1), q1 = state(0.1), middle = 0.5 * (q0 + q1);
  Eigen::VectorXd f;
  gradient.force(q0, q1, f);
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (int node = 0; node < with.nodes(); ++node) {
    force += f.segment<3>(6 * node);
    moment += middle.segment<3>(6 * node).cross(f.segment<3>(6 * node)) +
              middle.segment<3>(6 * node + 3).cross(f.segment<3>(6 * node + 3));
  }
  EXPECT_LE(force.norm(), 1e-13 * f.norm());
  EXPECT_LE(moment.norm(), 1e-13 * f.norm());
}

TEST_P(DiscreteGradientOf, TangentIsTheDerivativeByTheNewState) {
  const Cable with(spec);
  const DiscreteGradient gradient(with);
  const Eigen::VectorXd q0 = state(0.1), q1 = state(0.1);
  GeneralBlockTridiagonal<double> A(with.nodes());
  gradient.add_tangent(q0, q1, 1, A);
  constexpr double h = 1e-6;
  Eigen::VectorXd ahead, behind, expected, unit;
  double greatest = 0, largest = 0;
  for (int i = 0; i < with.size(); ++i) {
    unit = Eigen::VectorXd::Unit(with.size(), i);
    gradient.force(q0, q1 + h * unit, ahead);
    gradient.force(q0, q1 - h * unit, behind);
    expected = (behind - ahead) / (2 * h);
    const int node = i / 6, column = i % 6;
    const auto at = static_cast<std::size_t>(node);
    Eigen::VectorXd seen = Eigen::VectorXd::Zero(with.size());
    seen.segment<6>(6 * node) = A.diagonal[at].col(column);
    if (node + 1 < with.nodes()) seen.segment<6>(6 * node + 6) = A.below[at].col(column);
    if (node > 0) seen.segment<6>(6 * node - 6) = A.above[at - 1].col(column);
    greatest = std::max(greatest, (seen - expected).lpNorm<Eigen::Infinity>());
    largest = std::max(largest, expected.lpNorm<Eigen::Infinity>());
  }
  EXPECT_LE(greatest, 1e-7 * largest) << "the largest entry is " << largest;
}

INSTANTIATE_TEST_SUITE_P(Models, DiscreteGradientOf,
                         testing::Combine(testing::Values(StrainModel::green_geometric,
                                                          StrainModel::engineering_material),
                                          testing::Values(QuadratureRule::full, QuadratureRule::reduced)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param) == StrainModel::green_geometric
                                                  ? "Green"
                                                  : "Engineering") +
                                  (std::get<1>(tested.param) == QuadratureRule::full ? "Full" : "Reduced");
                         });

}  // namespace discrete_gradient_test
}  // namespace plumb
