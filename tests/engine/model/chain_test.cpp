#include "engine/model/chain.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "engine/model/cable.h"
#include "engine/model/discrete_gradient.h"
#include "engine/run/probes.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace chain_test {

Case chain(StrainModel strain, int links) {
  Case spec = pendulum(5, links);
  spec.cable.model = CableModel::chain;
  spec.cable.second_moment = 0;
  spec.cable.strain = strain;
  return spec;
}

class ChainOf : public testing::TestWithParam<StrainModel> {
 protected:
  Eigen::VectorXd state(double spread) {
    std::uniform_real_distribution<double> unit(-1, 1);
    Eigen::VectorXd q = cable.start_q(spec.start);
    for (double& x : q) x += spread * unit(generator);
    return q;
  }

  Case spec = chain(GetParam(), 3);
  Cable cable{spec};
  std::mt19937 generator{42};
};

TEST_P(ChainOf, ForceIsTheDerivativeOfTheEnergy) {
  const Eigen::VectorXd q = state(0.1), v = Eigen::VectorXd::Zero(q.size());
  Eigen::VectorXd f;
  ASSERT_EQ(cable.force(q, f), std::nullopt);
  constexpr double h = 1e-6;
  for (int i = 0; i < cable.size(); ++i) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(cable.size(), i);
    const double by_difference =
        -(cable.energies(q + h * unit, v).total() - cable.energies(q - h * unit, v).total()) / (2 * h);
    EXPECT_NEAR(f[i], by_difference, 1e-8) << "coordinate " << i;
  }
}

TEST_P(ChainOf, TangentIsTheDerivativeOfTheForce) {
  const Eigen::VectorXd q = state(0.1);
  BlockTridiagonal A(cable.nodes());
  cable.system(q, 0, 1, A);
  const Eigen::MatrixXd K = A.dense();
  Eigen::VectorXd ahead, behind;
  constexpr double h = 1e-6;
  for (int i = 0; i < cable.size(); ++i) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(cable.size(), i);
    cable.force(q + h * unit, ahead);
    cable.force(q - h * unit, behind);
    const double off = (K.col(i) - (behind - ahead) / (2 * h)).lpNorm<Eigen::Infinity>();
    EXPECT_LE(off, 1e-7 * K.lpNorm<Eigen::Infinity>()) << "column " << i;
  }
}

TEST_P(ChainOf, DiscreteGradientDoesTheWorkOfTheChangeOfEnergyAndHasItsTangent) {
  const DiscreteGradient gradient(cable);
  const Eigen::VectorXd q0 = state(0.1), q1 = state(0.1), v = Eigen::VectorXd::Zero(q0.size());
  Eigen::VectorXd f, ahead, behind;
  ASSERT_EQ(gradient.force(q0, q1, f), std::nullopt);
  EXPECT_NEAR(-f.dot(q1 - q0), cable.energies(q1, v).axial - cable.energies(q0, v).axial, 1e-14);
  GeneralBlockTridiagonal<double> A(cable.nodes());
  gradient.add_tangent(q0, q1, 1, A);
  constexpr double h = 1e-6;
  for (int i = 0; i < cable.size(); ++i) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(cable.size(), i);
    gradient.force(q0, q1 + h * unit, ahead);
    gradient.force(q0, q1 - h * unit, behind);
    const Eigen::VectorXd expected = (behind - ahead) / (2 * h);
    const int node = i / 6;
    const auto at = static_cast<std::size_t>(node);
    Eigen::VectorXd seen = Eigen::VectorXd::Zero(cable.size());
    seen.segment<6>(6 * node) = A.diagonal[at].col(i % 6);
    if (node + 1 < cable.nodes()) seen.segment<6>(6 * node + 6) = A.below[at].col(i % 6);
    if (node > 0) seen.segment<6>(6 * node - 6) = A.above[at - 1].col(i % 6);
    EXPECT_LE((seen - expected).lpNorm<Eigen::Infinity>(), 1e-5) << "column " << i;
  }
}

TEST_P(ChainOf, HasHalfOfTheMassOfEachLinkAtEitherEnd) {
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(cable.size());
  Eigen::VectorXd momentum;
  cable.mass().multiply(one, momentum);
  const double half = 0.5 * 8e-3 / 3;  // ρA l / 2
  for (int node = 0; node <= 3; ++node)
    EXPECT_NEAR(momentum[6 * node], node == 0 || node == 3 ? half : 2 * half, 1e-17) << "node " << node;
  EXPECT_NEAR(cable.energies(cable.start_q(spec.start), one).kinetic, 0.5 * 3 * 8e-3, 1e-16)
      << "rates of slopes have no energy";
}

TEST_P(ChainOf, LinkThatCollapsesIsSingularAndNamed) {
  State start{0, cable.start_q(spec.start), Eigen::VectorXd::Zero(cable.size())};
  start.q.segment<3>(12) = start.q.segment<3>(6);
  Eigen::VectorXd f;
  EXPECT_EQ(cable.force(start.q, f), std::optional<int>(1));
  const Trajectory trajectory = integrate(cable, start, method("rk4", 1e-4), {0.1, 0.1});
  EXPECT_EQ(trajectory.outcome, Outcome::singular) << trajectory.message;
  EXPECT_NE(trajectory.message.find("element 2"), std::string::npos) << trajectory.message;
}

