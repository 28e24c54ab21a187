#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "engine/base/dense.h"
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
  const Eigen::VectorXd values = symmetric_eigen(scaled).values;
  // A turn about the axis of a load along it is 0 but for what is left of the residual.
  return static_cast<int>((values.array() < -1e-11 * values.cwiseAbs().maxCoeff()).count());
}

std::string outcome_of(const Trajectory& run) {
  return std::string(word(run.outcome)) + " " + run.message;
}

/// Deflection and height of the inextensible column over its length under that share of Euler's load: with
/// K(k)² = (π/2)² share, 2k/K and 2E/K − 1.
std::array<double, 2> elastica(double share) {
  double below = 0, above = 1;
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double middle = 0.5 * (below + above), K = std::comp_ellint_1(middle);
    (K * K < 0.25 * std::numbers::pi * std::numbers::pi * share ? below : above) = middle;
  }
  const double K = std::comp_ellint_1(below);
  return {2 * below / K, 2 * std::comp_ellint_2(below) / K - 1};
}

constexpr std::array table{1.015, 1.063, 1.152, 1.293, 1.518, 1.884, 2.541, 4.03, 9.116};

TEST(StaticsStability, TheColumnBendsToTheSideOfItsLoadWhateverTheLoadStep) {
  int right = 0;
  std::string seen;
  for (const double share : table) {
    const auto [deflection, height] = elastica(share);
    std::optional<Vec3> first;
    for (const int steps : {1, 2, 7, 20, 100}) {
      const Case spec = column(share, 16);
      const Trajectory run = plumb::run(spec, method("statics", 1.0 / steps), {1, 0.5});
      const std::string where =
          fmt::format("{} of Euler's load, {} steps: {}", share, steps, outcome_of(run));
      ASSERT_EQ(run.outcome, Outcome::completed) << where;
      if (steps == 2) {
        EXPECT_EQ(negative_in_full(spec, run.q.back()), 0) << where;
      }
      for (std::size_t k = 0; k < run.q.size(); ++k) {
        EXPECT_EQ(run.equilibria.negative_eigenvalues.at(k), 0) << where << " at output " << k;
      }
      const Vec3 end = tip(run) / length;
      if (!first) first = end;
      EXPECT_LE((end - *first).norm(), 1e-8) << where;
      // The load across moves it most where the column has hardly buckled.
      const double off = std::hypot(end.x() - height, end.y() - deflection);
      right += end.y() > 0 && off < (share < 1.1 ? 3e-3 : 2e-3) ? 1 : 0;
      seen += fmt::format("\n  {}: {:.2e} of the length off", where, off);
    }
  }
  EXPECT_EQ(right, 45) << seen;
}

/// Stability by all eigenvalues at once, of random cables and loads.
TEST(StaticsStability, NoRandomEquilibriumThatTheCableWouldLeaveCompletes) {
  int completed = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const auto even = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    const auto any = [&] { return Vec3(even(-1, 1), even(-1, 1), even(-1, 1)).normalized(); };
    Case spec = column(0, 1 + static_cast<int>(even(0, 12)));
    spec.cable.youngs_modulus *= std::pow(10, even(-2, 2));
    spec.cable.second_moment *= std::pow(10, even(-3, 1));
    if (even(0, 1) < 0.5) spec.cable.strain = StrainModel::engineering_material;
    spec.start.direction = any();
    if (even(0, 1) < 0.3) spec.supports.last = Support::pinned;
    const double scale =
        std::pow(10, even(-1, 2)) * spec.cable.youngs_modulus * spec.cable.second_moment / (length * length);
    const Vec3 direction = even(0, 1) < 0.3 ? Vec3(-spec.start.direction) : any();
    spec.loads.end_force.setZero();
    spec.loads.gravity = direction * scale / (7800 * area * length);
    const Trajectory run = plumb::run(spec, method("statics", 0.5), {1, 0.25});
    if (run.outcome != Outcome::completed) {
      EXPECT_NE(run.message.find("of the load"), run.message.npos) << seed << ": " << outcome_of(run);
      continue;
    }
    ++completed;
    EXPECT_EQ(negative_in_full(spec, run.q.back()), 0) << "seed " << seed;
  }
  EXPECT_GE(completed, 36) << "of 40";
}

