#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "engine/model/cable.h"
#include "engine/model/support_constraints.h"
#include "tests/engine/integrate/expected_order.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace moving_supports_test {

const TimeSpec short_time{0.4, 0.02};

/// How the supports of a cable move.
enum class Kind {
  carried,  ///< the first end goes its way, the last one is free
  pulled,   ///< both ends go their ways
  turned,   ///< the first end goes and turns, the last one is free
};

std::string in_words(Kind kind) {
  return kind == Kind::carried ? "carried" : kind == Kind::pulled ? "pulled" : "turned";
}

/// A damped cable under its weight and a load that changes. It moves in a plane, as a cable without torsion
/// has no smooth rate of bending where it is straight in space.
Case moved(Kind kind) {
  Case spec = pendulum(5, 2);
  spec.parameters = {{"w", 9.0}};
  spec.cable.youngs_modulus *= 0.1;
  spec.start.angular_velocity = {0, 0, 0};
  spec.masses = {{0.7, 2e-3}};
  spec.loads.applied = {{LoadKind::distributed, 0, {4e-3, 0, 0}, false, "cos(3 * t)"}};
  spec.damping = {0.8, 3e-3};
  spec.supports.first_motion = MotionSpec{"0.05*sin(w*t)", "0.1*t-0.3*t^2", "0"};
  if (kind == Kind::pulled) {
    spec.supports.last = Support::pinned;
    spec.supports.last_motion = MotionSpec{"-0.1*(1-cos(w*t))", "-0.2*t^2", "0"};
  }
  if (kind == Kind::turned) {
    spec.supports.first = Support::clamped;
    spec.supports.first_rotation = RotationSpec{{0, 0, 1}, "0.6*sin(w*t)-t"};
  }
  return spec;
}

/// By a method that the others have no code in common with but the forces.
const Trajectory& true_motion(Kind kind) {
  static const auto all = [] {
    std::map<Kind, Trajectory> result;
    for (const Kind each : {Kind::carried, Kind::pulled, Kind::turned})
      result[each] = run(moved(each), method("gauss", 5e-4), short_time);
    return result;
  }();
  return all.at(kind);
}

double distance(const Trajectory& a, const Trajectory& b) {
  double worst = a.times == b.times ? 0 : 1e300;
  for (std::size_t k = 0; k < std::min(a.q.size(), b.q.size()); ++k)
    worst = std::max(worst, (a.q[k] - b.q[k]).segment<3>(6).norm() + (tip(a, k) - tip(b, k)).norm());
  return worst;
}

TEST(MovingSupports, MakeTheSameMotionByTwoUnlikeMethods) {
  for (const Kind kind : {Kind::carried, Kind::pulled, Kind::turned}) {
    const Trajectory other = run(moved(kind), method("arkode-erk", 1e-4), short_time);
    ASSERT_EQ(other.outcome, Outcome::completed) << in_words(kind) << other.message;
    EXPECT_LE(distance(other, true_motion(kind)), 1e-10) << in_words(kind);
  }
}

TEST(MovingSupports, AreIntegratedAtTheOrderOfEachMethod) {
  for (const Kind kind : {Kind::carried, Kind::pulled, Kind::turned})
    for (const ExpectedOrder& expected : expected_orders) {
      const auto error = [&](const Trajectory& run) { return distance(run, true_motion(kind)); };
      if (takes(*find_method(expected.name), moved(kind)))
        expect_order(expected, moved(kind), short_time, error, in_words(kind));
    }
}

TEST(MovingSupports, AreIntegratedAtOrderEightWithoutDamping) {
  for (const Kind kind : {Kind::carried, Kind::pulled}) {
    Case spec = moved(kind);
    spec.damping = {};
    const Trajectory truth = run(spec, method("gauss", 2.5e-4), short_time);
    std::vector<double> errors;
    for (const double h : {1e-2, 5e-3})
      errors.push_back(distance(run(spec, method("runge-kutta-nystrom", h), short_time), truth));
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 8, 1.5)
        << in_words(kind) << ": " << errors[0] << ", " << errors[1];
  }
}

TEST(MovingSupports, AreIntegratedToTheToleranceOfEachMethodThatHasOne) {
  for (const Kind kind : {Kind::carried, Kind::pulled, Kind::turned})
    for (const char* name : {"cvode-adams", "cvode-bdf", "ida", "arkode-erk", "arkode-dirk"}) {
      const Trajectory trajectory = run(moved(kind), method(name, {}, 1e-9), short_time);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << name << trajectory.message;
      EXPECT_LE(distance(trajectory, true_motion(kind)), 2e-6) << name << ", " << in_words(kind);
    }
}

