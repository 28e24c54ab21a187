#include "engine/integrate/linear_stability.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/dense.h"
#include "engine/integrate/method.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace amplification_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

MethodSpec with(MethodSpec spec, const std::string& parameter, double value) {
  spec.parameters[parameter] = value;
  return spec;
}

MethodSpec bdf(int order) {
  return with(plain_method(*find_method("bdf")), "order", order);
}

/// Every method with a fixed step, at each order or damping worth telling apart.
std::vector<MethodSpec> fixed_step_methods() {
  std::vector<MethodSpec> specs;
  for (const MethodInfo& info : method_infos()) {
    if (!info.takes_step || !info.dynamic) continue;
    const MethodSpec plain = plain_method(info);
    specs.push_back(plain);
    for (const MethodParameter& parameter : info.parameters) {
      if (parameter.name == "order")
        for (double order = parameter.minimum; order <= parameter.maximum; ++order)
          specs.push_back(with(plain, "order", order));
      if (parameter.name == "spectral_radius" || parameter.name == "alpha")
        for (const double share : {0.0, 0.5, 1.0})
          specs.push_back(with(plain, parameter.name,
                               parameter.minimum + share * (parameter.maximum - parameter.minimum)));
    }
  }
  return specs;
}

std::string label(const MethodSpec& spec) {
  std::string text = spec.name;
  for (const char* key : {"order", "spectral_radius", "alpha"})
    if (spec.parameters.contains(key)) text += fmt::format(", {} = {:g}", key, spec.parameters.at(key));
  return text;
}

/// The fastest axial vibration of a straight, free cable without bending stiffness. With |r'| − 1 as its
/// strain it is exactly linear, whatever its amplitude.
struct AxialVibration {
  Case spec;
  double omega = 0;         // rad/s
  Eigen::VectorXd shape;    // φ with φᵀ M φ = 1
  Eigen::VectorXd reading;  // M φ

  AxialVibration() {
    spec = pendulum(5, 2);
    spec.cable.second_moment = 0;
    spec.cable.strain = StrainModel::engineering_material;
    spec.supports = {};
    spec.loads.gravity.setZero();
    spec.start.angular_velocity.setZero();
    const Cable cable(spec);
    BlockTridiagonal K(cable.nodes()), M(cable.nodes());
    cable.system(cable.start_q(spec.start), 0, 1, K);
    cable.system(cable.start_q(spec.start), 1, 0, M);
    std::vector<int> axial;
    for (int i = 0; i < cable.size(); i += 3) axial.push_back(i);
    const Eigen::MatrixXd k = K.dense()(axial, axial), m = M.dense()(axial, axial);
    const SymmetricEigen modes = symmetric_eigen(k, m);
    // With another, this one would grow first.
    const Eigen::Index fastest = modes.values.size() - 1;
    omega = std::sqrt(modes.values[fastest]);
    shape.setZero(cable.size());
    for (std::size_t i = 0; i < axial.size(); ++i)
      shape[axial[i]] = modes.vectors(static_cast<Eigen::Index>(i), fastest);
    cable.mass().multiply(shape, reading);
  }

  /// Amplification a step seen after `steps`, when but the slowest pair of roots is left: successive states
  /// x = (q, v) then follow x₂ = T x₁ − D x₀, and the pair has the size √D. `growth` is what is expected in
  /// all these steps, for a start that keeps them small.
  double measured(const MethodSpec& method, double z, int steps, double growth) const {
    const Cable cable(spec);
    const Eigen::VectorXd straight = cable.start_q(spec.start);
    MethodSpec at = method;
    at.step = z / omega;
    if (at.parameters.contains("newton_tolerance")) at.parameters["newton_tolerance"] = 1e-13;
    const double amplitude = 0.01 / std::max(growth, 1.0) / shape.lpNorm<Eigen::Infinity>();
    const State start{0, straight + amplitude * shape, Eigen::VectorXd::Zero(cable.size())};
    Dynamics dynamics(cable);
    const auto stepper = make_method(at, dynamics, start);
    std::vector<Eigen::Vector2d> states;
    for (int step = 0; step < steps; ++step) {
      const StepResult result = stepper->step(steps * *at.step);
      if (!result.ok()) ADD_FAILURE() << result.reason;
      const State& now = stepper->state();
      states.emplace_back(omega * reading.dot(now.q - straight), reading.dot(now.v));
    }
    const auto last = states.rbegin();
    Eigen::Matrix2d pair;
    pair << last[1], -last[2];
    return std::sqrt(pair.partialPivLu().solve(last[0])[1]);
  }
};

TEST(Amplification, IsThatOfMeasuredStepsForEveryMethodWithAFixedStep) {
  const AxialVibration vibration;
  for (const MethodSpec& spec : fixed_step_methods())
    for (const double z : {0.3, 0.9, 1.7}) {
      // The other roots of these die away more slowly.
      const int steps = spec.name == "bdf" && spec.parameters.at("order") > 2 ? 80 : 24;
      ASSERT_TRUE(amplification(spec, z)) << label(spec);
      const double predicted = *amplification(spec, z);
      EXPECT_NEAR(vibration.measured(spec, z, steps, std::pow(predicted, steps)), predicted, 2e-7)
          << label(spec) << " at z = " << z << ", which predicts 1 + " << predicted - 1;
    }
}

TEST(Amplification, IsOneWhereNothingHappensInAStep) {
  for (const MethodSpec& spec : fixed_step_methods())
    for (const double z : {0.0, 1e-5}) EXPECT_NEAR(*amplification(spec, z), 1, 1e-7) << label(spec);
}

