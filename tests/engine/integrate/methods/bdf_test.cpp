#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/integrate/methods/bdf_formula.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace bdf_test {

MethodSpec bdf(int order, double h) {
  MethodSpec with = method("bdf", h);
  with.parameters["order"] = order;
  return with;
}

TEST(Bdf, EqualStepsGiveTheKnownFormulas) {
  const std::vector<std::vector<double>> known{{1},
                                               {4. / 3, -1. / 3},
                                               {18. / 11, -9. / 11, 2. / 11},
                                               {48. / 25, -36. / 25, 16. / 25, -3. / 25},
                                               {300. / 137, -300. / 137, 200. / 137, -75. / 137, 12. / 137}};
  const double reach[] = {1, 2. / 3, 6. / 11, 12. / 25, 60. / 137};
  for (std::size_t k = 1; k <= 5; ++k) {
    std::vector<double> before;
    for (std::size_t j = 1; j <= k; ++j) before.push_back(0.5 * static_cast<double>(j));
    const BdfFormula formula(before);
    EXPECT_NEAR(formula.reach, 0.5 * reach[k - 1], 1e-15) << "order " << k;
    for (std::size_t j = 0; j < k; ++j)
      EXPECT_NEAR(formula.old[j], known[k - 1][j], 1e-14) << "order " << k << ", value " << j;
  }
}

TEST(Bdf, AShorterLastStepKeepsTheFormulaExactForPolynomials) {
  const std::vector<double> before{0.3, 1.3, 2.3, 3.3};
  const BdfFormula formula(before);
  for (int power = 0; power <= 4; ++power) {
    // t^power about a time that is no special one.
    const double t = 0.7;
    double made = power == 0 ? 0 : formula.reach * power * std::pow(t, power - 1);
    for (std::size_t j = 0; j < before.size(); ++j) made += formula.old[j] * std::pow(t - before[j], power);
    EXPECT_NEAR(made, std::pow(t, power), 1e-13) << "power " << power;
  }
}

TEST(Bdf, OrdersOneToFiveAreThoseTheySayAndNoHigher) {
  // A spring pendulum that turns and stretches: one link, EA/l over ρA l/2 gives 100 rad/s.
  Case spec = pendulum(5, 1);
  spec.cable.model = CableModel::chain;
  spec.start.axial_speed = 10;
  const TimeSpec time{0.1, 0.1};
  const Trajectory exact = run(spec, method("gauss", 1e-4), time);
  for (const int order : {1, 2, 3, 4, 5}) {
    std::string seen = fmt::format("order {}", order);
    double previous = 0;
    for (const double h : {8e-4, 4e-4, 2e-4}) {
      const Trajectory trajectory = run(spec, bdf(order, h), time);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
      const double error = tip_distance(trajectory, exact);
      seen += fmt::format("\n  h = {:g}: tip error {:.4g} m", h, error);
      if (previous > 0) {
        const double observed = std::log2(previous / error);
        seen += fmt::format(", order {:.3f}", observed);
        EXPECT_NEAR(observed, order, 0.2) << seen;
      }
      previous = error;
    }
  }
}

TEST(Bdf, OutputsBetweenStepsAreAsGoodAsThoseOnThem) {
  const Case spec = pendulum(5, 1);
  const Trajectory exact = run(spec, method("gauss", 1e-4), {0.1, 0.00777});
  for (const int order : {2, 3, 4, 5}) {
    const double on =
        tip_distance(run(spec, bdf(order, 1e-4), {0.1, 0.01}), run(spec, method("gauss", 1e-4), {0.1, 0.01}));
    const Trajectory between = run(spec, bdf(order, 1e-4), {0.1, 0.00777});
    EXPECT_GT(between.interpolated_outputs, 5);
    EXPECT_LE(tip_distance(between, exact), 2 * on + 1e-13)
        << "order " << order << ": on steps " << on << " m";
  }
}

TEST(Bdf, ShorterLastStepReachesTheEndOfTheRun) {
  const Case spec = pendulum(5, 1);
  const TimeSpec time{0.05004, 0.05004};
  const Trajectory exact = run(spec, method("gauss", 1e-4), time);
  for (const int order : {1, 2, 3, 4, 5}) {
    const Trajectory trajectory = run(spec, bdf(order, 1e-4), time);
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    EXPECT_EQ(trajectory.end_time, 0.05004);
    EXPECT_EQ(trajectory.interpolated_outputs, 0);
    EXPECT_LE(tip_distance(trajectory, exact), order == 1 ? 1e-3 : 1e-6) << "order " << order;
  }
}

/// Growth per step of an undamped vibration of a straight chain of one link along itself, at ω h.
double growth(int order, double omega_h) {
  Case spec = pendulum(5, 1);
  spec.cable.model = CableModel::chain;
  spec.cable.second_moment = 0;
  spec.cable.strain = StrainModel::engineering_material;  // which makes this vibration linear
  spec.start.angular_velocity.setZero();
  spec.loads.gravity.setZero();
  const double omega = std::sqrt(40 / (0.5 * 8e-3));  // EA/l over ρA l/2, rad/s
  spec.start.axial_speed = 1e-7 * omega;
  const Cable cable(spec);
  Dynamics dynamics(cable);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  MethodSpec with = bdf(order, omega_h / omega);
  with.parameters["newton_tolerance"] = 1e-14;  // far below what is left of the vibration
  const std::unique_ptr<Method> method = make_method(with, dynamics, start);
  // All but the leading pair of roots fades; where that fades too, not so long that only round-off is left.
  for (int k = 0; k < (order > 2 ? 36 : 6); ++k) EXPECT_TRUE(method->step(1e3).ok());
  double v[4];
  for (double& x : v) {
    EXPECT_TRUE(method->step(1e3).ok());
    x = method->state().v[6];
  }
  // v(n + 2) = 2 Re z v(n + 1) − |z|² v(n) for the pair z and its conjugate.
  return std::sqrt((v[1] * v[3] - v[2] * v[2]) / (v[0] * v[2] - v[1] * v[1]));
}

// The greatest roots of the characteristic polynomials on the imaginary axis, in closed form.
TEST(Bdf, UndampedVibrationsGrowByWhatTheRootsSay) {
  EXPECT_NEAR(growth(3, 1.14), 1.0456, 1e-4);
  EXPECT_NEAR(growth(4, 1.86), 1.191, 6e-4);
  EXPECT_NEAR(growth(5, 2.38), 1.379, 6e-4);
}

TEST(Bdf, OrdersOneAndTwoLetNoVibrationGrow) {
  for (const double omega_h : {0.1, 0.5, 1.14, 2.38})
    for (const int order : {1, 2})
      EXPECT_LT(growth(order, omega_h), 1) << "order " << order << " at " << omega_h;
  // 1/√(1 + ω²h²)
  EXPECT_NEAR(growth(1, 0.5), 1 / std::sqrt(1.25), 1e-6);
}

}  // namespace bdf_test
}  // namespace plumb