TEST(MovingSupports, HoldTheEndsWhereTheyAreAtEveryOutputOfEveryMethod) {
  for (const Kind kind : {Kind::pulled, Kind::turned})
    for (const MethodInfo& info : method_infos()) {
      Case spec = moved(kind);
      if (!info.takes_damping) spec.damping = {};
      if (!info.dynamic || !takes(info, spec)) continue;
      const Trajectory trajectory =
          run(spec, info.takes_step ? method(info.name, 1e-3) : method(info.name, {}, 1e-6), {0.1, 0.0123});
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << info.name << trajectory.message;
      for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
        const double t = trajectory.times[k];
        const Eigen::VectorXd &q = trajectory.q[k], &v = trajectory.v[k];
        EXPECT_LE((q.head<3>() - Vec3(0.05 * std::sin(9 * t), 0.1 * t - 0.3 * t * t, 0)).norm(), 1e-14)
            << info.name;
        EXPECT_LE((v.head<3>() - Vec3(0.45 * std::cos(9 * t), 0.1 - 0.6 * t, 0)).norm(), 1e-13) << info.name;
        if (kind == Kind::pulled) {
          EXPECT_LE((tip(trajectory, k) - Vec3(1 - 0.1 * (1 - std::cos(9 * t)), -0.2 * t * t, 0)).norm(),
                    1e-14)
              << info.name;
        } else {
          const double angle = 0.6 * std::sin(9 * t) - t;
          EXPECT_LE(std::abs(q[4] * std::cos(angle) - q[3] * std::sin(angle)), 1e-14) << info.name;
        }
      }
    }
}

TEST(MovingSupports, ThatTurnAreRefusedByMethodsForForcesThatDoNotDependOnRates) {
  for (const MethodInfo& info : method_infos()) {
    if (!info.dynamic) continue;
    Case spec = moved(Kind::turned);
    spec.damping = {};
    const MethodSpec with = info.takes_step ? method(info.name, 1e-3) : method(info.name, {}, 1e-6);
    if (info.takes_rotation)
      EXPECT_EQ(run(spec, with, {0.01, 0.01}).outcome, Outcome::completed) << info.name;
    else
      EXPECT_THROW(run(spec, with, {0.01, 0.01}), std::invalid_argument) << info.name;
  }
  EXPECT_FALSE(find_method("energy-momentum")->takes_rotation);
}

TEST(MovingSupports, DoTheWorkThatIsMissingInTheEnergy) {
  for (const Kind kind : {Kind::carried, Kind::pulled, Kind::turned}) {
    const Trajectory& trajectory = true_motion(kind);
    EXPECT_LE(trajectory.relative_energy_drift(), 1e-9) << in_words(kind);
    EXPECT_GT(std::abs(trajectory.energies.back().work), 1e-4);
    EXPECT_GT(trajectory.energies.back().dissipated, 1e-5);
  }
}

TEST(MovingSupports, KeepTheEnergyBalanceAtAnyStepOfTheMethodThatDoes) {
  for (const Kind kind : {Kind::carried, Kind::pulled})
    for (const double h : {1e-3, 1e-2}) {
      const Trajectory trajectory = run(moved(kind), method("energy-momentum", h), short_time);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
      EXPECT_LE(trajectory.relative_energy_drift(), 1e-9) << in_words(kind) << ", h = " << h;
      const double exact = true_motion(kind).energies.back().work;
      EXPECT_NEAR(trajectory.energies.back().work, exact, 0.2 * std::abs(exact)) << in_words(kind);
    }
}

/// Of a series over equal intervals, by Simpson's rule.
Vec3 integral(const std::vector<Vec3>& series, double interval) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < series.size(); ++k)
    sum += (k == 0 || k + 1 == series.size() ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * series[k];
  return interval / 3 * sum;
}

TEST(MovingSupports, GiveTheMomentumThatTheirReactionsTell) {
  for (const Kind kind : {Kind::carried, Kind::pulled, Kind::turned}) {
    Case spec = moved(kind);
    spec.damping.mass = 0;
    const Cable cable(spec);
    const double interval = 5e-4;
    const Trajectory trajectory = run(spec, method("ida", {}, 1e-10), {0.2, interval});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    std::vector<Vec3> forces;
    for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
      const Eigen::VectorXd& lambda = trajectory.multipliers[k];
      Vec3 force = lambda.head<3>();
      if (kind == Kind::pulled) force += lambda.tail<3>();
      forces.push_back(force + Vec3(4e-3 * std::cos(3 * trajectory.times[k]), -9.81 * (8e-3 + 2e-3), 0));
    }
    Eigen::VectorXd momentum;
    cable.mass().multiply(trajectory.v.back() - trajectory.v.front(), momentum);
    Vec3 gained = Vec3::Zero();
    for (int node = 0; node < cable.nodes(); ++node) gained += momentum.segment<3>(6 * node);
    EXPECT_LE((integral(forces, interval) - gained).norm(), 1e-5 * gained.norm())
        << in_words(kind) << ": " << integral(forces, interval).transpose() << ", " << gained.transpose();
  }
}

