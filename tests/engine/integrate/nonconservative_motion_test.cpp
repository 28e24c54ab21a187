#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "engine/model/cable.h"
#include "tests/engine/integrate/expected_order.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace nonconservative_motion_test {

/// A cantilever along x of length 1 and EI = 1 that hardly stretches.
Case elastica(int elements) {
  Case spec;
  spec.title = "elastica";
  spec.cable = {.length = 1,
                .area = 1,
                .density = 1,
                .youngs_modulus = 1e8,
                .second_moment = 1e-8,
                .elements = elements,
                .strain = StrainModel::engineering_material,
                .quadrature = QuadratureRule::reduced};
  spec.supports.first = Support::clamped;
  return spec;
}

Trajectory settle(const Case& spec, int load_steps) {
  return run(spec, method("statics", 1.0 / load_steps), {1, 1});
}

double tip_turn(const Trajectory& trajectory) {
  const Vec3 slope = trajectory.q.back().tail<3>();
  return std::atan2(slope.y(), slope.x());
}

void expect_tip(const Trajectory& trajectory, const Vec3& expected, double tolerance,
                const std::string& what) {
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << what << ": " << trajectory.message;
  EXPECT_LE((tip(trajectory) - expected).norm(), tolerance)
      << what << ": " << fmt::format("{:.7f}, {:.7f}", tip(trajectory).x(), tip(trajectory).y());
}

// Of the inextensible cantilever under q = K EI/L³, by shooting.
TEST(DistributedLoad, BendsACantileverAsItsWeightDoesAndAsTheElastica) {
  for (const auto& [K, x, y] : {std::tuple{1.0, .991246, .123471},
                                {5.0, .846657, .495905},
                                {13.0, .573886, .759135},
                                {25.0, .386160, .855900}}) {
    Case spec = elastica(64);
    spec.loads.applied = {{LoadKind::distributed, 0, {0, K, 0}, false, "1"}};
    const Trajectory by_load = settle(spec, 10);
    expect_tip(by_load, {x, y, 0}, 1e-5, fmt::format("K = {}, a load", K));
    spec.loads = {.gravity = {0, K, 0}, .end_force = {0, 0, 0}, .applied = {}};
    const Trajectory by_weight = settle(spec, 10);
    expect_tip(by_weight, {x, y, 0}, 1e-5, fmt::format("K = {}, its weight", K));
    EXPECT_LE(tip_distance(by_load, by_weight), 1e-12);
  }
}

TEST(DistributedLoad, ThatStaysAcrossTheCableBendsItAsTheElastica) {
  for (const auto& [K, x, y] :
       {std::tuple{1.0, .991104, .124444}, {5.0, .795523, .560423}, {13.0, .098058, .842994}}) {
    Case spec = elastica(64);
    spec.loads.applied = {{LoadKind::distributed, 0, {0, K, 0}, true, "1"}};
    for (const int load_steps : {1, 20})
      expect_tip(settle(spec, load_steps), {x, y, 0}, 1e-5, fmt::format("K = {}, {} steps", K, load_steps));
  }
}

TEST(TipForce, ThatStaysAcrossTheTipBendsACantileverAsTheElastica) {
  for (const auto& [a, x, y, turn] : {std::tuple{1.0, .935646, .320642, .495885},
                                      {2.0, .767362, .573839, .968239},
                                      {4.0, .342746, .786168, 1.776436},
                                      {8.0, -.073863, .633592, 2.756554}}) {
    Case spec = elastica(64);
    spec.loads.applied = {{LoadKind::force, 1, {0, a, 0}, true, "1"}};
    for (const int load_steps : {1, 20}) {
      const Trajectory trajectory = settle(spec, load_steps);
      expect_tip(trajectory, {x, y, 0}, 1e-5, fmt::format("a = {}, {} steps", a, load_steps));
      EXPECT_NEAR(tip_turn(trajectory), turn, 1e-5) << "a = " << a;
    }
  }
}