MethodSpec primary(double step) {
  MethodSpec spec = method("statics", step);
  spec.parameters["follow"] = 1;
  return spec;
}

/// A column under its own weight, which buckles at 7.83735 EI/L³ (Greenhill 1881); that share of it.
Case upright(double share) {
  Case spec = column(0, 8);
  spec.loads.end_force.setZero();
  const double greenhill = 7.83735 * youngs_modulus * second_moment / (length * length * length);
  spec.loads.gravity = {-share * greenhill / (7800 * area), 0, 0};
  return spec;
}

// The column is pressed by 1e-4 of its length, and its mesh is stiffer than the continuum by 1e-6.
TEST(StaticsStability, AnUprightCableLeavesTheStraightStateBeyondGreenhillsWeight) {
  for (const double step : {1.0, 0.1}) {
    const Trajectory within = run(upright(0.99), method("statics", step), {1, 1});
    EXPECT_EQ(within.outcome, Outcome::completed) << outcome_of(within);
    EXPECT_TRUE(within.equilibria.critical_points.empty());
    EXPECT_EQ(tip(within).y(), 0);
    const Trajectory beyond = run(upright(1.01), method("statics", step), {1, 1});
    EXPECT_EQ(beyond.outcome, Outcome::completed) << outcome_of(beyond);
    EXPECT_NEAR(tip(beyond).y() / length, 0.209, 2e-3) << "towards y, as no side is favoured";
    EXPECT_NEAR(tip(beyond).z(), 0, 1e-9);
    ASSERT_EQ(beyond.equilibria.critical_points.size(), 1U);
    const CriticalPoint& point = beyond.equilibria.critical_points.front();
    EXPECT_EQ(word(point.kind), "bifurcation");
    EXPECT_NEAR(1.01 * point.load, 1, 2e-4);
    EXPECT_EQ(point.negative_after, 2) << "to any side, which are two directions";
    EXPECT_EQ(point.at, 1);
    EXPECT_NE(point.what_followed.find("both sides being alike"), std::string::npos) << point.what_followed;
  }
}

TEST(StaticsStability, ThePrimaryPathOfAnUprightCableIsShownAndEndsAsOneThatItWouldLeave) {
  const Trajectory run = plumb::run(upright(1.5), primary(0.1), {1, 0.1});
  EXPECT_EQ(run.outcome, Outcome::unstable_equilibrium) << outcome_of(run);
  for (const char* said : {"at 0.7 of the load", "2 negative eigenvalues", "stability was lost at 0.6667",
                           "moves most at 1 of the length", "what would help: follow = \"stable\""})
    EXPECT_NE(run.message.find(said), run.message.npos) << said << ": " << run.message;
  ASSERT_EQ(run.times.size(), 11U);
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    EXPECT_EQ(run.equilibria.negative_eigenvalues.at(k), run.times[k] < 0.66 ? 0 : 2) << "at output " << k;
    EXPECT_EQ(tip(run, k).y(), 0) << "m, at output " << k;
  }
}

TEST(StaticsStability, ABifurcationIsFoundToAMillionthOfTheLoadWhateverTheLoadIs) {
  std::vector<double> found;
  for (const double share : {1.05, 1.7, 4.0}) {
    Case spec = column(share, 8);
    spec.loads.end_force.y() = 0;
    const Trajectory run = plumb::run(spec, method("statics", 0.3), {1, 1});
    ASSERT_EQ(run.equilibria.critical_points.size(), 1U) << outcome_of(run);
    found.push_back(share * run.equilibria.critical_points.front().load);
    EXPECT_NEAR(found.back(), found.front(), 1e-6 * (share + 1.05)) << "of Euler's load, at " << share;
  }
  EXPECT_NEAR(found.front(), 1, 1e-4) << "of Euler's load";
}

