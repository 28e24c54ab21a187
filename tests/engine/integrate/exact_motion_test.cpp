#include <gtest/gtest.h>

#include <random>

#include "engine/integrate/dynamics.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace exact_motion_test {

/// A method in one of the ways it can be used: with a step or with tolerances.
struct Use {
  std::string name;
  bool by_step = false;
};

void PrintTo(const Use& use, std::ostream* out) {
  *out << use.name << (use.by_step ? " by step" : " by tolerance");
}

class EveryMethod : public testing::TestWithParam<Use> {
 protected:
  MethodSpec spec_of(const MethodInfo& with, double step, double tolerance) const {
    // Tighter ones would take methods of low order millions of steps.
    const double tightest = with.family == MethodFamily::structural ? 0.01 * with.rtol : 0;
    return GetParam().by_step ? method(with.name, step)
                              : method(with.name, {}, std::max(tolerance, tightest));
  }

  const MethodInfo& info = *find_method(GetParam().name);
};

// A method that mishandles the slopes' share of the inertia lets the ends of a free cable fall unlike its
// middle.
TEST_P(EveryMethod, LetsAFreeStraightCableFallAsOne) {
  Case spec = pendulum(5, 5);
  spec.supports.first = Support::free;
  spec.start.angular_velocity.setZero();
  spec.start.direction = Vec3(1, 2, 2) / 3;
  spec.loads.gravity = {1, -9.81, 2};
  const double h = 5e-4, t = 0.1;
  const Trajectory trajectory = run(spec, spec_of(info, h, 1e-10), {t, t});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  const Eigen::VectorXd q0 = trajectory.q.front(), q = trajectory.q.back();
  // Euler's method falls g h² n(n + 1)/2 in n steps of h, exactly; in steps of its own choice it falls a
  // little far, but as one.
  double fallen = 0.5 * t * t;
  if (info.order == "1" && GetParam().by_step) fallen = 0.5 * t * (t + h);
  if (info.order == "1" && !GetParam().by_step) {
    fallen = q[0] - q0[0];
    EXPECT_NEAR(fallen, 0.5 * t * t, 0.1 * t * t);
  }
  for (int node = 0; node <= 5; ++node) {
    const Vec3 expected = q0.segment<3>(6 * node) + fallen * spec.loads.gravity;
    EXPECT_LE((q.segment<3>(6 * node) - expected).norm(), 1e-9)
        << "node " << node << " at " << q.segment<3>(6 * node).transpose();
    EXPECT_LE((q.segment<3>(6 * node + 3) - spec.start.direction).norm(), 1e-9) << "slope of node " << node;
  }
}

TEST_P(EveryMethod, KeepsTheMomentumOfAFreeCable) {
  Case spec = pendulum(5, 4);
  spec.supports.first = Support::free;
  spec.loads.gravity.setZero();
  const Cable cable(spec);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  for (double& x : start.v) x += 0.5 * unit(generator);
  const Trajectory trajectory = integrate(cable, start, spec_of(info, 1e-4, 1e-9), {0.2, 0.05});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  const auto momentum = [&](const Eigen::VectorXd& v) {
    Eigen::VectorXd p;
    cable.mass().multiply(v, p);
    Vec3 sum = Vec3::Zero();
    for (int node = 0; node < cable.nodes(); ++node) sum += p.segment<3>(6 * node);
    return sum;
  };
  for (const Eigen::VectorXd& v : trajectory.v)
    EXPECT_LE((momentum(v) - momentum(start.v)).norm(), 1e-12) << momentum(v).transpose() << " kg m/s";
}

TEST_P(EveryMethod, PullsAFreeCableByItsLastEndWithTheWholeForce) {
  Case spec = pendulum(5, 4);
  spec.supports.first = Support::free;
  spec.start.angular_velocity = {0, 2, 1};
  spec.loads = {.gravity = {0, 0, 0}, .end_force = {0.03, -0.02, 0.04}, .applied = {}};
  const Cable cable(spec);
  const double mass = spec.cable.density * spec.cable.area * spec.cable.length;
  const auto sum = [&](const Eigen::VectorXd& nodal) {
    Eigen::VectorXd weighted;
    cable.mass().multiply(nodal, weighted);
    Vec3 result = Vec3::Zero();
    for (int node = 0; node < cable.nodes(); ++node) result += weighted.segment<3>(6 * node);
    return result;
  };
  const double h = 2e-4;
  const Trajectory trajectory = run(spec, spec_of(info, h, info.order == "1" ? 1e-8 : 1e-10), {0.1, 0.1});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    const double t = trajectory.times[k];
    const Vec3 gained = sum(trajectory.v[k]) - sum(trajectory.v.front());
    EXPECT_LE((gained - t * spec.loads.end_force).norm(), 1e-11)
        << "momentum gained by " << t << " s: " << gained.transpose() << " kg m/s";
    // Euler's method goes h t/2 too far, or nearly so in steps of its own choice.
    const Vec3 centre = (sum(trajectory.q[k]) - sum(trajectory.q.front())) / mass;
    const Vec3 expected = (t * sum(trajectory.v.front()) + 0.5 * t * t * spec.loads.end_force) / mass;
    EXPECT_LE((centre - expected).norm(), info.order == "1" ? 2e-2 * t : 1e-9)
        << "centre of mass moved by " << centre.transpose() << " m until " << t << " s";
  }
}

