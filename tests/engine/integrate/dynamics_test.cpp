#include "engine/integrate/dynamics.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "engine/base/dense.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace dynamics_test {

struct DenseCorrection {
  Eigen::VectorXd change;
  bool definite;  ///< the matrix is positive definite
};

/// The correction of a stage at the accelerations x by dense matrices.
DenseCorrection dense_correction(const Cable& cable, const Eigen::VectorXd& q, const Eigen::VectorXd& x,
                                 double reach) {
  Eigen::VectorXd f, inertia, residual;
  const Eigen::VectorXd point = q + reach * x;
  EXPECT_FALSE(cable.force(point, f).has_value());
  cable.mass().multiply(x, inertia);
  residual = f - inertia;
  cable.supports().apply(residual);
  BlockTridiagonal A(cable.nodes());
  cable.system(point, 1, reach, A);
  cable.supports().apply(A);
  const Eigen::MatrixXd full = A.dense();
  return {solved(full, residual), symmetric_eigen(full).values[0] > 0};
}

class Corrections : public testing::TestWithParam<CableModel> {
 protected:
  static Case spec() {
    Case spec = pendulum(5, 7);
    spec.cable.model = GetParam();
    return spec;
  }

  /// Straight along the start's direction, and pressed to a share of its length.
  static Eigen::VectorXd pressed(const Cable& cable, double share) {
    return share * cable.start_q(spec().start) + 1e-3 * Eigen::VectorXd::Ones(cable.size());
  }
};

// Pressed to 0.6 of its length and with a reach beyond the reach of the mass, the matrix has negative pivots.
TEST_P(Corrections, AreThoseOfTheMatrixWhetherItIsPositiveDefiniteOrNot) {
  const Cable cable(spec());
  Dynamics dynamics(cable);
  Eigen::VectorXd x;
  int definite = 0, indefinite = 0;
  for (const double share : {1.0, 0.6, 1.0})
    for (const double reach : {1e-8, 1e-3}) {
      Eigen::VectorXd q = pressed(cable, share), a = Eigen::VectorXd::LinSpaced(cable.size(), -1, 1);
      cable.supports().apply(a);
      StageTerms stage{.base = Sum(q), .reach = reach};
      stage.from = {1, a.data()};
      const DenseCorrection dense = dense_correction(cable, q, a, reach);
      const Eigen::VectorXd expected = a + dense.change;
      (dense.definite ? definite : indefinite) += 1;
      const Counters before = dynamics.counters;
      // Renewed, and then with the factors at hand.
      for (const double renewed : {reach, 0.0}) {
        const StageCorrection result = dynamics.correct(stage, renewed, x);
        ASSERT_EQ(result.unsound, -1);
        ASSERT_EQ(result.singular, -1);
        EXPECT_TRUE(result.finite);
        EXPECT_LE((x - expected).norm(), 1e-8 * expected.norm())
            << "pressed to " << share << ", reach " << reach;
      }
      EXPECT_EQ(dynamics.counters.newton_iterations - before.newton_iterations, 2);
      // Where the first has failed, a second by row exchanges.
      EXPECT_EQ(dynamics.counters.factorizations - before.factorizations, dense.definite ? 1 : 2);
    }
  EXPECT_GT(definite, 0);
  EXPECT_GT(indefinite, 0);
}

// By all of a stage at once for a cable, and one thing after the other for a chain.
TEST_P(Corrections, WithAnOldMatrixThatIsTurnedAreNearerToThoseOfANewOne) {
  const Cable cable(spec());
  Dynamics old(cable), anew(cable);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  const Eigen::VectorXd q = pressed(cable, 1), a = Eigen::VectorXd::Zero(cable.size());
  Eigen::VectorXd turned = q, x, expected;
  for (Eigen::Index k = 0; k < q.size(); k += 3) turned.segment<3>(k) = turn * q.segment<3>(k);
  const auto distance = [&](bool turns) {
    StageTerms stage{.base = Sum(q), .reach = 1e-4};
    stage.from = {1, a.data()};
    EXPECT_EQ(old.correct(stage, 1e-4, x, {}, turns).singular, -1);
    stage.base = Sum(turned);
    EXPECT_TRUE(old.correct(stage, 0, x, {}, turns).finite);
    EXPECT_EQ(anew.correct(stage, 1e-4, expected).singular, -1);
    return (x - expected).norm() / expected.norm();
  };
  const double plain = distance(false), with_turns = distance(true);
  EXPECT_LT(with_turns, 0.1 * plain);
}

TEST_P(Corrections, OfACollapsedCableSayWhereAndDoNotCount) {
  const Cable cable(spec());
  Dynamics dynamics(cable);
  Eigen::VectorXd x, a = Eigen::VectorXd::Zero(cable.size());
  Eigen::VectorXd collapsed = cable.start_q(spec().start), whole = collapsed;
  collapsed.segment<12>(6 * 3).setZero();
  for (const double renewed : {1e-6, 0.0}) {
    StageTerms stage{.base = Sum(whole), .reach = 1e-6};
    stage.from = {1, a.data()};
    ASSERT_EQ(dynamics.correct(stage, 1e-6, x).singular, -1);
    const long before = dynamics.counters.newton_iterations;
    stage.base = Sum(collapsed);
    EXPECT_EQ(dynamics.correct(stage, renewed, x).unsound, 3);
    EXPECT_EQ(dynamics.counters.newton_iterations, before);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Corrections, testing::Values(CableModel::cable, CableModel::chain),
                         [](const auto& tested) {
                           return std::string(tested.param == CableModel::cable ? "Cable" : "Chain");
                         });

}  // namespace dynamics_test
}  // namespace plumb
