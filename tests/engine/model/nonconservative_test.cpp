#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"
#include "tests/engine/scattered.h"

namespace plumb {
namespace nonconservative_test {

/// A cable bent in space.
Eigen::VectorXd bent(const Cable& cable) {
  Eigen::VectorXd q(cable.size());
  for (int node = 0; node < cable.nodes(); ++node) {
    const double s = static_cast<double>(node) / cable.elements();
    q.segment<3>(6 * node) = Vec3(std::sin(s), 0.4 * s * s, 0.3 * std::sin(2 * s));
    q.segment<3>(6 * node + 3) = Vec3(std::cos(s), 0.8 * s, 0.6 * std::cos(2 * s));
  }
  return q + 0.02 * scattered(cable.size(), 1);
}

/// Holds the tangents by q and by v of what has no potential against differences of order 4.
void expect_tangents(const Case& spec, const std::string& what) {
  const Cable cable(spec);
  const Eigen::VectorXd q = bent(cable), v = scattered(cable.size(), 2);
  constexpr double t = 0.3, share = 0.7;
  const auto force = [&](const Eigen::VectorXd& at, const Eigen::VectorXd& rates) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(cable.size());
    cable.add_other_forces(t, share, at, rates, f);
    return f;
  };
  for (const bool by_rates : {false, true}) {
    GeneralBlockTridiagonal<double> A(cable.nodes());
    cable.add_other_system(t, share, q, v, by_rates ? 0 : 1, by_rates ? 1 : 0, A);
    const double h = 1e-4;
    Eigen::VectorXd column, unit = Eigen::VectorXd::Zero(cable.size());
    double worst = 0, size = 1e-300;
    for (Eigen::Index j = 0; j < cable.size(); ++j) {
      unit[j] = 1;
      A.multiply(unit, column);
      const auto at = [&](double d) { return by_rates ? force(q, v + d * unit) : force(q + d * unit, v); };
      Eigen::VectorXd slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
      // Damping by mass is in the mass matrix.
      if (by_rates && cable.damping().by_mass() != 0) {
        Eigen::VectorXd momentum;
        cable.mass().multiply(unit, momentum);
        slope += cable.damping().by_mass() * momentum;
      }
      worst = std::max(worst, (column + slope).lpNorm<Eigen::Infinity>());
      size = std::max(size, slope.lpNorm<Eigen::Infinity>());
      unit[j] = 0;
    }
    EXPECT_LE(worst, 2e-8 * size) << what << (by_rates ? " by rates" : " by coordinates");
  }
}

Case free_cable(int elements) {
  Case spec = pendulum(5, elements);
  spec.supports = {};
  spec.loads = {};
  spec.cable.second_moment = 1e-6;
  return spec;
}

TEST(NonconservativeForces, HaveTheTangentsThatDifferencesShow) {
  for (const LoadKind kind : {LoadKind::force, LoadKind::moment, LoadKind::distributed})
    for (const bool follows : {false, true}) {
      Case spec = free_cable(3);
      spec.loads.applied = {
          {kind, kind == LoadKind::distributed ? 0 : 0.55, {0.3, -0.8, 0.5}, follows, "1 + t"}};
      expect_tangents(spec, fmt::format("{} {}", word(kind), follows ? "that follows" : "that does not"));
    }
  for (const StrainModel strain : {StrainModel::green_geometric, StrainModel::engineering_material})
    for (const QuadratureRule rule : {QuadratureRule::full, QuadratureRule::reduced}) {
      Case spec = free_cable(3);
      spec.cable.strain = strain;
      spec.cable.quadrature = rule;
      spec.damping = {.mass = 0.4, .material = 0.02};
      expect_tangents(spec, fmt::format("damping, {}, {}", word(strain), word(rule)));
      spec.cable.youngs_modulus *= 1e-9;
      spec.cable.second_moment *= 1e9;
      expect_tangents(spec, fmt::format("damping of bending, {}, {}", word(strain), word(rule)));
    }
  Case chain = free_cable(3);
  chain.cable.model = CableModel::chain;
  chain.damping = {.material = 0.02};
  chain.loads.applied = {{LoadKind::force, 0.7, {0.3, -0.8, 0.5}, true, "1"},
                         {LoadKind::distributed, 0, {0.3, 0.1, 0.5}, true, "1"}};
  expect_tangents(chain, "a chain");
}

TEST(NonconservativeForces, OfDampingTakeNothingFromARigidMotionAndNoMomentumFromAny) {
  Case spec = free_cable(4);
  spec.damping.material = 0.05;
  const Cable cable(spec);
  const Eigen::VectorXd q = bent(cable);
  const Vec3 speed(0.3, -0.2, 0.7), turn(1.1, 0.4, -0.6);
  Eigen::VectorXd rigid(cable.size());
  for (int node = 0; node < cable.nodes(); ++node) {
    rigid.segment<3>(6 * node) = speed + turn.cross(Vec3(q.segment<3>(6 * node)));
    rigid.segment<3>(6 * node + 3) = turn.cross(Vec3(q.segment<3>(6 * node + 3)));
  }
  const Eigen::VectorXd other = scattered(cable.size(), 3);
  Eigen::VectorXd still = Eigen::VectorXd::Zero(cable.size()), damped = still;
  cable.add_other_forces(0, 1, q, rigid, still);
  cable.add_other_forces(0, 1, q, other, damped);
  EXPECT_LE(still.norm(), 1e-12 * damped.norm());
  EXPECT_LE(std::abs(damped.dot(rigid)), 1e-12 * damped.norm() * rigid.norm());
  EXPECT_LT(damped.dot(other), -1e-3 * damped.norm()) << damped.dot(other) << " W";
}

TEST(NonconservativeForces, OfAMomentWorkOnARotationAsTheMomentDoesOnTheAngle) {
  Case spec = free_cable(3);
  const Vec3 moment(0.2, -0.5, 0.9), turn(1.1, 0.4, -0.6);
  spec.loads.applied = {{LoadKind::moment, 1, moment, false, "1"}};
  const Cable cable(spec);
  const Eigen::VectorXd q = bent(cable);
  Eigen::VectorXd rigid(cable.size());
  for (Eigen::Index i = 0; i < cable.size(); i += 3) rigid.segment<3>(i) = turn.cross(Vec3(q.segment<3>(i)));
  const Vec3 t = q.tail<3>().normalized();
  const double work = cable.other_work(0, q, rigid, rigid).supplied;
  EXPECT_NEAR(work, (moment - t.dot(moment) * t).dot(turn), 1e-13) << t.transpose();
}

TEST(NonconservativeForces, ThatFollowTurnByTheShortestRotation) {
  Case spec = free_cable(1);
  spec.start.direction = {1, 0, 0};
  spec.loads.applied = {{LoadKind::force, 1, {0.2, 1, -0.4}, true, "1"}};
  const Cable cable(spec);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-0.6, 0, 0.8), Vec3(-1, 1e-3, 0)}) {
    Eigen::VectorXd q = cable.start_q(spec.start), f = Eigen::VectorXd::Zero(cable.size());
    q.tail<3>() = 1.3 * direction;
    cable.add_other_forces(0, 1, q, Eigen::VectorXd::Zero(cable.size()), f);
    const Vec3 expected = Eigen::Quaterniond::FromTwoVectors(Vec3(1, 0, 0), direction) * Vec3(0.2, 1, -0.4);
    const Vec3 seen = f.tail<6>().head<3>();
    // The other one loses digits near half a turn.
    EXPECT_LE((seen - expected).norm(), 1e-9) << direction.transpose() << ": " << seen.transpose();
  }
}