TEST(EndMoment, RollsACantileverUpIntoACircle) {
  for (const bool follows : {false, true})
    for (const double share : {0.25, 0.5, 1.0}) {
      Case spec = elastica(256);
      spec.cable.youngs_modulus = 1e6;
      spec.cable.second_moment = 1e-6;
      const double angle = 2 * std::numbers::pi * share;
      spec.loads.applied = {{LoadKind::moment, 1, {0, 0, angle}, follows, "1"}};
      expect_tip(settle(spec, 20), {std::sin(angle) / angle, (1 - std::cos(angle)) / angle, 0}, 1e-6,
                 fmt::format("{} of a circle, follows: {}", share, follows));
    }
}

// A rod of 1 m and a radius of 5 mm with E = 1e9, from a quarter of a circle to three times round.
TEST(EndMoment, RollsUpARodThatStretchesAsWellAsOneThatDoesNot) {
  Case spec = elastica(256);
  const double r2 = 2.5e-5;
  spec.cable.area = std::numbers::pi * r2;
  spec.cable.second_moment = std::numbers::pi * r2 * r2 / 4;
  spec.cable.youngs_modulus = 1e9;
  for (const double turns : {0.25, 1.0, 3.0}) {
    const double angle = 2 * std::numbers::pi * turns, EI = 1e9 * spec.cable.second_moment;
    spec.loads.applied = {{LoadKind::moment, 1, {0, angle * EI, 0}, false, "1"}};
    expect_tip(settle(spec, 2), {std::sin(angle) / angle, 0, -(1 - std::cos(angle)) / angle}, 1e-6,
               fmt::format("{} turns", turns));
  }
}

TEST(Factor, OfAStaticLoadComesBesideItsGrowth) {
  Case spec = elastica(4);
  spec.parameters = {{"a", 3.0}};
  spec.loads.applied = {{LoadKind::force, 1, {1e6, 0, 0}, false, "a * t"}};
  const Trajectory trajectory = run(spec, method("statics", 0.5), {2, 0.5});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    const double t = trajectory.times[k];
    EXPECT_NEAR(tip(trajectory, k).x(), 1 + 1e-2 * 3 * t * (t / 2), 1e-11) << "t = " << t;
  }
}

TEST(PointMass, OnALineSwingsWithThePeriodOfThePendulum) {
  // From the horizontal at rest: T = 4 K(sin 45°) √(l/g).
  const double period = 4 * std::comp_ellint_1(std::numbers::sqrt2 / 2) / std::sqrt(9.81);
  EXPECT_NEAR(period, 2.36784, 5e-6);
  for (const CableModel model : {CableModel::chain, CableModel::rigid}) {
    Case spec = pendulum(1, 1);
    spec.cable.model = model;
    spec.cable.density = 1e-3;
    spec.cable.youngs_modulus = 1e13;  // three weights stretch it by 3e-6
    spec.start.angular_velocity = {0, 0, 0};
    spec.masses = {{1, 1}};
    const bool stiff = model == CableModel::chain;
    const Trajectory trajectory = run(spec, method(stiff ? "gauss" : "rk4", 1e-3), {period, period / 4});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    for (const auto& [output, x, y] : {std::tuple{1, 0.0, -1.0}, {2, -1.0, 0.0}, {4, 1.0, 0.0}}) {
      const Vec3 at = tip(trajectory, static_cast<std::size_t>(output));
      EXPECT_LE((at - Vec3(x, y, 0)).norm(), 2e-5) << word(model) << ": " << at.transpose();
    }
  }
}

/// sn(x, k), by descending Landen transformations.
double jacobi_sn(double x, double k) {
  if (k < 1e-9) return std::sin(x);
  const double other = std::sqrt(1 - k * k), next = (1 - other) / (1 + other);
  const double sn = jacobi_sn(x / (1 + next), next);
  return (1 + next) * sn / (1 + next * sn * sn);
}

