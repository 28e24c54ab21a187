#include "engine/study/reference/classify_outcome.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace judge_test {

const TimeSpec short_time{0.2, 0.02};

const Trajectory& reference() {
  static const Trajectory trajectory =
      run(pendulum(5, 2), method("runge-kutta-nystrom", {}, 1e-12), short_time);
  return trajectory;
}

/// The reference with the middle node moved from an output on, m.
Trajectory moved(double by, std::size_t from = 0) {
  Trajectory trajectory = reference();
  for (std::size_t k = from; k < trajectory.q.size(); ++k) trajectory.q[k][6 + 1] += by;
  return trajectory;
}

constexpr double tolerance = 1e-3, whole = 0.2;

TEST(ClassifyOutcome, TellsARunWithinTheToleranceFromOneBeyondIt) {
  const Judgement within = classify_outcome(moved(0.9 * tolerance, 5), reference(), tolerance, whole);
  EXPECT_EQ(within.outcome, Outcome::accurate);
  EXPECT_NEAR(within.error, 0.9 * tolerance, 1e-9);
  EXPECT_EQ(within.judged_until, whole);
  const Judgement beyond = classify_outcome(moved(1.1 * tolerance, 5), reference(), tolerance, whole);
  EXPECT_EQ(beyond.outcome, Outcome::inaccurate);
  EXPECT_NEAR(beyond.error, 1.1 * tolerance, 1e-9);
}

TEST(ClassifyOutcome, TellsARunOfALooseMethodFromOneOfATightOne) {
  EXPECT_EQ(classify_outcome(run(pendulum(5, 2), method("rk4", 1e-4), short_time), reference(), 1e-4, whole)
                .outcome,
            Outcome::accurate);
  EXPECT_EQ(classify_outcome(run(pendulum(5, 2), method("linearly-implicit-euler", 1e-2), short_time),
                             reference(), 1e-4, whole)
                .outcome,
            Outcome::inaccurate);
}

TEST(ClassifyOutcome, LooksNoFurtherThanTheHorizon) {
  // The seventh output, at 0.12 s, is the first that is wrong.
  const Judgement judgement = classify_outcome(moved(1, 6), reference(), tolerance, 0.11);
  EXPECT_EQ(judgement.outcome, Outcome::accurate) << judgement.error;
  EXPECT_LE(judgement.error, tolerance);
  EXPECT_EQ(judgement.judged_until, reference().times[5]);
  EXPECT_EQ(classify_outcome(moved(1, 6), reference(), tolerance, 0.13).outcome, Outcome::inaccurate);
}

TEST(ClassifyOutcome, HoldsARunBeyondTheHorizonToItsEnergy) {
  const double kinetic = reference().kinetic_scale();
  const auto with_change = [&](double share, double horizon) {
    Trajectory trajectory = reference();
    trajectory.energies.back().axial += share * kinetic;
    return classify_outcome(trajectory, reference(), tolerance, horizon).outcome;
  };
  EXPECT_EQ(with_change(0.9 * energy_share, 0.1), Outcome::accurate);
  EXPECT_EQ(with_change(1.1 * energy_share, 0.1), Outcome::inaccurate);
  EXPECT_EQ(with_change(-1.1 * energy_share, 0.1), Outcome::inaccurate);
  // Within the horizon the distance says all.
  EXPECT_EQ(with_change(1.1 * energy_share, whole), Outcome::accurate);
}

TEST(ClassifyOutcome, NeverCallsAccurateWhatIsNotANumber) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(classify_outcome(moved(bad, 10), reference(), tolerance, whole).outcome, Outcome::inaccurate)
        << bad;
    Trajectory trajectory = reference();
    trajectory.energies.back().kinetic = bad;
    EXPECT_EQ(classify_outcome(trajectory, reference(), tolerance, 0.1).outcome, Outcome::inaccurate) << bad;
    EXPECT_EQ(classify_outcome(reference(), moved(bad, 10), tolerance, whole).outcome, Outcome::inaccurate)
        << bad;
  }
}

TEST(ClassifyOutcome, KeepsTheOutcomeOfARunThatDidNotComplete) {
  for (const Outcome outcome : outcomes()) {
    if (outcome == Outcome::completed) continue;
    Trajectory trajectory = reference();
    trajectory.outcome = outcome;
    const Judgement judgement = classify_outcome(trajectory, reference(), tolerance, whole);
    EXPECT_EQ(judgement.outcome, outcome) << word(outcome);
    EXPECT_EQ(judgement.error, -1);
    EXPECT_EQ(judgement.judged_until, -1);
  }
}

TEST(ClassifyOutcome, SaysNothingOfRunsThatCannotBeCompared) {
  const auto outcome = [](const Trajectory& trajectory, double horizon) {
    const Judgement judgement = classify_outcome(trajectory, reference(), tolerance, horizon);
    EXPECT_EQ(judgement.error, -1);
    return judgement.outcome;
  };
  EXPECT_EQ(outcome(run(pendulum(5, 4), method("rk4", 1e-4), short_time), whole), Outcome::completed);
  EXPECT_EQ(outcome(run(pendulum(5, 2), method("rk4", 1e-4), {0.2, 0.03}), whole), Outcome::completed);
  EXPECT_EQ(outcome(reference(), -1), Outcome::completed);
}

// A reference that ended early has nothing to say of what came after, however far its horizon was meant to
// be.
TEST(ClassifyOutcome, HoldsARunBeyondAShortReferenceToItsEnergy) {
  Trajectory short_reference = reference();
  short_reference.times.resize(6);
  short_reference.q.resize(6);
  Trajectory trajectory = reference();
  EXPECT_EQ(classify_outcome(trajectory, short_reference, tolerance, whole).judged_until,
            reference().times[5]);
  trajectory.energies.back().axial += 2 * energy_share * trajectory.kinetic_scale();
  EXPECT_EQ(classify_outcome(trajectory, short_reference, tolerance, whole).outcome, Outcome::inaccurate);
}

}  // namespace judge_test
}  // namespace plumb
