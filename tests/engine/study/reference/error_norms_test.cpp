#include "engine/study/reference/error_norms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace study_error_norms_test {

/// A space curve that a cubic element of any length holds exactly, moving in time.
Vec3 cubic(double s, double t) {
  return {s - 0.3 * s * s * t, 0.5 * s * s * s + t, -0.2 * s * s + 0.7 * t * s * s * s};
}
Vec3 cubic_slope(double s, double t) {
  return {1 - 0.6 * s * t, 1.5 * s * s, -0.4 * s + 2.1 * t * s * s};
}

Trajectory cubic_trajectory(int elements) {
  Trajectory result;
  result.outcome = Outcome::completed;
  result.elements = elements;
  result.element_length = 1.0 / elements;
  for (const double t : {0.0, 0.5, 1.0}) {
    Eigen::VectorXd q(6 * (elements + 1));
    for (int node = 0; node <= elements; ++node) {
      const double s = static_cast<double>(node) / elements;
      q.segment<3>(6 * node) = cubic(s, t);
      q.segment<3>(6 * node + 3) = cubic_slope(s, t);
    }
    result.times.push_back(t);
    result.q.push_back(q);
    result.v.push_back(Eigen::VectorXd::Zero(q.size()));
    result.energies.push_back({1, 0, 0, 0});
  }
  return result;
}

TEST(StudyErrorNorms, AShiftOfTheWholeCableIsThatDistanceInEveryNorm) {
  for (const int elements : {1, 3, 8}) {
    const Trajectory reference = cubic_trajectory(elements);
    Trajectory shifted = reference;
    for (Eigen::VectorXd& q : shifted.q)
      for (int node = 0; node <= elements; ++node) q.segment<3>(6 * node) += Vec3(0.03, 0, -0.04);
    const ErrorNorms norms = error_norms(shifted, reference);
    EXPECT_NEAR(norms.tip_max, 0.05, 1e-15);
    EXPECT_NEAR(norms.tip_rms, 0.05, 1e-15);
    EXPECT_NEAR(norms.curve, 0.05, 1e-15);
    EXPECT_EQ(norms.energy, 0);
  }
}

TEST(StudyErrorNorms, APlaceThatIsNotANumberLeavesNoDistanceThatIsOne) {
  const Trajectory reference = cubic_trajectory(2);
  for (const std::size_t output : {0U, 1U, 2U}) {
    Trajectory run = reference;
    run.q[output][13] = std::nan("");
    const ErrorNorms norms = error_norms(run, reference);
    EXPECT_TRUE(std::isnan(norms.tip_max)) << "output " << output << ": " << norms.tip_max;
    EXPECT_TRUE(std::isnan(norms.tip_rms)) << norms.tip_rms;
    EXPECT_TRUE(std::isnan(norms.curve)) << norms.curve;
  }
}

TEST(StudyErrorNorms, TheSameCubicCurveOnAnotherMeshIsNoDistanceAway) {
  for (const int elements : {1, 2, 3, 7})
    for (const int other : {1, 4, 5, 7}) {
      const ErrorNorms norms = error_norms(cubic_trajectory(elements), cubic_trajectory(other));
      EXPECT_LT(norms.tip_max, 1e-15);
      EXPECT_LT(norms.curve, 1e-15) << elements << " and " << other << " elements";
    }
}

// A tip that is off by a + b t at t = 0, ½, 1 and a shift that grows along the arc.
TEST(StudyErrorNorms, MaximumRootMeanSquareAndCurveFollowTheirDefinitions) {
  const Trajectory reference = cubic_trajectory(2);
  Trajectory off = reference;
  for (std::size_t k = 0; k < 3; ++k)
    for (int node = 0; node <= 2; ++node) {
      const double growth = 0.1 * static_cast<double>(k);
      off.q[k][6 * node + 1] += growth * node / 2;
      off.q[k][6 * node + 4] += growth;
    }
  const ErrorNorms norms = error_norms(off, reference);
  EXPECT_NEAR(norms.tip_max, 0.2, 1e-15);
  EXPECT_NEAR(norms.tip_rms, std::sqrt((0.01 + 0.04) / 3), 1e-15);
  EXPECT_NEAR(norms.curve, std::sqrt((0.01 + 0.04) / 3 / 3), 1e-15) << "the mean of s² over [0, 1] is 1/3";
}

TEST(StudyErrorNorms, ARunThatEndedEarlyHasNoDistance) {
  const Trajectory reference = cubic_trajectory(2);
  Trajectory early = reference;
  early.times.pop_back();
  early.q.pop_back();
  const ErrorNorms norms = error_norms(early, reference);
  EXPECT_EQ(norms.tip_max, -1);
  EXPECT_EQ(norms.tip_rms, -1);
  EXPECT_EQ(norms.curve, -1);
  EXPECT_EQ(error_norms({}, reference).tip_max, -1);
}

TEST(StudyErrorNorms, EveryNormHasAWordAUnitAndAValueOfItsOwn) {
  const ErrorNorms norms{1, 2, 3, 4};
  double sum = 0;
  for (const ErrorNorm norm : error_norm_list) {
    EXPECT_FALSE(word(norm).empty());
    EXPECT_EQ(unit(norm), norm == ErrorNorm::energy ? "1" : "m");
    sum = 10 * sum + value(norms, norm);
  }
  EXPECT_EQ(sum, 1234);
}

}  // namespace study_error_norms_test
}  // namespace plumb