TEST_P(EveryMethod, LeavesAHangingCableAtRest) {
  Case spec = pendulum(5, 4);
  spec.start.direction = {0, -1, 0};
  spec.start.angular_velocity.setZero();
  const Cable cable(spec);
  Dynamics dynamics(cable);
  State start{0, cable.start_q(spec.start), Eigen::VectorXd::Zero(cable.size())};
  Eigen::VectorXd f;
  for (int i = 0; i < 10; ++i) {  // Newton's iteration for the equilibrium
    dynamics.force(start.q, f);
    ASSERT_EQ(dynamics.factor(start.q, 0, 1), std::nullopt);
    dynamics.solve(f);
    start.q += f;
  }
  // ρ A g L² / 2EA, up to the second order of Green's strain.
  EXPECT_NEAR(-start.q.tail<6>()[1] - 1, 9.81e-4, 2e-6);
  const Trajectory trajectory = integrate(cable, start, spec_of(info, 5e-4, 1e-10), {0.5, 0.1});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  for (const Eigen::VectorXd& q : trajectory.q) EXPECT_LE((q - start.q).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST_P(EveryMethod, LeavesAUniformStretchBetweenTwoPinsUniform) {
  for (const StrainModel strain : {StrainModel::green_geometric, StrainModel::engineering_material}) {
    Case spec = pendulum(5, 4);
    spec.cable.strain = strain;
    spec.start.direction = Vec3(2, -1, 2) / 3;
    spec.supports.last = Support::pinned;
    spec.loads.gravity.setZero();
    const Cable cable(spec);
    const State start{0, 1.05 * cable.start_q(spec.start), Eigen::VectorXd::Zero(cable.size())};
    const Trajectory trajectory = integrate(cable, start, spec_of(info, 5e-4, 1e-8), {0.1, 0.05});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    EXPECT_LE((trajectory.q.back() - start.q).lpNorm<Eigen::Infinity>(), GetParam().by_step ? 1e-11 : 1e-8)
        << word(strain);
  }
}

TEST_P(EveryMethod, HoldsItsSupports) {
  for (const SupportsSpec& ends :
       {SupportsSpec{Support::pinned, Support::free}, SupportsSpec{Support::clamped, Support::pinned},
        SupportsSpec{Support::free, Support::clamped}}) {
    Case spec = pendulum(5, 3);
    spec.supports = ends;
    spec.start.direction = Vec3(2, 0, 1).normalized();
    spec.start.angular_velocity.setZero();
    const Trajectory trajectory = run(spec, spec_of(info, 5e-4, 1e-8), {0.1, 0.05});
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    const SupportProjection supports(ends, spec.start.direction, 4);
    const Eigen::VectorXd moved = trajectory.q.back() - trajectory.q.front();
    Eigen::VectorXd admissible = moved;
    supports.apply(admissible);
    // Constraints of a system that is solved are met to its round-off, a projection is met exactly.
    EXPECT_LE((moved - admissible).lpNorm<Eigen::Infinity>(),
              info.family == MethodFamily::constrained ? 1e-12 : 1e-14)
        << word(ends.first) << ", " << word(ends.last);
    EXPECT_GT(moved.norm(), 1e-3) << "nothing moved";
  }
}

TEST_P(EveryMethod, AgreesWithTheReferenceOnThePendulum) {
  const TimeSpec time{0.5, 0.05};
  const Trajectory exact = run(pendulum(5, 4), method("rk4", 2e-5), time);
  const Trajectory seen = run(pendulum(5, 4), spec_of(info, 2e-5, 1e-10), time);
  EXPECT_LE(tip_distance(seen, exact), info.order == "1" ? 5e-4 : 1e-6);
}

TEST_P(EveryMethod, LeavesAUniformStretchUniform) {
  Case spec = pendulum(5, 5);
  spec.supports = {Support::pinned, Support::pinned};
  spec.start.direction = Vec3(2, 1, 2) / 3;
  spec.loads.gravity.setZero();
  const Cable cable(spec);
  const State start{0, 1.02 * cable.start_q(spec.start), Eigen::VectorXd::Zero(cable.size())};
  const Trajectory trajectory = integrate(cable, start, spec_of(info, 5e-4, 1e-9), {0.2, 0.1});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  for (const Eigen::VectorXd& q : trajectory.q) EXPECT_LE((q - start.q).lpNorm<Eigen::Infinity>(), 1e-9);
}

std::vector<Use> uses() {
  std::vector<Use> result;
  for (const MethodInfo& info : method_infos()) {
    if (!info.dynamic) continue;
    if (info.takes_step) result.push_back({info.name, true});
    if (info.takes_tolerances) result.push_back({info.name, false});
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(All, EveryMethod, testing::ValuesIn(uses()), [](const auto& parameter) {
  std::string name = parameter.param.name + (parameter.param.by_step ? "_by_step" : "_by_tolerance");
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(ExactMotion, StiffPendulumSwingsAsTheRigidRodDoes) {
  // Lowest point of the middle and nutation period of the rigid rod with the same start (elliptic integrals).
  Case spec = pendulum(1, 1);
  spec.cable.second_moment *= 1e6;
  spec.cable.youngs_modulus *= 100;
  const Trajectory trajectory = run(spec, method("arkode-erk", {}, 1e-9), {0.9, 0.9 / 900});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  double lowest = 0, at = 0;
  const Cable cable(spec);
  for (std::size_t k = 0; k < trajectory.times.size(); ++k)
    if (const double y = cable.at(trajectory.q[k], 0.5).position.y(); y < lowest)
      lowest = y, at = trajectory.times[k];
  EXPECT_NEAR(lowest, -0.382228153438, 2e-5);
  EXPECT_NEAR(at, 0.449811077626, 2e-3);
}

}  // namespace exact_motion_test
}  // namespace plumb