TEST_P(ChainOf, OutputsHaveTheMeanSlopesOfTheLinksBesideANodeAndTheirRates) {
  Case swinging = chain(GetParam(), 2);
  swinging.start.angular_velocity = {0, 4, 1};
  const Trajectory trajectory = run(swinging, method("rk4", 2e-4), {0.2, 0.1});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  const auto expect_slopes = [](const Eigen::VectorXd& x) {
    const Vec3 first = (x.segment<3>(6) - x.segment<3>(0)) / 0.5;
    const Vec3 second = (x.segment<3>(12) - x.segment<3>(6)) / 0.5;
    EXPECT_LE((x.segment<3>(3) - first).norm(), 1e-14);
    EXPECT_LE((x.segment<3>(9) - 0.5 * (first + second)).norm(), 1e-14);
    EXPECT_LE((x.segment<3>(15) - second).norm(), 1e-14);
  };
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    expect_slopes(trajectory.q[k]);
    expect_slopes(trajectory.v[k]);
  }
  EXPECT_GT((trajectory.q.back().segment<3>(3) - trajectory.q.back().segment<3>(15)).norm(), 1e-3)
      << "the links are still in line";
}

TEST_P(ChainOf, ProbesOfStrainAndForceAreThoseOfTheLink) {
  Case probed = chain(GetParam(), 2);
  probed.probes = {{"first", 0.2, Quantity::axial_strain},
                   {"second", 0.9, Quantity::axial_force},
                   {"there", 0.25, Quantity::position},
                   {"bend", 0.5, Quantity::curvature}};
  Trajectory trajectory;
  trajectory.times = {0};
  Eigen::VectorXd q = Eigen::VectorXd::Zero(18);
  q.segment<3>(6) = Vec3(0, 0.6, 0);      // λ = 1.2
  q.segment<3>(12) = Vec3(0.45, 0.6, 0);  // λ = 0.9
  trajectory.q = {q};
  trajectory.v = {Eigen::VectorXd::Zero(18)};
  const ProbeTable table = probe(probed, trajectory);
  const bool green = GetParam() == StrainModel::green_geometric;
  EXPECT_NEAR(table.find("first")->values[0], green ? 0.22 : 0.2, 1e-15);
  EXPECT_NEAR(table.find("second")->values[0], 40 * (green ? -0.095 * 0.9 : -0.1), 1e-13);
  EXPECT_NEAR(table.find("there.y")->values[0], 0.3, 1e-15);
  EXPECT_EQ(table.find("bend")->values[0], 0);
}

INSTANTIATE_TEST_SUITE_P(Strains, ChainOf,
                         testing::Values(StrainModel::green_geometric, StrainModel::engineering_material),
                         [](const auto& tested) {
                           return tested.param == StrainModel::green_geometric ? "Green" : "Engineering";
                         });

/// Every method in every way it can be used, on a chain.
class EveryMethodOnAChain : public testing::TestWithParam<std::string> {
 protected:
  MethodSpec spec_of(double step, double tolerance) const {
    return info.takes_step ? method(info.name, step) : method(info.name, {}, tolerance);
  }
  const MethodInfo& info = *find_method(GetParam());
};

TEST_P(EveryMethodOnAChain, LetsAFreeChainFallAsOneAndKeepsItsMomentum) {
  for (const StrainModel strain : {StrainModel::green_geometric, StrainModel::engineering_material}) {
    Case spec = chain(strain, 4);
    spec.supports.first = Support::free;
    spec.start.angular_velocity = {1, 3, 2};
    const Cable cable(spec);
    const auto momentum = [&](const Eigen::VectorXd& v) {
      Eigen::VectorXd p;
      cable.mass().multiply(v, p);
      Vec3 sum = Vec3::Zero();
      for (int node = 0; node < cable.nodes(); ++node) sum += p.segment<3>(6 * node);
      return sum;
    };
    const Trajectory trajectory = run(spec, spec_of(2e-4, 1e-9), {0.1, 0.05});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    const Vec3 expected = momentum(trajectory.v.front()) + 8e-3 * 0.1 * spec.loads.gravity;
    EXPECT_LE((momentum(trajectory.v.back()) - expected).norm(), 1e-12)
        << momentum(trajectory.v.back()).transpose() << " kg m/s";
  }
}

TEST_P(EveryMethodOnAChain, AgreesWithTheReference) {
  const Case spec = chain(StrainModel::engineering_material, 4);
  const TimeSpec time{0.3, 0.05};
  const Trajectory exact = run(spec, method("rk4", 5e-5), time), seen = run(spec, spec_of(1e-4, 1e-10), time);
  ASSERT_EQ(seen.outcome, Outcome::completed) << seen.message;
  EXPECT_LE(tip_distance(seen, exact), info.order == "1" ? 5e-3 : 1e-5);
}

INSTANTIATE_TEST_SUITE_P(All, EveryMethodOnAChain, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const MethodInfo& any : method_infos())
                             if (any.dynamic) names.push_back(any.name);
                           return names;
                         }()),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Chain, EnergyMomentumKeepsItsEnergy) {
  for (const StrainModel strain : {StrainModel::green_geometric, StrainModel::engineering_material}) {
    const Trajectory kept = run(chain(strain, 4), method("energy-momentum", 1e-2), {5, 0.1});
    ASSERT_EQ(kept.outcome, Outcome::completed) << kept.message;
    EXPECT_LE(kept.relative_energy_drift(), 1e-9) << word(strain);
  }
}

}  // namespace chain_test
}  // namespace plumb