// Pendulum A01 of the library of multibody benchmarks: over 2,000 s no output is 1e-3 m off, its higher rule.
TEST(PointMass, OnARodKeepsItsTimeOverAThousandSwings) {
  Case spec = pendulum(1, 1);
  spec.cable.model = CableModel::rigid;
  spec.cable.density = 1e-9;
  spec.start.angular_velocity = {0, 0, 0};
  spec.masses = {{1, 1}};
  const Trajectory trajectory = run(spec, method("rk4", 0.01), {2000, 0.5});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  ASSERT_EQ(trajectory.times.size(), 4001U);
  const double k = std::numbers::sqrt2 / 2, quarter = std::comp_ellint_1(k), omega = std::sqrt(9.81);
  double worst = 0;
  for (std::size_t n = 0; n < trajectory.times.size(); ++n) {
    const double phase = std::fmod(omega * trajectory.times[n] + quarter, 4 * quarter);
    const double turn = 2 * std::asin(k * jacobi_sn(phase, k));
    worst = std::max(worst, (tip(trajectory, n) - Vec3(std::sin(turn), -std::cos(turn), 0)).norm());
  }
  EXPECT_LE(worst, 1e-3);
  EXPECT_GT(worst, 0);
}

// A bead in the middle of a taut line that weighs next to nothing: ω² = 4 T/(m L).
TEST(PointMass, OnATautLineSwingsAsABeadDoes) {
  Case spec = elastica(2);
  spec.cable.model = CableModel::chain;
  spec.supports = {Support::pinned, Support::pinned};
  spec.cable.density = 1e-9;
  spec.cable.youngs_modulus = 1e3;
  spec.start.stretch = 1.25;  // T = 250 N over 1.25 m
  spec.masses = {{0.5, 2}};
  spec.loads.applied = {{LoadKind::force, 0.5, {0, 1e-4, 0}, false, "1"}};
  const double omega = std::sqrt(4 * 250 / (2 * 1.25)), period = 2 * std::numbers::pi / omega;
  const Trajectory trajectory = run(spec, method("implicit-midpoint", period / 4000), {period, period / 4});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  // Of a force set on at once: 1 - cos ωt.
  const double rest = 1e-4 / (2 * omega * omega);
  for (std::size_t k = 0; k < trajectory.times.size(); ++k)
    EXPECT_NEAR(trajectory.q[k][7], rest * (1 - std::cos(omega * trajectory.times[k])), 2e-5 * rest) << k;
}

// 1e5 kg at 10 m to the side and 100 m below, on a line of 7.854 kg/m with EA = 1e9 (MoorDyn's case).
TEST(PointMass, ThatIsHeavySwingsOnALongLineAsItsPendulumDoes) {
  Case spec = elastica(10);
  spec.cable = {.length = std::hypot(10, 100),
                .area = 1e-3,
                .density = 7854,
                .youngs_modulus = 1e12,
                .second_moment = 0,
                .elements = 10,
                .strain = StrainModel::engineering_material};
  spec.supports = {Support::pinned, Support::free};
  spec.start.direction = Vec3(10, 0, -100).normalized();
  spec.start.stretch = 1 + 1e5 * 9.81 / 1e9;
  spec.loads.gravity = {0, 0, -9.81};
  spec.masses = {{1, 1e5}};
  const double period = 2 * std::numbers::pi * std::sqrt(spec.cable.length / 9.81);
  const Trajectory trajectory = run(spec, method("generalized-alpha", period / 2000), {period, period / 4});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  EXPECT_LE((tip(trajectory) - tip(trajectory, 0)).norm(), 0.01 * spec.cable.length);
  EXPECT_NEAR(tip(trajectory, 2).x(), -10, 0.1);
  EXPECT_NEAR(tip(trajectory, 1).x(), 0, 0.5);
}

TEST(Stretch, StartsStraightWithTheForceOfIt) {
  Case spec = elastica(3);
  spec.start.stretch = 1.1;
  spec.supports = {Support::pinned, Support::pinned};
  const Cable cable(spec);
  const Eigen::VectorXd q = cable.start_q(spec.start);
  EXPECT_NEAR(q.tail<6>()[0], 1.1, 1e-15);
  Eigen::VectorXd f;
  ASSERT_EQ(cable.force(q, f), std::nullopt);
  EXPECT_NEAR(f[0], 1e8 * 0.1, 1e-3);
  EXPECT_LE(f.segment<3>(6).norm(), 1e-6);
  const Trajectory still = run(spec, method("rk4", 1e-6), {1e-4, 1e-4});
  EXPECT_LE((still.q.back() - q).norm(), 1e-13) << still.message;
}