// In the frame of a support that is accelerated evenly there is a gravity against it.
TEST(MovingSupports, ThatAreAcceleratedEvenlyAreASupportAtRestUnderMoreWeight) {
  Case lifted = pendulum(5, 4), heavy = lifted;
  lifted.supports.first_motion = MotionSpec{"0", "t^2", "-0.5*t^2"};
  heavy.loads.gravity += Vec3(0, -2, 1);
  const Trajectory a = run(lifted, method("gauss", 1e-3), {0.5, 0.1});
  const Trajectory b = run(heavy, method("gauss", 1e-3), {0.5, 0.1});
  for (std::size_t k = 0; k < b.times.size(); ++k) {
    const double t = b.times[k];
    EXPECT_LE((tip(a, k) - tip(b, k) - Vec3(0, t * t, -0.5 * t * t)).norm(), 1e-11) << t;
  }
}

TEST(MovingSupports, MoveACableTheSameFromEitherEnd) {
  for (const CableModel model : {CableModel::cable, CableModel::chain}) {
    Case from_first = pendulum(5, 4);
    from_first.cable.model = model;
    from_first.start.angular_velocity = {0, 0, 0};
    Case from_last = from_first;
    from_first.supports.first_motion = MotionSpec{"0.1*sin(5*t)", "0.2*t", "0.3*t^2"};
    from_last.supports = {
        .first = Support::free, .last = Support::pinned, .last_motion = from_first.supports.first_motion};
    from_last.start.direction = {-1, 0, 0};
    const Trajectory a = run(from_first, method("gauss", 1e-3), {0.5, 0.1});
    const Trajectory b = run(from_last, method("gauss", 1e-3), {0.5, 0.1});
    for (std::size_t k = 0; k < b.times.size(); ++k)
      EXPECT_LE((tip(a, k) - b.q[k].head<3>() - Vec3(1, 0, 0)).norm(), 1e-10) << word(model) << k;
    EXPECT_GT((tip(a) - tip(a, 0)).norm(), 0.3);
  }
}

// Kane, Ryan and Banerjee's beam that is brought to a steady spin; figures of the linearised motion.
TEST(SpinUp, BendsAndStretchesTheBeamAsPublished) {
  Case spec;
  spec.title = "spin-up";
  spec.cable = {.length = 10,
                .area = 4e-4,
                .density = 3000,
                .youngs_modulus = 7e10,
                .second_moment = 2e-7,
                .elements = 8,
                .strain = StrainModel::engineering_material};
  spec.supports.first = Support::clamped;
  spec.supports.first_rotation =
      RotationSpec{{0, 0, 1}, "t < 15 ? 6/15*(t^2/2+(15/2/pi)^2*(cos(2*pi*t/15)-1)) : 6*t-45"};
  MethodSpec with = method("generalized-alpha", 0.01);
  with.parameters["spectral_radius"] = 0.5;
  const Trajectory trajectory = run(spec, with, {20, 0.02});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  double deepest = 0, when = 0, stretch = 0, count = 0;
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    const double t = trajectory.times[k];
    const double angle = t < 15 ? 0.4 * (t * t / 2 + std::pow(7.5 / std::numbers::pi, 2) *
                                                         (std::cos(2 * std::numbers::pi * t / 15) - 1))
                                : 6 * t - 45;
    const Vec3 at = tip(trajectory, k);
    const double across = at.y() * std::cos(angle) - at.x() * std::sin(angle);
    if (across < deepest) {
      deepest = across;
      when = t;
    }
    if (t < 18) continue;
    stretch += at.x() * std::cos(angle) + at.y() * std::sin(angle) - 10;
    ++count;
  }
  EXPECT_NEAR(deepest, -0.5744, 0.01 * 0.5744) << "at " << when << " s";
  EXPECT_NEAR(when, 6.76, 0.1);
  EXPECT_NEAR(stretch / count, 5.142857e-4, 1e-3 * 5.142857e-4);
}

// A cable between two supports that are brought together hangs in the elastic catenary.
TEST(Statics, FindsTheCatenaryOfSupportsThatAreBroughtTogether) {
  Case spec = pendulum(1, 32);
  spec.cable.youngs_modulus = 1e12;
  spec.cable.second_moment = 1e-17;
  spec.start.angular_velocity = {0, 0, 0};
  spec.supports.last = Support::pinned;
  spec.supports.last_motion = MotionSpec{"-0.2*t", "0", "0"};
  const Trajectory trajectory = run(spec, method("statics", 0.1), {1, 0.5});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  for (const auto& [output, span] : {std::pair{1UL, 0.9}, {2UL, 0.8}}) {
    // 2 a sinh(span / 2a) = 1.
    double low = 0.05, high = 10;
    for (int i = 0; i < 100; ++i) {
      const double a = 0.5 * (low + high);
      (2 * a * std::sinh(span / (2 * a)) > 1 ? low : high) = a;
    }
    const double sag = low * (std::cosh(span / (2 * low)) - 1);
    EXPECT_NEAR(-Cable(spec).at(trajectory.q[output], 0.5).position.y(), sag, 1e-3 * sag) << span;
    EXPECT_EQ(trajectory.v[output].norm(), 0);
  }
}

}  // namespace moving_supports_test
}  // namespace plumb
