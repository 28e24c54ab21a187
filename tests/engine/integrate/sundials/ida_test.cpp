#include <gtest/gtest.h>

#include "engine/integrate/dynamics.h"
#include "engine/model/cable.h"
#include "engine/model/support_constraints.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace ida_test {

MethodSpec ida(double tolerance, bool stabilised = true) {
  MethodSpec spec = method("ida", {}, tolerance);
  spec.parameters["stabilised"] = stabilised ? 1 : 0;
  return spec;
}

/// A cable that falls from a skew direction, so that no held coordinate is 0 but by the solver's doing.
Case skew(Support first, Support last) {
  Case spec = pendulum(5, 4);
  spec.supports = {first, last};
  spec.start.direction = Vec3(2, 0.3, 1).normalized();
  spec.start.angular_velocity.setZero();
  return spec;
}

/// G (M a − f) at a state, a being the accelerations of the cable with its supports projected out.
Eigen::VectorXd reaction(const Case& spec, const Eigen::VectorXd& q) {
  const Cable cable(spec);
  Dynamics dynamics(cable);
  Eigen::VectorXd a, inertia, f;
  dynamics.acceleration(q, a);
  cable.mass().multiply(a, inertia);
  cable.force(q, f);
  return SupportConstraints(spec.supports, spec.start.direction, cable.nodes()).apply(inertia - f);
}

TEST(Ida, GivesTheReactionsThatTheAccelerationsCallFor) {
  for (const SupportsSpec& ends :
       {SupportsSpec{Support::pinned, Support::free}, SupportsSpec{Support::clamped, Support::pinned},
        SupportsSpec{Support::free, Support::clamped}})
    for (const bool stabilised : {true, false}) {
      const Case spec = skew(ends.first, ends.last);
      // Odd outputs, so that interpolated multipliers are looked at too.
      const Trajectory seen = run(spec, ida(1e-10, stabilised), {0.3, 0.0137});
      ASSERT_EQ(seen.outcome, Outcome::completed) << seen.message;
      ASSERT_EQ(seen.multipliers.size(), seen.times.size());
      EXPECT_GT(seen.interpolated_outputs, 0);
      for (std::size_t k = 0; k < seen.times.size(); ++k) {
        const Eigen::VectorXd expected = reaction(spec, seen.q[k]);
        ASSERT_EQ(seen.multipliers[k].size(), expected.size());
        EXPECT_LE((seen.multipliers[k] - expected).norm(), 1e-8)
            << word(ends.first) << ", " << word(ends.last) << " at " << seen.times[k]
            << " s: " << seen.multipliers[k].transpose() << ", expected " << expected.transpose();
      }
      EXPECT_GT(greatest_reaction(ends, seen.multipliers), 0.03) << "nothing to compare";
    }
}

TEST(Ida, HoldsAHangingCableWithItsWeight) {
  Case spec = pendulum(5, 4);
  spec.start.direction = {0, -1, 0};
  spec.start.angular_velocity.setZero();
  const Cable cable(spec);
  Dynamics dynamics(cable);
  State start{0, cable.start_q(spec.start), Eigen::VectorXd::Zero(cable.size())};
  Eigen::VectorXd f;
  for (int i = 0; i < 10; ++i) {
    dynamics.force(start.q, f);
    ASSERT_EQ(dynamics.factor(start.q, 0, 1), std::nullopt);
    dynamics.solve(f);
    start.q += f;
  }
  const Trajectory seen = integrate(cable, start, ida(1e-10), {0.1, 0.02});
  ASSERT_EQ(seen.outcome, Outcome::completed) << seen.message;
  for (const Eigen::VectorXd& lambda : seen.multipliers)
    EXPECT_LE((lambda - Eigen::Vector3d(0, cable.loads().size(), 0)).norm(), 1e-9)
        << lambda.transpose() << " N";
}

TEST(Ida, TurnsACableWithoutWeightByItsCentripetalForce) {
  // The pull on a turning, straight, rigid rod's joint is ρA ω² L²/2; this one is stiff, not rigid.
  Case spec = pendulum(1, 2);
  spec.loads.gravity.setZero();
  const Trajectory seen = run(spec, ida(1e-9), {0.2, 0.02});
  ASSERT_EQ(seen.outcome, Outcome::completed) << seen.message;
  double mean = 0;
  for (const Eigen::VectorXd& lambda : seen.multipliers) mean += lambda.norm();
  mean /= static_cast<double>(seen.multipliers.size());
  const double rigid = spec.cable.density * spec.cable.area * 16 / 2;
  EXPECT_GT(mean, 0.5 * rigid);
  EXPECT_LT(mean, 1.5 * rigid);
}

TEST(Ida, KeepsTheJointInPlaceOverManySteps) {
  const Trajectory seen = run(skew(Support::clamped, Support::free), ida(1e-10), {2, 0.05});
  ASSERT_EQ(seen.outcome, Outcome::completed) << seen.message;
  EXPECT_GT(seen.counters.steps, 10000);
  EXPECT_GE(seen.constraint_drift, 0);
  EXPECT_LE(seen.constraint_drift, 1e-15);
}

// The constraints of these joints are linear, and a multistep formula keeps what is linear: without the
// position constraint it is round-off alone that adds up.
TEST(Ida, DriftsByRoundOffThatAddsUpWithoutStabilisation) {
  const Case spec = skew(Support::clamped, Support::free);
  const double held = run(spec, ida(1e-10), {1, 0.05}).constraint_drift;
  const Trajectory loose = run(spec, ida(1e-10, false), {1, 0.05});
  ASSERT_EQ(loose.outcome, Outcome::completed) << loose.message;
  EXPECT_GT(loose.constraint_drift, 2 * held);
  EXPECT_LE(loose.constraint_drift, 1e-13);
}

TEST(Ida, AgreesWithTheReferenceOnEverySupport) {
  for (const SupportsSpec& ends :
       {SupportsSpec{Support::pinned, Support::free}, SupportsSpec{Support::clamped, Support::free},
        SupportsSpec{Support::pinned, Support::clamped}})
    for (const bool stabilised : {true, false}) {
      const Case spec = skew(ends.first, ends.last);
      const Trajectory exact = run(spec, method("arkode-erk", {}, 1e-12), {0.3, 0.05});
      const Trajectory seen = run(spec, ida(1e-11, stabilised), {0.3, 0.05});
      ASSERT_EQ(seen.outcome, Outcome::completed) << seen.message;
      EXPECT_LE((seen.q.back() - exact.q.back()).norm(), 2e-8) << word(ends.first) << ", " << word(ends.last);
    }
}

TEST(Ida, HasNoMultipliersWithoutSupportsAndOthersHaveNone) {
  Case spec = pendulum(5, 2);
  const Trajectory other = run(spec, method("rk4", 1e-4), {0.01, 0.01});
  EXPECT_TRUE(other.multipliers.empty());
  EXPECT_EQ(other.constraint_drift, -1);
  spec.supports.first = Support::free;
  const Trajectory free = run(spec, ida(1e-8), {0.01, 0.01});
  EXPECT_EQ(free.outcome, Outcome::completed) << free.message;
  EXPECT_TRUE(free.multipliers.empty());
  EXPECT_EQ(free.constraint_drift, -1);
}

}  // namespace ida_test
}  // namespace plumb
