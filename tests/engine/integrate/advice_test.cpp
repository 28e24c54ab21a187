#include "engine/integrate/advice.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "engine/case/case.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace advice_test {

/// The number that follows the words, or -1.
double number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  if (at == std::string::npos) return -1;
  return std::strtod(text.c_str() + at + words.size(), nullptr);
}

void expect_part(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message << "\n  should say: " << part;
}

TEST(Advice, NamesTheStepThatAnExplicitMethodNeeds) {
  // 2.828 and 2 over ω_max = 9.548 c/l, and what bisection finds: 1.050e-3 and 7.40e-4 s.
  struct {
    const char* name;
    double step, limit;
  } const known[]{
      {"rk4", 1.15e-3, 1.047e-3}, {"rk4", 1.3e-3, 1.047e-3}, {"velocity-verlet", 7.8e-4, 7.40e-4}};
  for (const auto& [name, step, limit] : known) {
    const Trajectory trajectory = run(pendulum(5, 4), method(name, step), {10, 0.02});
    ASSERT_NE(trajectory.outcome, Outcome::completed);
    EXPECT_NEAR(number_after(trajectory.message, "a step below "), limit, 0.05 * limit) << trajectory.message;
    expect_part(trajectory.message, "an implicit method");
    expect_part(trajectory.message, std::string(name) + " ended at t = ");
    expect_part(trajectory.message, " in step ");
    expect_part(trajectory.message, ", element ");
  }
}

// The step it names must be one that serves, or the advice is worth nothing.
TEST(Advice, NamesAStepThatServes) {
  for (const double f : {1.0, 20.0})
    for (const int elements : {4, 16}) {
      const TimeSpec time{0.5, 0.02};
      MethodSpec with = method("velocity-verlet", 1e-2 * f / elements / 10);
      const Trajectory failed = run(pendulum(f, elements), with, time);
      ASSERT_NE(failed.outcome, Outcome::completed) << f;
      with.step = number_after(failed.message, "a step below ");
      ASSERT_GT(*with.step, 0) << failed.message;
      EXPECT_EQ(run(pendulum(f, elements), with, time).outcome, Outcome::completed) << failed.message;
    }
}

TEST(Advice, OffersTheUndampedOnesAMethodThatKeepsTheEnergyOrDamps) {
  MethodSpec with = method("generalized-alpha", 2e-2);
  with.parameters["spectral_radius"] = 1;
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  for (const MethodSpec& undamped : {with, method("trapezoidal", 2e-2), method("implicit-midpoint", 2e-2)}) {
    const std::string text = advice(cable, start, {}, undamped, Outcome::unstable);
    expect_part(text, "energy-momentum");
    expect_part(text, "spectral_radius below 1");
    expect_part(text, "a step below 0.01 s");
  }
  const std::string damped = advice(cable, start, {}, method("generalized-alpha", 2e-2), Outcome::unstable);
  EXPECT_EQ(damped.find("spectral_radius"), std::string::npos) << damped;
  expect_part(damped, "energy-momentum");
}

// Half the step that failed often fails as well: with f = 1 and 5 ms the trapezoidal rule gains energy, too.
TEST(Advice, IsTriedBeforeItIsGiven) {
  const TimeSpec time{3, 0.1};
  struct {
    const char* name;
    double f, step;
  } const failing[]{
      {"trapezoidal", 1, 1e-2}, {"generalized-alpha", 1, 2e-2}, {"gauss", 1, 5e-2}, {"rk4", 2, 1e-3}};
  for (const auto& [name, f, step] : failing) {
    MethodSpec with = method(name, step);
    const Trajectory failed = run(pendulum(f, 4), with, time);
    ASSERT_NE(failed.outcome, Outcome::completed) << name;
    expect_part(failed.message, "(tried to ");
    const double advised = number_after(failed.message, "a step below ");
    if (advised < 0) continue;
    *with.step = 0.95 * advised;
    const Trajectory then = run(pendulum(f, 4), with, time);
    EXPECT_EQ(then.outcome, Outcome::completed) << failed.message << "\n" << then.message;
  }
}

TEST(Advice, OnNewtonsIterationIsMoreOfIt) {
  MethodSpec with = method("generalized-alpha", 5e-3);
  with.parameters["newton_iterations"] = 1;
  const Trajectory cut_off = run(pendulum(5, 4), with, {1, 0.1});
  ASSERT_EQ(cut_off.outcome, Outcome::no_convergence);
  expect_part(cut_off.message, "newton_iterations of 50");
}

