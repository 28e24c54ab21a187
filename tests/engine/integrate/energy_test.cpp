#include <gtest/gtest.h>

#include "engine/integrate/monitor.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace energy_test {

TEST(Energy, RigidStartHasTheKineticEnergyOfARotatingRod) {
  Case spec = pendulum(5, 4);
  const Cable cable(spec);
  // ρA L³ ω² / 6
  EXPECT_NEAR(cable.energies(cable.start_q(spec.start), cable.start_v(spec.start)).kinetic, 0.0213333333333,
              1e-12);
}

TEST(Energy, PublishedStartHasMoreKineticEnergyThanARigidRotation) {
  Case spec = pendulum(5, 4);
  spec.start.slope_rates = SlopeRates::zero;
  const Cable cable(spec);
  EXPECT_NEAR(cable.energies(cable.start_q(spec.start), cable.start_v(spec.start)).kinetic, 0.0214857, 5e-8);
}

TEST(Energy, Rk4AtATenthOfAMillisecondDriftsByLessThanABillionth) {
  const Trajectory trajectory = run(pendulum(5, 4), method("rk4", 1e-4), {2, 0.02});
  EXPECT_LT(trajectory.relative_energy_drift(), 1e-9);
  EXPECT_GT(trajectory.relative_energy_drift(), 0);
}

// Figures of an independent program for the same scheme and pendulum over 10 s.
TEST(Energy, GeneralizedAlphaLosesWhatItsDampingTakes) {
  for (const auto& [h, lost] : {std::pair{1e-2, 0.017}, std::pair{2e-2, 0.058}}) {
    MethodSpec with = method("generalized-alpha", h);
    with.parameters["spectral_radius"] = 0.5;
    const Trajectory trajectory = run(pendulum(5, 4), with, {10, 0.1});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    EXPECT_NEAR(trajectory.relative_energy_drift(), lost, 0.0005) << "h = " << h;
    EXPECT_LT(trajectory.energies.back().total(), trajectory.energies.front().total());
  }
}

TEST(Energy, DriftIsThatOfTheStepsAndNotOfWhatIsInterpolatedBetweenThem) {
  const Trajectory kept = run(pendulum(5, 4), method("energy-momentum", 0.03), {3, 0.1});
  ASSERT_EQ(kept.outcome, Outcome::completed) << kept.message;
  EXPECT_GT(kept.interpolated_outputs, 10);
  EXPECT_LE(kept.relative_energy_drift(), 1e-9);
  double interpolation = 0;
  for (const Energies& e : kept.energies) interpolation = std::max(interpolation, std::abs(e.interpolation));
  EXPECT_GT(interpolation, 1e-6 * kept.kinetic_scale()) << "nothing was interpolated badly";
}

// At these steps the trapezoidal rule and generalized-α with ρ∞ = 1 fail within seconds.
TEST(Energy, EnergyMomentumKeepsItWhereOtherMethodsFail) {
  for (const StrainModel strain : {StrainModel::green_geometric, StrainModel::engineering_material})
    for (const double f : {1.0, 5.0}) {
      Case spec = pendulum(f, 4);
      spec.cable.strain = strain;
      const TimeSpec time{10, 0.1};
      const Trajectory kept = run(spec, method("energy-momentum", 1e-2), time);
      ASSERT_EQ(kept.outcome, Outcome::completed) << kept.message;
      EXPECT_LE(kept.relative_energy_drift(), 1e-9) << "f = " << f << ", " << word(strain);
      MethodSpec undamped = method("generalized-alpha", 1e-2);
      undamped.parameters["spectral_radius"] = 1;
      EXPECT_NE(run(spec, undamped, time).outcome, Outcome::completed) << "f = " << f << ", " << word(strain);
      EXPECT_NE(run(spec, method("trapezoidal", 1e-2), time).outcome, Outcome::completed)
          << "f = " << f << ", " << word(strain);
    }
}

TEST(Energy, EnergyMomentumKeepsItAtAnyStep) {
  for (const double h : {1e-3, 5e-3, 2e-2, 3.7e-2}) {
    const Trajectory kept = run(pendulum(5, 4), method("energy-momentum", h), {2, 0.1});
    ASSERT_EQ(kept.outcome, Outcome::completed) << kept.message;
    EXPECT_LE(std::abs(kept.energies.back().total() - kept.energies.front().total()),
              1e-11 * kept.kinetic_scale())
        << "h = " << h;
  }
}

TEST(Energy, DriftOfAStartFromRestIsHeldAgainstTheGreatestKineticEnergy) {
  Trajectory trajectory;
  trajectory.energies = {{.kinetic = 0, .potential = 0}, {.kinetic = 2, .potential = -1.5}};
  EXPECT_DOUBLE_EQ(trajectory.energy_drift(), 0.5);
  EXPECT_DOUBLE_EQ(trajectory.relative_energy_drift(), 0.25);
  trajectory.energies[1].kinetic = std::nan("");
  EXPECT_EQ(trajectory.relative_energy_drift(), -1) << "what cannot be told is not 0";
  EXPECT_EQ(Trajectory{}.relative_energy_drift(), -1);
}

TEST(Energy, EnergyMomentumKeepsItUnderAForceOnTheEnd) {
  Case spec = pendulum(5, 4);
  spec.loads.end_force = {0.05, 0.02, -0.03};
  const Trajectory kept = run(spec, method("energy-momentum", 1e-2), {5, 0.1});
  ASSERT_EQ(kept.outcome, Outcome::completed) << kept.message;
  EXPECT_LE(kept.energy_drift(), 1e-10 * kept.kinetic_scale());
  double least = 0;
  for (const Energies& e : kept.energies) least = std::min(least, e.potential);
  EXPECT_LT(least, kept.energies.front().potential - 0.005) << "the force did no work worth keeping, J";
}

TEST(Energy, PotentialEnergyFallsByTheForceOnTheEndTimesItsWay) {
  Case spec = pendulum(5, 4);
  spec.loads = {.gravity = {0, 0, 0}, .end_force = {2, -3, 4}, .applied = {}};
  const Cable cable(spec);
  Eigen::VectorXd q = cable.start_q(spec.start);
  const double before = cable.energies(q, q).potential;
  q.tail<6>().head<3>() += Vec3(0.1, 0.2, 0.5);
  EXPECT_NEAR(cable.energies(q, q).potential - before, -(0.2 - 0.6 + 2.0), 1e-14);
}

TEST(Energy, WhatTheForceOnTheEndCanReleaseIsAtHand) {
  Case spec = pendulum(5, 4);
  const auto at_hand = [&] {
    const Cable cable(spec);
    return Monitor(cable, {0, cable.start_q(spec.start), cable.start_v(spec.start)}, spec.time.end)
        .energies_at_hand();
  };
  const double without = at_hand();
  spec.loads.end_force = {2, -3, 6};
  EXPECT_NEAR(at_hand() - without, 7 * spec.cable.length, 1e-12);
}

TEST(Energy, PotentialEnergyFallsByWeightTimesHeight) {
  Case spec = pendulum(5, 4);
  const Cable cable(spec);
  Eigen::VectorXd q = cable.start_q(spec.start);
  const double before = cable.energies(q, q).potential;
  for (int node = 0; node < cable.nodes(); ++node) q[6 * node + 1] -= 0.3;
  EXPECT_NEAR(cable.energies(q, q).potential - before, -cable.loads().size() * 0.3, 1e-15);
}

}  // namespace energy_test
}  // namespace plumb
