#include "engine/study/stability/newton_contraction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/dense.h"
#include "engine/model/cable.h"
#include "engine/study/stability/critical_step.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace newton_contraction_test {

Eigen::VectorXd swung(const Cable& cable, const Case& spec, double angle, double stretch) {
  Eigen::VectorXd q = cable.start_q(spec.start);
  for (Eigen::Index i = 0; i < q.size(); i += 3)
    q.segment<3>(i) = stretch * q[i] * Eigen::Vector3d(std::cos(angle), -std::sin(angle), 0);
  return q;
}

TEST(NewtonContraction, IsTheSpectralRadiusOfTheIteration) {
  const Case spec = pendulum(5, 3);
  const Cable cable(spec);
  const Eigen::VectorXd q = swung(cable, spec, 0, 1.001), solution = swung(cable, spec, 0.05, 1.002);
  const NewtonMatrix matrix{0.9, 0.25, 1};
  for (const double h : {1e-4, 1e-3, 1e-2}) {
    const auto dense = [&](const Eigen::VectorXd& at) {
      BlockTridiagonal S(cable.nodes());
      cable.system(at, matrix.mass, matrix.stiffness * h * h, S);
      cable.supports().apply(S);
      return S.dense();
    };
    const Eigen::MatrixXd leaves =
        Eigen::MatrixXd::Identity(cable.size(), cable.size()) - solved(dense(q), dense(solution));
    const double radius = spectral_radius(leaves);
    EXPECT_NEAR(newton_contraction(cable, matrix, h, q, solution), radius, 2e-2 * radius) << "h = " << h;
  }
}

TEST(NewtonContraction, OfTheMatrixOfTheSolutionItselfLeavesNothing) {
  const Case spec = pendulum(5, 3);
  const Cable cable(spec);
  const Eigen::VectorXd q = swung(cable, spec, 0.3, 1.01);
  EXPECT_LT(newton_contraction(cable, {1, 0.25, 1}, 1e-2, q, q), 1e-9);
}

TEST(NewtonContraction, HasTheFactorsOfTheMethod) {
  const auto trapezoidal = newton_matrix(method("trapezoidal", 1));
  ASSERT_TRUE(trapezoidal);
  EXPECT_EQ(trapezoidal->mass, 1);
  EXPECT_EQ(trapezoidal->stiffness, 0.25);
  EXPECT_EQ(newton_matrix(method("implicit-midpoint", 1))->stiffness, 0.25);
  EXPECT_EQ(newton_matrix(method("implicit-euler", 1))->stiffness, 1);
  EXPECT_FALSE(newton_matrix(method("rk4", 1)));
}

TEST(NewtonContraction, LimitAtTheStartIsAboutWhereTheTrapezoidalRuleFails) {
  double stiff = 0;
  for (const double f : {1.0, 5.0}) {
    const Case spec = pendulum(f, 4);
    const MethodSpec trapezoidal = plain_method(*find_method("trapezoidal"));
    const Trajectory motion = run(spec, method("runge-kutta-nystrom", {}, 1e-8), {2, 1e-3});
    const PredictedLimit limit = contraction_limit(Cable(spec), trapezoidal, motion);
    const CriticalStep seen = critical_step(spec, trapezoidal);
    EXPECT_NEAR(seen.stable, limit.at_start, 0.2 * limit.at_start) << "f = " << f;
    EXPECT_GT(limit.at_worst, 0.2 * limit.at_start) << "f = " << f;
    EXPECT_LE(limit.at_worst, limit.at_start) << "f = " << f;
    if (f == 1) stiff = limit.at_start;
    if (f == 5) {
      EXPECT_GT(limit.at_start, 1.5 * stiff);
    }
  }
}

TEST(NewtonContraction, LimitIsNotClaimedWithoutSuchAMatrix) {
  const Case spec = pendulum(5, 2);
  const Trajectory motion = run(spec, method("rk4", 1e-3), {0.1, 0.01});
  EXPECT_EQ(contraction_limit(Cable(spec), method("rk4", 1), motion).at_start, -1);
}

}  // namespace newton_contraction_test
}  // namespace plumb