TEST(StaticsStability, TheLeastLoadAcrossSaysToWhichSideTheColumnGoes) {
  for (const double across : {1e-13, 1e-11, 1e-8, 1e-5})
    for (const double side : {-1.0, 1.0}) {
      Case spec = column(1.3, 8);
      spec.loads.end_force.y() = 0;
      spec.loads.end_force.z() = side * across * critical;
      const Trajectory run = plumb::run(spec, method("statics", 0.5), {1, 1});
      ASSERT_EQ(run.outcome, Outcome::completed) << across << ": " << outcome_of(run);
      EXPECT_GT(side * tip(run).z() / length, 0.7) << "of the length, under " << side * across;
    }
}

TEST(StaticsStability, AnImperfectStartIsHeldUnloadedAndSaysToWhichSideTheColumnGoes) {
  for (const double side : {-1.0, 1.0}) {
    Case spec = column(1.3, 8);
    spec.loads.end_force.y() = 0;
    spec.start.imperfection = side * 1e-3 * length;
    const Trajectory run = plumb::run(spec, method("statics", 0.5), {1, 0.5});
    ASSERT_EQ(run.outcome, Outcome::completed) << outcome_of(run);
    EXPECT_TRUE(run.equilibria.critical_points.empty());
    EXPECT_NEAR(tip(run, 0).y(), side * 1e-3 * length, 1e-6 * length);
    EXPECT_NEAR(side * tip(run).y() / length, elastica(1.3)[0], 5e-3);
  }
}

// Bent to one side by its imperfect start, it comes under a load across to the other, which grows: where that
// prevails the column swings about its axis to the other side, under a load that hardly changes: round-off
// decides whether the branch that it swings along leads all the way, or ends and damped motion takes it over.
TEST(StaticsStability, AColumnSwingsToTheOtherSideWhereTheLoadAcrossPrevails) {
  std::optional<Vec3> first;
  for (const double step : {1.0, 0.1}) {
    Case spec = column(1.3, 8);
    const double tip_load = 3 * youngs_modulus * second_moment / (length * length);
    spec.start.imperfection = 0.02 * length;
    spec.loads.end_force.y() = -0.02 * tip_load / 0.82;
    const Trajectory run = plumb::run(spec, method("statics", step), {1, 0.1});
    ASSERT_EQ(run.outcome, Outcome::completed) << outcome_of(run);
    EXPECT_GT(tip(run, 8).y() / length, 0.1) << "at 0.8 of the load";
    EXPECT_LT(tip(run, 9).y() / length, -0.1) << "at 0.9 of it";
    ASSERT_FALSE(run.equilibria.critical_points.empty());
    EXPECT_NEAR(run.equilibria.critical_points.front().load, 0.815, 0.02);
    bool over = false, said = false;
    for (const CriticalPoint& point : run.equilibria.critical_points)
      said = said || point.what_followed.find("damped motion leads to another one") != std::string::npos;
    for (const PathPoint& point : run.equilibria.path) over = over || !point.joined;
    EXPECT_EQ(said, over) << "a path that is broken off is one that damped motion has left";
    for (std::size_t k = 0; k < run.q.size(); ++k)
      EXPECT_EQ(run.equilibria.negative_eigenvalues.at(k), 0) << "at output " << k;
    if (!first) first = tip(run);
    EXPECT_LE((tip(run) - *first).norm(), 1e-8 * length) << "m";
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

TEST(StaticsStability, ALoadIsTakenOnlyWhereThePathHasCome) {
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
  statics->interpolate(2.5, at);
  EXPECT_EQ(statics->interpolated().outcome, Outcome::no_convergence) << "beyond the path";
  EXPECT_NE(statics->interpolated().reason.find("2.5 of the load"), std::string::npos)
      << statics->interpolated().reason;
  statics->interpolate(1, at);
  EXPECT_TRUE(statics->interpolated().ok()) << "what was wrong is forgotten";
}

}  // namespace statics_stability_test
}  // namespace plumb
