#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/dense.h"
#include "engine/integrate/method.h"
#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace newton_leftover_test {

/// What Newton's iteration, done once more with a dense matrix, would still change in the positions after a
/// step of h, m; of a method with M a = f(point q₁ + (1 − point) q₀), v₁ = v₀ + h a and q₁ = q₀ + h v₀ +
/// reach h² a.
double left_over(const Cable& cable, const State& from, const State& to, double point, double reach) {
  const double h = to.t - from.t;
  const Eigen::VectorXd q = point * to.q + (1 - point) * from.q, a = (to.v - from.v) / h;
  Eigen::VectorXd f, inertia;
  EXPECT_FALSE(cable.force(q, f).has_value());
  cable.mass().multiply(a, inertia);
  f -= inertia;
  cable.supports().apply(f);
  BlockTridiagonal A(cable.nodes());
  cable.system(q, 1, point * reach * h * h, A);
  cable.supports().apply(A);
  const Eigen::VectorXd change = solved(A.dense(), f);
  return correction_size(change, reach * h * h, cable.element().length()).metres;
}

TEST(NewtonLeftover, IsWithinTheToleranceOfTheIteration) {
  constexpr double tolerance = 1e-8;  // of 1 m; round-off is far below
  struct {
    const char* name;
    double point, reach;
  } const schemes[]{{"implicit-euler", 1, 1}, {"implicit-midpoint", 0.5, 0.5}};
  for (const auto& [name, point, reach] : schemes)
    for (const double f : {1.0, 5.0, 20.0})
      for (const double h : {1e-5, 1e-4, 1e-3, 3e-3}) {
        const Case spec = pendulum(f, 4);
        const Cable cable(spec);
        const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
        Dynamics dynamics(cable);
        MethodSpec with = method(name, h);
        with.parameters["newton_tolerance"] = tolerance;
        const std::unique_ptr<Method> integrator = make_method(with, dynamics, start);
        double worst = 0;
        State before = start;
        for (int k = 0; k < 200; ++k) {
          if (!integrator->step(1e6).ok()) break;
          worst = std::max(worst, left_over(cable, before, integrator->state(), point, reach));
          before = integrator->state();
        }
        EXPECT_LE(worst, tolerance) << fmt::format(
            "{}, f = {}, h = {}: {:.2g} m are left, {:g} m are allowed", name, f, h, worst, tolerance);
        RecordProperty(fmt::format("{}_{}_{}", name, f, h), fmt::format("{:.3g}", worst / tolerance));
      }
}

TEST(NewtonLeftover, OfAllStepsAddsNoMoreToTheEndThanTheTolerance) {
  const Case spec = pendulum(5, 4);
  const TimeSpec time{1, 0.1};
  for (const char* name : {"implicit-euler", "trapezoidal", "hht", "generalized-alpha", "implicit-midpoint",
                           "energy-momentum", "arkode-dirk", "gauss", "bdf"})
    for (const double h : {2e-3, 2e-4}) {
      const auto with = [&](double tolerance) {
        MethodSpec chosen = method(name, h);
        chosen.parameters["newton_tolerance"] = tolerance;
        return run(spec, chosen, time);
      };
      const Trajectory exact = with(1e-14);
      ASSERT_EQ(exact.outcome, Outcome::completed) << name << ", h = " << h << ": " << exact.message;
      for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
        const Trajectory run = with(tolerance);
        double added = 0;  // m, of a cable of 1 m
        for (std::size_t k = 0; k < run.q.size(); ++k)
          for (Eigen::Index node = 0; node < run.q[k].size(); node += 6)
            added = std::max(added, (run.q[k] - exact.q[k]).segment<3>(node).norm());
        EXPECT_LE(added, tolerance) << fmt::format("{}, h = {}: {:.2g} m", name, h, added);
      }
    }
}

TEST(NewtonLeftover, TakesTwoCorrectionsInShortStepsOfASmoothMotion) {
  const Case spec = pendulum(5, 4);
  for (const char* name :
       {"generalized-alpha", "hht", "trapezoidal", "implicit-midpoint", "implicit-euler"}) {
    const Trajectory done = run(spec, method(name, 1e-4), {0.2, 0.2});
    const double corrections =
        1.0 * static_cast<double>(done.counters.newton_iterations) / static_cast<double>(done.counters.steps);
    EXPECT_LE(corrections, 2.2) << name;
    EXPECT_GE(corrections, 1) << name;
  }
}

TEST(MatrixWear, IsWornWhenItsCorrectionsCostMoreThanWithANewMatrix) {
  MatrixWear wear(2.5);
  EXPECT_FALSE(wear.is_worn());
  for (int step = 0; step < 100; ++step) {
    wear.step_took(2);
    EXPECT_FALSE(wear.is_worn()) << "nothing is gained by another after " << step << " steps";
  }
  int steps = 0;
  for (; steps < 10 && !wear.is_worn(); ++steps) wear.step_took(3);
  EXPECT_LE(steps, 2) << "one more correction a step";
  wear.renewed();
  EXPECT_FALSE(wear.is_worn());
}

TEST(NewtonMatrix, OfACableThatSwingsServesManySteps) {
  for (const char* name : {"trapezoidal", "implicit-midpoint", "hht", "generalized-alpha"}) {
    Case spec = pendulum(5, 64);
    spec.method = plain_method(*find_method(name));
    spec.method.step = 1e-3;
    spec.time = {0.5, 0.1};
    const Trajectory run = integrate(spec);
    ASSERT_EQ(run.outcome, Outcome::completed) << run.message;
    const double steps = static_cast<double>(run.counters.steps),
                 factorizations = static_cast<double>(run.counters.factorizations) / steps,
                 iterations = static_cast<double>(run.counters.newton_iterations) / steps;
    EXPECT_LE(factorizations, 0.13) << name << ": a step";
    EXPECT_LE(iterations, 4) << name << ": a step";
  }
}

}  // namespace newton_leftover_test
}  // namespace plumb
