#include <gtest/gtest.h>

#include "engine/integrate/monitor.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace outcome_test {

TEST(Outcome, ExplicitMethodBeyondItsLimitStopsAndSaysWhere) {
  // The limit is 1.047e-3 s; at 1.3e-3 the energy runs away at once.
  const Trajectory trajectory = run(pendulum(5, 4), method("rk4", 1.3e-3), {2, 0.02});
  EXPECT_TRUE(trajectory.outcome == Outcome::unstable || trajectory.outcome == Outcome::singular)
      << word(trajectory.outcome);
  EXPECT_LT(trajectory.end_time, 2);
  EXPECT_NE(trajectory.message.find("rk4 ended at t = "), std::string::npos) << trajectory.message;
  EXPECT_NE(trajectory.message.find("step"), std::string::npos) << trajectory.message;
  for (const Eigen::VectorXd& q : trajectory.q) EXPECT_TRUE(q.allFinite());
  EXPECT_EQ(trajectory.times.size(), trajectory.q.size());
  EXPECT_LE(trajectory.times.back(), trajectory.end_time);
}

TEST(Outcome, NewtonThatIsCutOffIsNotAccepted) {
  MethodSpec with = method("generalized-alpha", 5e-3);
  with.parameters["newton_iterations"] = 1;
  const Trajectory trajectory = run(pendulum(5, 4), with, {1, 0.1});
  EXPECT_EQ(trajectory.outcome, Outcome::no_convergence) << trajectory.message;
  EXPECT_NE(trajectory.message.find("element"), std::string::npos) << trajectory.message;
}

// ρ∞ = 1 keeps the energy of linear oscillations only; on this cable with h = 1e-2 it fails within a few
// seconds.
TEST(Outcome, UndampedGeneralizedAlphaFailsOnTheCable) {
  MethodSpec with = method("generalized-alpha", 1e-2);
  with.parameters["spectral_radius"] = 1;
  const Trajectory undamped = run(pendulum(5, 4), with, {10, 0.1});
  EXPECT_NE(undamped.outcome, Outcome::completed);
  EXPECT_LT(undamped.end_time, 10);
  with.parameters["spectral_radius"] = 0.5;
  EXPECT_EQ(run(pendulum(5, 4), with, {10, 0.1}).outcome, Outcome::completed);
}

TEST(Outcome, CollapsedSlopeIsSingularAndNamesItsElement) {
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  for (const MethodInfo& info : method_infos()) {
    State start{0, cable.start_q(spec.start), Eigen::VectorXd::Zero(cable.size())};
    start.q.segment<3>(6 * 2 + 3).setZero();
    const MethodSpec with = info.takes_step ? method(info.name, 1e-4) : method(info.name, {}, 1e-8);
    const Trajectory trajectory = integrate(cable, start, with, {0.1, 0.1});
    EXPECT_EQ(trajectory.outcome, Outcome::singular) << info.name << ": " << trajectory.message;
    EXPECT_NE(trajectory.message.find("element 2"), std::string::npos) << trajectory.message;
  }
}

TEST(Outcome, StateThatIsNotFiniteIsDiverged) {
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  const Monitor monitor(cable, start, spec.time.end);
  EXPECT_TRUE(monitor.check(start).ok());
  State bad = start;
  bad.v[20] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(monitor.check(bad).outcome, Outcome::diverged);
  EXPECT_EQ(monitor.check(bad).element, 3);
}

TEST(Outcome, EnergyBeyondItsBoundIsUnstableAndWithinItIsNot) {
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  const Monitor monitor(cable, start, spec.time.end);
  const double kinetic = cable.energies(start.q, start.v).kinetic;
  const auto with_growth = [&](double growth) {
    State state = start;
    state.v *= std::sqrt(1 + growth * monitor.energies_at_hand() / kinetic);
    return monitor.check(state).outcome;
  };
  EXPECT_EQ(with_growth(0.99 * energy_growth_limit), Outcome::completed);
  EXPECT_EQ(with_growth(1.01 * energy_growth_limit), Outcome::unstable);
}

TEST(Outcome, TheTimeAllowedIsLookedAtAfterEachStepThatIsLong) {
  constexpr double none = 1e-9;
  for (const char* name : {"rk4", "generalized-alpha"}) {
    Case spec = pendulum(5, 20000);
    spec.method = method(name, 1e-8);
    spec.time = {1, 1};
    const Trajectory trajectory = integrate(spec, {}, none);
    EXPECT_EQ(trajectory.outcome, Outcome::out_of_time) << trajectory.message;
    EXPECT_EQ(trajectory.counters.steps, 1) << name << " went on for " << trajectory.solve_seconds << " s";
  }
}

TEST(Outcome, NothingIsClaimedBeforeARun) {
  const Trajectory trajectory;
  EXPECT_EQ(trajectory.outcome, Outcome::not_run);
  EXPECT_EQ(trajectory.counters.steps, -1);
  EXPECT_EQ(trajectory.counters.force_evaluations, -1);
  EXPECT_EQ(trajectory.solve_seconds, -1);
}

TEST(Outcome, CountersCountWhatTheMethodDid) {
  const Trajectory rk4 = run(pendulum(5, 4), method("rk4", 1e-3), {0.1, 0.1});
  EXPECT_EQ(rk4.counters.steps, 100);
  EXPECT_EQ(rk4.counters.force_evaluations, 400);
  EXPECT_EQ(rk4.counters.tangent_evaluations, 0);
  const Trajectory euler = run(pendulum(5, 4), method("linearly-implicit-euler", 1e-3), {0.1, 0.1});
  EXPECT_EQ(euler.counters.steps, 100);
  EXPECT_EQ(euler.counters.force_evaluations, 100);
  EXPECT_EQ(euler.counters.tangent_evaluations, 100);
  EXPECT_EQ(euler.counters.factorizations, 100);
}

}  // namespace outcome_test
}  // namespace plumb