TEST(Amplification, IsThatOfTheClosedFormsOfEuler) {
  for (const char* name : {"implicit-euler", "linearly-implicit-euler"})
    for (const double z : {1e-3, 0.1, 1.0, 20.0})
      EXPECT_NEAR(*amplification(method(name, 1), z), 1 / std::sqrt(1 + z * z), 1e-14) << name << " " << z;
  for (const double z : {0.1, 1.0, 20.0})
    EXPECT_NEAR(*amplification(bdf(1), z), 1 / std::sqrt(1 + z * z), 1e-14) << z;
}

TEST(Amplification, OfConservingMethodsIsOneAtEveryStep) {
  for (const char* name : {"trapezoidal", "implicit-midpoint", "energy-momentum", "gauss"})
    for (const double z : {1e-2, 1.0, 3.0, 1e3})
      EXPECT_NEAR(*amplification(method(name, 1), z), 1, 1e-13) << name << " " << z;
}

// Exudyn's manual, on its implicit trapezoidal rule and generalized-α solver: 1 − ρ at h/T = 0.01.
TEST(Amplification, OfGeneralizedAlphaIsThatOfAnotherManual) {
  const double z = 2 * std::numbers::pi * 0.01;
  for (const auto& [rho, loss] : {std::pair{0.9, 1.135e-9}, std::pair{0.6, 1.215e-7}}) {
    const MethodSpec spec = with(method("generalized-alpha", 1), "spectral_radius", rho);
    EXPECT_NEAR(1 - *amplification(spec, z), loss, 5e-4 * loss) << "ρ∞ = " << rho;
    EXPECT_NEAR(*amplification(spec, 1e5), rho, 1e-2) << "far beyond";
  }
}

// Roots of the characteristic polynomial by an independent program: the greatest growth on the imaginary
// axis.
TEST(Amplification, OfBackwardDifferentiationIsGreatestWhereItIsKnownToBe) {
  struct {
    int order;
    double z, growth;
  } const known[]{{3, 1.14, 1.0456}, {4, 1.86, 1.191}, {5, 2.38, 1.379}};
  for (const auto& [order, z, growth] : known) {
    // Half a unit of the last digit that is known.
    EXPECT_NEAR(*amplification(bdf(order), z), growth, order == 3 ? 5e-5 : 5e-4) << order;
    for (const double beside : {z - 0.05, z + 0.05})
      EXPECT_LT(*amplification(bdf(order), beside), *amplification(bdf(order), z)) << order;
  }
}

TEST(StabilityLimit, OfExplicitMethodsIsThatOfTheTextbooks) {
  EXPECT_NEAR(*stability_limit(method("velocity-verlet", 1)), 2, 1e-9);
  EXPECT_NEAR(*stability_limit(method("rk4", 1)), 2 * std::numbers::sqrt2, 1e-9);
  // The stability function of every method of four stages and order four is the same; of order three,
  // 1 − z²/2 + i (z − z³/6) has the size 1 at √3.
  EXPECT_NEAR(*stability_limit(with(method("arkode-erk", 1), "order", 3)), std::sqrt(3), 1e-8);
  EXPECT_EQ(*stability_limit(with(method("arkode-erk", 1), "order", 2)), 0);
}

TEST(StabilityLimit, IsInfiniteForMethodsThatAreStableOnTheWholeAxisAndNotForOthers) {
  for (const MethodSpec& spec : fixed_step_methods()) {
    const MethodInfo& info = *find_method(spec.name);
    if (spec.name == "bdf") continue;
    if (info.implicit)
      EXPECT_EQ(*stability_limit(spec), infinity) << label(spec);
    else
      EXPECT_LT(*stability_limit(spec), 4) << label(spec);
  }
}

// Roots of the characteristic polynomial by an independent program: beside 0, order 5 is damped.
TEST(StabilityLimit, OfBackwardDifferentiationOfOrdersThreeAndFourIsNoneAndOfOrderFiveShort) {
  EXPECT_EQ(*stability_limit(bdf(1)), infinity);
  EXPECT_EQ(*stability_limit(bdf(2)), infinity);
  for (const int order : {3, 4}) EXPECT_EQ(*stability_limit(bdf(order)), 0) << order;
  EXPECT_NEAR(*stability_limit(bdf(5)), 0.7108, 5e-5);
}

TEST(StabilityLimit, SeparatesGrowthFromItsAbsence) {
  for (const MethodSpec& spec : fixed_step_methods()) {
    const double limit = *stability_limit(spec);
    if (limit == 0 || limit == infinity) continue;
    EXPECT_LE(*amplification(spec, 0.99 * limit), 1 + 1e-9) << label(spec) << " below " << limit;
    EXPECT_GT(*amplification(spec, 1.01 * limit), 1 + 1e-9) << label(spec) << " above " << limit;
  }
}

TEST(StabilityLimit, IsNotClaimedForMethodsThatChooseTheirSteps) {
  for (const MethodInfo& info : method_infos()) {
    if (info.takes_step && info.dynamic) continue;
    EXPECT_FALSE(amplification(plain_method(info), 1)) << info.name;
    EXPECT_FALSE(stability_limit(plain_method(info))) << info.name;
  }
  EXPECT_FALSE(amplification(method("trapezoidal", {}, 1e-6), 1));
}

}  // namespace amplification_test
}  // namespace plumb
