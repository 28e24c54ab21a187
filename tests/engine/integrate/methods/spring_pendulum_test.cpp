#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace spring_pendulum_test {

/// The stiff spring pendulum of Kuhl and Crisfield (1999) as a chain of one link: 10.0005 kg at the end, 7.72
/// m/s across, no gravity.
Case spring_pendulum(double axial_stiffness) {
  Case spec;
  spec.title = "spring pendulum";
  spec.cable.length = 3.0443;
  spec.cable.area = 1;
  spec.cable.density = 6.57;
  spec.cable.youngs_modulus = axial_stiffness;
  spec.cable.elements = 1;
  spec.cable.model = CableModel::chain;
  spec.start.angular_velocity = {0, 0, 7.72 / 3.0443};
  spec.supports.first = Support::pinned;
  return spec;
}

Trajectory swing(const Case& spec, const MethodSpec& with, double end) {
  return run(spec, with, {end, *with.step});
}

MethodSpec generalized_alpha(double rho, double h) {
  MethodSpec with = method("generalized-alpha", h);
  with.parameters["spectral_radius"] = rho;
  with.parameters["mean_forces"] = 1;
  return with;
}

// The times after which an independent program for the same rule and pendulum saw more than one and a half
// times the first energy. That of h = 0.01 s depends on what Newton's iteration leaves over: with 1e-12 of
// the length it is 5.84 s, with 1e-13 and below it stays.
TEST(SpringPendulum, TrapezoidalRuleGainsHalfOfTheEnergyAtTheKnownTimes) {
  for (const auto& [h, onset] : {std::pair{0.2, 1.2}, {0.1, 1.4}, {0.05, 1.8}, {0.02, 2.56}, {0.01, 6.14}}) {
    MethodSpec with = method("trapezoidal", h);
    with.parameters["newton_tolerance"] = 1e-14;
    const Trajectory trajectory = swing(spring_pendulum(1e10), with, 10);
    EXPECT_EQ(trajectory.outcome, Outcome::unstable) << trajectory.message;
    EXPECT_NEAR(trajectory.end_time, onset, 1e-9) << "h = " << h << " s: " << trajectory.message;
  }
}

TEST(SpringPendulum, TrapezoidalRuleKeepsToItsBoundWhereTheSpringIsSoft) {
  for (const double h : {0.2, 0.1, 0.05, 0.02, 0.01}) {
    const Trajectory trajectory = swing(spring_pendulum(1e4), method("trapezoidal", h), 10);
    EXPECT_EQ(trajectory.outcome, Outcome::completed) << "h = " << h << " s: " << trajectory.message;
  }
}

// An independent program says the same of each. With the force at the state between, which is a chord of the
// circle, the end of the first step lies off the circle, and the stiff spring holds more than the first
// energy at once.
TEST(SpringPendulum, GeneralizedAlphaNeedsEnoughDamping) {
  for (const double h : {0.2, 0.1, 0.05, 0.02, 0.01}) {
    const auto outcome = [h = h](double rho) {
      return swing(spring_pendulum(1e10), generalized_alpha(rho, h), 10).outcome;
    };
    EXPECT_EQ(outcome(0.5), Outcome::completed) << "h = " << h;
    EXPECT_EQ(outcome(0.8), h >= 0.1 ? Outcome::unstable : Outcome::completed) << "h = " << h;
    EXPECT_EQ(outcome(0.9), h >= 0.05 ? Outcome::unstable : Outcome::completed) << "h = " << h;
  }
}

TEST(SpringPendulum, GeneralizedAlphaWithTheForceBetweenGainsTheEnergyInTheFirstStep) {
  MethodSpec with = generalized_alpha(0.5, 0.05);
  with.parameters["mean_forces"] = 0;
  const Trajectory trajectory = swing(spring_pendulum(1e10), with, 10);
  EXPECT_EQ(trajectory.outcome, Outcome::unstable) << trajectory.message;
  EXPECT_EQ(trajectory.end_time, 0.05);
}

TEST(SpringPendulum, EnergyMomentumKeepsTheEnergyWhereTheTrapezoidalRuleDoesNot) {
  for (const double h : {0.2, 0.05, 0.01}) {
    const Trajectory kept = swing(spring_pendulum(1e10), method("energy-momentum", h), 10);
    ASSERT_EQ(kept.outcome, Outcome::completed) << "h = " << h << ": " << kept.message;
    EXPECT_LE(kept.relative_energy_drift(), 1e-6) << "h = " << h;
  }
}

}  // namespace spring_pendulum_test
}  // namespace plumb