/// A pendulum that is driven, by a force that follows and one that does not; or damped, in a plane, as a
/// cable without torsion has no smooth rate of bending where it is straight in space.
Case driven(bool damped) {
  Case spec = pendulum(5, 2);
  spec.parameters = {{"w", 9.0}};
  spec.cable.youngs_modulus *= 0.1;
  spec.masses = {{0.7, 2e-3}};
  spec.loads.applied = {{LoadKind::force, 1, {0, 2e-3, 1e-3}, true, "sin(w * t)"},
                        {LoadKind::distributed, 0, {0, 0, 4e-3}, false, "cos(3 * t)"}};
  if (!damped) return spec;
  spec.damping = {.mass = 0.8, .material = 3e-3};
  spec.start.angular_velocity = {0, 0, 4};
  spec.loads.applied[0].value = {0, 2e-3, 0};
  spec.loads.applied[1].value = {4e-3, 0, 0};
  return spec;
}

const TimeSpec short_time{0.4, 0.02};

/// Of the Gauss method, which the others have no code in common with but the forces.
const Trajectory& true_motion(bool damped) {
  static const Trajectory free_of_it = run(driven(false), method("gauss", 5e-4), short_time);
  static const Trajectory damped_motion = run(driven(true), method("gauss", 5e-4), short_time);
  return damped ? damped_motion : free_of_it;
}

TEST(DrivenPendulum, HasTheSameMotionByTwoUnlikeMethods) {
  for (const bool damped : {false, true}) {
    const Trajectory other = run(driven(damped), method("arkode-erk", 1e-4), short_time);
    ASSERT_EQ(other.outcome, Outcome::completed) << other.message;
    EXPECT_LE(tip_distance(other, true_motion(damped)), 1e-10) << damped;
  }
}

TEST(DrivenPendulum, IsIntegratedAtTheOrderOfEachMethod) {
  for (const bool damped : {false, true})
    for (const ExpectedOrder& expected : expected_orders) {
      const auto error = [&](const Trajectory& run) { return tip_distance(run, true_motion(damped)); };
      if (!damped || find_method(expected.name)->takes_damping)
        expect_order(expected, driven(damped), short_time, error, damped ? "damped" : "not damped");
    }
}

TEST(DrivenPendulum, IsIntegratedToTheToleranceOfEachMethodThatHasOne) {
  for (const bool damped : {false, true})
    for (const char* name : {"cvode-adams", "cvode-bdf", "ida", "arkode-erk", "arkode-dirk"}) {
      const Trajectory trajectory = run(driven(damped), method(name, {}, 1e-9), short_time);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << name << trajectory.message;
      EXPECT_LE(tip_distance(trajectory, true_motion(damped)), 2e-6) << name << ", damped: " << damped;
    }
}

TEST(EnergyBalance, HoldsWhatLoadsDoAndDampingTakes) {
  for (const bool damped : {false, true}) {
    const Trajectory& trajectory = true_motion(damped);
    const Energies& last = trajectory.energies.back();
    EXPECT_LE(trajectory.relative_energy_drift(), 1e-9) << damped;
    EXPECT_GT(std::abs(last.work), 1e-5);
    EXPECT_EQ(last.dissipated > 1e-4, damped) << last.dissipated << " J";
  }
}

TEST(EnergyBalance, IsKeptByTheMethodThatKeepsItAtAnyStep) {
  for (const bool damped : {false, true})
    for (const double h : {1e-3, 1e-2}) {
      const Trajectory trajectory = run(driven(damped), method("energy-momentum", h), short_time);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
      EXPECT_LE(trajectory.relative_energy_drift(), 1e-9) << "h = " << h << ", damped: " << damped;
    }
}