TEST(PointMasses, AreInTheMassMatrixItsInverseAndItsEnergyAlike) {
  for (const Support last : {Support::free, Support::clamped})
    for (const int elements : {1, 2, 5, 80}) {
      Case spec = free_cable(elements);
      spec.supports = {Support::pinned, last};
      spec.cable.density *= 1e3;
      spec.masses = {{1, 3}, {0.37, 0.2}, {0.5, 5}, {0.02, 1}};
      const Cable cable(spec);
      BlockTridiagonal M(cable.nodes());
      cable.system(cable.start_q(spec.start), 1, 0, M);
      Eigen::VectorXd v = scattered(cable.size(), 4), momentum, product;
      cable.supports().apply(v);
      M.multiply(v, momentum);
      cable.mass().multiply(v, product);
      EXPECT_LE((momentum - product).norm(), 1e-13 * momentum.norm()) << elements << " elements";
      EXPECT_NEAR(cable.mass().kinetic_energy(v), 0.5 * v.dot(product), 1e-13 * v.dot(product));
      cable.supports().apply(product);
      Eigen::VectorXd scratch;
      cable.mass().solve(product, scratch);
      EXPECT_LE((product - v).norm(), 1e-9 * v.norm()) << elements << " elements";
      Eigen::VectorXd one = Eigen::VectorXd::Zero(cable.size());
      for (int node = 0; node < cable.nodes(); ++node) one[6 * node] = 1;
      cable.mass().multiply(one, product);
      EXPECT_NEAR(one.dot(product), spec.cable.density * spec.cable.area * spec.cable.length + 9.2, 1e-12);
    }
}

}  // namespace nonconservative_test
}  // namespace plumb
