#include "engine/model/support_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/integrate/dynamics.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"
#include "tests/engine/scattered.h"

namespace plumb {
namespace support_motion_test {

/// A damped cable with loads of all kinds, whose first end goes and turns and whose last one goes its own
/// way.
Case moved_cable() {
  Case spec = pendulum(5, 3);
  spec.cable.second_moment = 1e-6;
  spec.parameters = {{"w", 3.0}};
  spec.supports = {.first = Support::clamped,
                   .last = Support::pinned,
                   .first_motion = MotionSpec{"0.1*sin(w*t)", "0.2*t^2", "0.3*t"},
                   .last_motion = MotionSpec{"-0.1*t", "0", "0.2*(1-cos(w*t))"},
                   .first_rotation = RotationSpec{Vec3(1, 2, -2) / 3, "w*t+0.4*t^2"}};
  spec.loads.end_force = {0.1, 0, 0.2};
  spec.loads.applied = {{LoadKind::force, 0.55, {0.3, -0.8, 0.5}, true, "1+t"},
                        {LoadKind::moment, 0.7, {0, 0.02, 0.01}, true, "1"},
                        {LoadKind::distributed, 0, {0.1, 0.2, 0}, false, "cos(t)"}};
  spec.masses = {{0.4, 0.01}};
  spec.damping = {0.7, 2e-3};
  return spec;
}

Eigen::VectorXd bent(const Cable& cable, double seed) {
  return cable.start_q({}) + 0.1 * scattered(cable.size(), seed);
}

TEST(MovedSupports, TakeTheHeldEndsWhereTheyAreSaidToGo) {
  const Case spec = moved_cable();
  const Cable cable(spec);
  for (const double t : {0.0, 0.4, 1.1}) {
    Eigen::VectorXd q = cable.start_q(spec.start), v = Eigen::VectorXd::Zero(cable.size());
    cable.motion().at(t).to_ground(q, v);
    const Vec3 first(0.1 * std::sin(3 * t), 0.2 * t * t, 0.3 * t);
    const Vec3 last(1 - 0.1 * t, 0, 0.2 * (1 - std::cos(3 * t)));
    EXPECT_LE((q.head<3>() - first).norm(), 1e-15) << t;
    EXPECT_LE((q.segment<3>(q.size() - 6) - last).norm(), 2e-15) << t;
    EXPECT_LE((v.head<3>() - Vec3(0.3 * std::cos(3 * t), 0.4 * t, 0.3)).norm(), 1e-15) << t;
    EXPECT_LE((v.segment<3>(v.size() - 6) - Vec3(-0.1, 0, 0.6 * std::sin(3 * t))).norm(), 5e-15) << t;
    const Vec3 axis = Vec3(1, 2, -2) / 3, slope = q.segment<3>(3);
    EXPECT_NEAR(slope.norm(), 1, 1e-15);
    EXPECT_NEAR(slope.dot(axis), axis.x(), 1e-15) << "it turns about the axis";
    EXPECT_LE((v.segment<3>(3) - (3 + 0.8 * t) * axis.cross(slope)).norm(), 3e-15) << t;
  }
}

TEST(MovedSupports, AreLeftAndEnteredByTheSameWay) {
  const Cable cable(moved_cable());
  const Eigen::VectorXd q = bent(cable, 1), v = scattered(cable.size(), 2);
  Eigen::VectorXd there = q, rates = v;
  const MovedSupports moved = cable.motion().at(0.8);
  moved.to_ground(there, rates);
  EXPECT_GT((there - q).norm(), 1);
  moved.to_relative(there, rates);
  EXPECT_LE((there - q).norm(), 1e-14);
  EXPECT_LE((rates - v).norm(), 2e-14);
}

/// Coordinates of the ground at t, of a relative motion q + v s + a s²/2 at s = t - t0, and their rates.
struct Path {
  const Cable& cable;
  double t0;
  Eigen::VectorXd q, v, a;