TEST(Momentum, OfAFreeCableGrowsByItsLoad) {
  Case spec = driven(true);
  spec.damping.mass = 0;
  spec.supports = {};
  spec.loads.gravity = {0, 0, 0};
  spec.loads.applied = {{LoadKind::force, 0.3, {1e-3, 2e-3, -1e-3}, false, "1"},
                        {LoadKind::distributed, 0, {0, 0, 4e-3}, false, "2 * t"},
                        {LoadKind::moment, 0.5, {0, 1e-6, 0}, true, "1"}};
  const Cable cable(spec);
  Eigen::VectorXd field = Eigen::VectorXd::Zero(cable.size()), momentum;
  // A load that rises is met by generalized-alpha between the ends of its steps.
  for (const auto& [name, tolerance] :
       {std::pair{"rk4", 1e-9}, {"generalized-alpha", 1e-6}, {"gauss", 1e-9}, {"energy-momentum", 1e-9}}) {
    const Trajectory trajectory = run(spec, method(name, 1e-3), {0.4, 0.4});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << name << trajectory.message;
    const Eigen::VectorXd change = trajectory.v.back() - trajectory.v.front();
    cable.mass().multiply(change, momentum);
    Vec3 sum = Vec3::Zero();
    for (int node = 0; node < cable.nodes(); ++node) sum += momentum.segment<3>(6 * node);
    const Vec3 expected(0.4e-3, 0.8e-3, -0.4e-3 + 4e-3 * 0.16);
    EXPECT_LE((sum - expected).norm(), tolerance * expected.norm()) << name << ": " << sum.transpose();
  }
}

/// The slowest vibration across a cable along x that is clamped at its first end, by inverse iteration.
Eigen::VectorXd first_shape(const Cable& cable) {
  Eigen::VectorXd straight = Eigen::VectorXd::Zero(cable.size()), shape = straight, inertia;
  for (int node = 0; node < cable.nodes(); ++node) {
    straight[6 * node] = cable.element().length() * node;
    straight[6 * node + 3] = 1;
    shape[6 * node + 1] = straight[6 * node] * straight[6 * node];
    shape[6 * node + 4] = 2 * straight[6 * node];
  }
  Dynamics dynamics(cable);
  // By the mass the matrix is regular along the cable too.
  EXPECT_EQ(dynamics.factor(straight, 1e-9, 1), std::nullopt);
  for (int i = 0; i < 30; ++i) {
    cable.mass().multiply(shape, inertia);
    cable.supports().apply(inertia);
    dynamics.solve(inertia);
    shape = inertia / inertia.lpNorm<Eigen::Infinity>();
  }
  return shape;
}

// Of Kelvin and Voigt's material a vibration of ω decays as exp(-τω²t/2), by mass as exp(-αt/2).
TEST(Damping, OfASmallVibrationIsThatOfItsFrequency) {
  for (const auto& [alpha, tau] : {std::pair{2.0, 0.0}, {0.0, 0.02}}) {
    Case spec = pendulum(5, 4);
    spec.loads = {};
    spec.supports.first = Support::clamped;
    spec.start.angular_velocity = {0, 0, 0};
    spec.cable.second_moment *= 1e4;
    spec.damping = {alpha, tau};
    const Cable cable(spec);
    State start{0, cable.start_q(spec.start), first_shape(cable)};
    start.v *= 1e-5;
    const double omega = 3.51601527 * std::sqrt(spec.cable.youngs_modulus * spec.cable.second_moment / 8e-3);
    const double damped = std::sqrt(omega * omega - 0.25 * std::pow(alpha + tau * omega * omega, 2));
    const double period = 2 * std::numbers::pi / damped;
    const Trajectory trajectory =
        integrate(cable, start, method("gauss", period / 200), {3 * period, period});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    const auto speed = [&](std::size_t k) { return trajectory.v[k].tail<6>()[1]; };
    const double expected = std::exp(-0.5 * (alpha + tau * omega * omega) * period);
    EXPECT_NEAR(speed(3) / speed(2), expected, 2e-3) << "α " << alpha << ", τ " << tau << ", ω " << omega;
  }
}

}  // namespace nonconservative_motion_test
}  // namespace plumb
