#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "engine/integrate/method.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace statics_stability_test {

constexpr double length = 0.5, area = 3.375e-4, second_moment = 5.69531e-10, youngs_modulus = 2e11;
const double critical =
    std::numbers::pi * std::numbers::pi * youngs_modulus * second_moment / (4 * length * length);

/// A clamped column along x under a dead load of `share` times Euler's on its end (Timoshenko and Gere;
/// Code_Aster, SSNL502), with a load of 1e-4 times that across.
Case column(double share, int elements) {
  Case spec;
  spec.title = "column";
  spec.cable = {.length = length,
                .area = area,
                .density = 7800,
                .youngs_modulus = youngs_modulus,
                .second_moment = second_moment,
                .elements = elements,
                .quadrature = QuadratureRule::reduced};
  spec.supports.first = Support::clamped;
  spec.loads.end_force = {-share * critical, 1e-4 * critical, 0};
  return spec;
}

/// By all eigenvalues of the stiffness under the load at an output, with supports: another way than the one
/// that the method goes. Scaled, which keeps their signs.
int negative_in_full(const Case& spec, const Eigen::VectorXd& q) {
  const Cable cable(spec);
  BlockTridiagonal K(cable.nodes());
  cable.system(q, 0, 1, K);
  cable.supports().apply(K);
  const Eigen::MatrixXd full = K.dense();
  const Eigen::VectorXd scale = full.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * full * scale.asDiagonal();
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
  return static_cast<int>((values.array() < 0).count());
}

std::string outcome_of(const Trajectory& run) {
  return std::string(word(run.outcome)) + " " + run.message;
}

// Nine loads, seven load steps, two meshes; some steps find the column upright, or bent against its side
// load.
TEST(StaticsStability, NoEquilibriumThatTheColumnWouldLeaveCompletes) {
  int completed = 0, unstable = 0;
  for (const double share : {0.5, 0.9, 1.015, 1.063, 1.152, 1.293, 1.518, 1.884, 2.541})
    for (const int steps : {1, 2, 5, 10, 20, 50, 100})
      for (const int elements : {4, 8}) {
        const Case spec = column(share, elements);
        const Trajectory run = plumb::run(spec, method("statics", 1.0 / steps), {1, 0.1});
        const std::string where = fmt::format("{} of Euler's load, {} steps, {} elements: {}", share, steps,
                                              elements, outcome_of(run));
        ++(run.outcome == Outcome::completed ? completed : unstable);
        // What was an output before a run ended is a place to stay, too.
        for (std::size_t k = 1; k < run.q.size(); ++k)
          EXPECT_EQ(negative_in_full(spec, run.q[k]), 0) << where << " at output " << k;
        if (share < 1) {
          EXPECT_EQ(run.outcome, Outcome::completed) << where;
        }
        if (run.outcome == Outcome::completed) continue;
        EXPECT_TRUE(run.outcome == Outcome::unstable_equilibrium || run.outcome == Outcome::no_convergence)
            << where;
        EXPECT_NE(run.message.find("of the load"), run.message.npos) << where;
      }
  EXPECT_GE(completed, 28 + 10) << completed << " completed, " << unstable << " did not";
  EXPECT_GE(unstable, 1) << completed << " completed, " << unstable << " did not";
}

// A column under its own weight buckles at 7.83735 EI/L³ (Greenhill 1881). Nothing disturbs it here, so that
// it stands upright at any weight; beyond that one it would fall to any side, which are two directions.
Case upright(double share) {
  Case spec = column(0, 8);
  spec.loads.end_force.setZero();
  const double greenhill = 7.83735 * youngs_modulus * second_moment / (length * length * length);
  spec.loads.gravity = {-share * greenhill / (7800 * area), 0, 0};
  return spec;
}

TEST(StaticsStability, AnUprightCableIsAtRestUpToGreenhillsWeightOnly) {
  const auto standing = [](double share, int steps) {
    return run(upright(share), method("statics", 1.0 / steps), {1, 1});
  };
  for (const int steps : {1, 10}) {
    const Trajectory within = standing(0.99, steps), beyond = standing(1.01, steps);
    EXPECT_EQ(within.outcome, Outcome::completed) << outcome_of(within);
    EXPECT_EQ(beyond.outcome, Outcome::unstable_equilibrium) << outcome_of(beyond);
    EXPECT_NE(beyond.message.find("2 negative eigenvalues"), beyond.message.npos) << beyond.message;
    EXPECT_NE(beyond.message.find("what would help"), beyond.message.npos) << beyond.message;
    EXPECT_LT(beyond.end_time, 1) << "the load of the last equilibrium that holds";
  }
}

TEST(StaticsStability, ACableThatHangsSagsOrIsPulledCompletes) {
  const auto outcome = [](Case spec, const Vec3& direction, const SupportsSpec& supports) {
    spec.start.direction = direction;
    spec.start.angular_velocity.setZero();
    spec.supports = supports;
    const Trajectory at_rest = run(spec, method("statics", 0.2), {1, 1});
    EXPECT_EQ(at_rest.outcome, Outcome::completed) << outcome_of(at_rest);
  };
  outcome(column(-2, 8), {1, 0, 0}, {Support::clamped, Support::free});
  outcome(pendulum(5, 8), {0, -1, 0}, {Support::clamped, Support::free});
  outcome(pendulum(5, 8), {0.6, -0.8, 0}, {Support::clamped, Support::free});
  outcome(pendulum(5, 8), {1, 0, 0}, {Support::pinned, Support::pinned});
}

// An output between two load steps is solved for as they are, so that nothing is shown that is no place to
// rest.
TEST(StaticsStability, ALoadBetweenStepsIsTakenOnlyWhereTheCableWouldStay) {
  Case spec = upright(0.9);
  const Cable cable(spec);
  Dynamics dynamics(cable);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  const auto statics = make_method(method("statics", 1), dynamics, start);
  ASSERT_TRUE(statics->step(1).ok());
  State at = start;
  statics->interpolate(0.5, at);
  EXPECT_TRUE(statics->interpolated().ok()) << statics->interpolated().reason;
  EXPECT_EQ(at.t, 0.5);
  statics->interpolate(1.2, at);  // 1.08 of Greenhill's weight
  EXPECT_EQ(statics->interpolated().outcome, Outcome::unstable_equilibrium);
  EXPECT_NE(statics->interpolated().reason.find("1.2 of the load"), std::string::npos)
      << statics->interpolated().reason;
  statics->interpolate(1, at);
  EXPECT_TRUE(statics->interpolated().ok()) << "what was wrong is forgotten";
}

}  // namespace statics_stability_test
}  // namespace plumb