TEST(Advice, SuitsTheMethodAndTheOutcome) {
  Case spec = pendulum(5, 4);
  spec.cable.second_moment = 0;
  const Cable cable(spec);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  const auto on = [&](const MethodSpec& with, Outcome outcome) {
    return advice(cable, start, {}, with, outcome);
  };
  expect_part(on(method("cvode-bdf", {}, 1e-14), Outcome::no_convergence),
              "looser tolerances than rtol = 1e-14");
  expect_part(on(method("gauss", 1e-2), Outcome::singular), "bending stiffness");
  expect_part(on(method("gauss", 1e-2), Outcome::singular), "more elements");
  expect_part(on(method("rk4", 1e-5), Outcome::out_of_time), "a longer step, of up to 0.00104 s");
  expect_part(on(method("rk4", 1e-2), Outcome::singular), "a step below 0.00104 s");
  expect_part(on(method("ida", {}, 1e-6), Outcome::out_of_time), "more time");
  MethodSpec growing = method("bdf", 1e-2);
  growing.parameters["order"] = 3;
  expect_part(on(growing, Outcome::unstable), "another order");
  expect_part(on(method("statics", 1e-2), Outcome::no_convergence), "a smaller load");
  // Every method has something to say of every failure, and nothing of what did not fail.
  for (const MethodInfo& info : method_infos())
    for (const Outcome outcome : outcomes()) {
      MethodSpec with = plain_method(info);
      if (info.takes_step)
        with.step = 1e-3;
      else if (info.takes_tolerances)
        with.rtol = with.atol = 1e-6;
      const bool failed = outcome == Outcome::unstable || outcome == Outcome::diverged ||
                          outcome == Outcome::no_convergence || outcome == Outcome::singular ||
                          outcome == Outcome::unstable_equilibrium || outcome == Outcome::out_of_time;
      EXPECT_EQ(on(with, outcome).empty(), !failed) << info.name << ", " << word(outcome);
    }
}

// A slope that has collapsed at the start is no fault of a setting.
TEST(Advice, SaysWhatWasTriedInVain) {
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  start.q.segment<3>(6 * 2 + 3).setZero();
  const Trajectory by_step = integrate(cable, start, method("generalized-alpha", 1e-3), {0.1, 0.1});
  expect_part(by_step.message, "tried in vain: steps down to ");
  expect_part(by_step.message, "energy-momentum with a step of 0.001 s");
  const Trajectory by_tolerance = integrate(cable, start, method("cvode-bdf", {}, 1e-6), {0.1, 0.1});
  expect_part(by_tolerance.message, "tried in vain: rtol down to 1e-12, rtol up to 0.01, ");
}

// A run whose time is limited is one of many, as in a study, and must not start others.
TEST(Advice, OfARunWithALimitIsNotTried) {
  Case spec = pendulum(1, 4);
  spec.method = method("trapezoidal", 1e-2);
  spec.time = {3, 0.1};
  const Trajectory failed = integrate(spec, {}, 1e3);
  ASSERT_NE(failed.outcome, Outcome::completed);
  EXPECT_EQ(failed.message.find("tried"), failed.message.npos) << failed.message;
  expect_part(failed.message, "a step below 0.005 s");
}

TEST(Advice, IsNotGivenWithoutNeed) {
  EXPECT_EQ(run(pendulum(5, 4), method("rk4", 1e-3), {0.1, 0.1}).message, "");
}

TEST(Advice, IsFoundForAStartThatIsNotFinite) {
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  start.q[7] = std::numeric_limits<double>::quiet_NaN();
  const Trajectory trajectory = integrate(cable, start, method("rk4", 1e-3), {0.1, 0.1});
  EXPECT_EQ(trajectory.outcome, Outcome::diverged);
  expect_part(trajectory.message, "not finite");
}

TEST(StepCuts, AreToldWithTheShortest) {
  const TimeSpec time{0.5, 0.02};
  const Trajectory controlled = run(pendulum(5, 4), method("trapezoidal", {}, 1e-4), time);
  ASSERT_EQ(controlled.outcome, Outcome::completed) << controlled.message;
  ASSERT_GT(controlled.counters.rejected_steps, 0);
  EXPECT_GT(controlled.shortest_cut, 0);
  EXPECT_LT(controlled.shortest_cut, time.end);
  const Trajectory fixed = run(pendulum(5, 4), method("trapezoidal", 1e-3), time);
  EXPECT_EQ(fixed.shortest_cut, -1);
}

}  // namespace advice_test
}  // namespace plumb