  State relative(double t) const {
    const double s = t - t0;
    return {t, q + s * v + 0.5 * s * s * a, v + s * a};
  }
  State ground(double t) const {
    State state = relative(t);
    cable.motion().at(t).to_ground(state.q, state.v);
    return state;
  }
};

TEST(MovedSupports, HaveTheRatesAndAccelerationsThatDifferencesShow) {
  const Cable cable(moved_cable());
  const Path path{cable, 0.6, bent(cable, 1), scattered(cable.size(), 2), scattered(cable.size(), 3)};
  constexpr double h = 1e-3;
  const auto difference = [&](auto of) -> Eigen::VectorXd {
    return (8 * (of(0.6 + h) - of(0.6 - h)) - (of(0.6 + 2 * h) - of(0.6 - 2 * h))) / (12 * h);
  };
  const Eigen::VectorXd rates = difference([&](double t) { return path.ground(t).q; });
  EXPECT_LE((rates - path.ground(0.6).v).norm(), 1e-8);
  const MovedSupports moved = cable.motion().at(0.6);
  Eigen::VectorXd q = path.q, v = path.v;
  moved.add_last(q);
  moved.add_last_rate(v);
  Eigen::VectorXd expected = path.a + moved.accelerations(q, v);
  turn_vectors(moved.turn, expected);
  const Eigen::VectorXd accelerations = difference([&](double t) { return path.ground(t).v; });
  EXPECT_LE((accelerations - expected).norm(), 1e-8 * expected.norm());
}

// Of the motion that the forces make: what is supplied less what is dissipated is the change of energy.
TEST(MovedSupports, SupplyWhatTheEnergyGrowsBy) {
  for (const bool turns : {true, false}) {
    Case spec = moved_cable();
    if (!turns) spec.supports.first_rotation.reset();
    const Cable cable(spec);
    Path path{cable,
              0.6,
              cable.start_q(spec.start) + 1e-3 * scattered(cable.size(), 1),
              scattered(cable.size(), 2),
              {}};
    cable.supports().apply(path.v);
    path.q.head<3>().setZero();
    path.q.segment<3>(3) = Vec3(1, 0, 0);
    path.q.segment<3>(cable.size() - 6) = Vec3(1, 0, 0);
    path.a.resize(cable.size());
    Dynamics(cable).acceleration(path.relative(0.6), path.a);
    constexpr double h = 1e-6;
    const auto energy = [&](double t) {
      const State ground = path.ground(t), relative = path.relative(t);
      return cable.energies(ground.q, ground.v).total() - cable.carried_momentum(t, relative.q, relative.v);
    };
    const double growth =
        (8 * (energy(0.6 + h) - energy(0.6 - h)) - (energy(0.6 + 2 * h) - energy(0.6 - 2 * h))) / (12 * h);
    const Work power = cable.power(0.6, path.q, path.v);
    EXPECT_GT(std::abs(growth), 0.1);
    EXPECT_NEAR(growth, power.supplied - power.dissipated, 1e-6 * std::abs(growth)) << turns;
  }
}

TEST(MovedSupports, GiveForcesWithTheTangentsThatDifferencesShow) {
  const Cable cable(moved_cable());
  const Eigen::VectorXd q = bent(cable, 1), v = scattered(cable.size(), 2);
  Dynamics dynamics(cable);
  const auto force = [&](const Eigen::VectorXd& at, const Eigen::VectorXd& rates) {
    Eigen::VectorXd f;
    dynamics.free_force(at, f, {0.6, rates.data()});
    return f;
  };
  const double h = 1e-4;
  for (const bool by_rates : {false, true}) {
    GeneralBlockTridiagonal<double> A(cable.nodes());
    dynamics.general_system(q, 0, by_rates ? 0 : 1, {0.6, v.data()}, by_rates ? 1 : 0, A);
    Eigen::VectorXd column, unit = Eigen::VectorXd::Zero(cable.size());
    double worst = 0, size = 1e-300;
    for (Eigen::Index j = 0; j < cable.size(); ++j) {
      unit[j] = 1;
      A.multiply(unit, column);
      const auto at = [&](double d) { return by_rates ? force(q, v + d * unit) : force(q + d * unit, v); };
      const Eigen::VectorXd slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
      worst = std::max(worst, (column + slope).lpNorm<Eigen::Infinity>());
      size = std::max(size, slope.lpNorm<Eigen::Infinity>());
      if (by_rates) {
        Eigen::VectorXd product = Eigen::VectorXd::Zero(cable.size());
        dynamics.add_rate_product(0.6, q, unit, 1, product);
        EXPECT_LE((product - column).norm(), 1e-12 * (1 + column.norm())) << j;
      }
      unit[j] = 0;
    }
    EXPECT_LE(worst, 1e-8 * size) << (by_rates ? "by rates" : "by coordinates");
  }
}

}  // namespace support_motion_test
}  // namespace plumb
