#include "engine/run/field_envelope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/cable.h"
#include "engine/run/cable_field.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace field_envelope_test {

/// A straight cable of 1 m stretched evenly by a factor at each time.
Trajectory stretched(int elements, const std::vector<double>& times, const std::vector<double>& factors) {
  Trajectory trajectory;
  trajectory.outcome = Outcome::completed;
  trajectory.elements = elements;
  trajectory.times = times;
  for (const double factor : factors) {
    Eigen::VectorXd q(6 * (elements + 1));
    for (int node = 0; node <= elements; ++node)
      q.segment<6>(6 * node) << factor * node / elements, 0, 0, factor, 0, 0;
    trajectory.q.push_back(q);
    trajectory.v.push_back(Eigen::VectorXd::Zero(q.size()));
  }
  return trajectory;
}

double strain(double factor) {
  return (factor * factor - 1) / 2;
}

TEST(FieldEnvelope, HasTheLeastGreatestAndTimeWeightedMean) {
  const Cable cable(pendulum(5, 4));
  // Outputs that are not evenly spaced, so that a plain mean would be another.
  const std::vector<double> times = {0, 0.1, 1}, factors = {1, 1.2, 0.9};
  const FieldEnvelope found = field_envelope(cable, ColorField::axial_strain, stretched(4, times, factors));
  const double mean = 0.05 * (strain(1) + strain(1.2)) + 0.45 * (strain(1.2) + strain(0.9));
  ASSERT_FALSE(found.places.empty());
  for (std::size_t k = 0; k < found.places.size(); ++k) {
    EXPECT_NEAR(found.least[k], strain(0.9), 1e-12) << found.places[k];
    EXPECT_NEAR(found.greatest[k], strain(1.2), 1e-12) << found.places[k];
    EXPECT_NEAR(found.mean[k], mean, 1e-12) << found.places[k];
  }
  EXPECT_NEAR(found.peak, strain(1.2), 1e-12);
  EXPECT_EQ(found.peak_time, 0.1);
}

TEST(FieldEnvelope, ShowsTheJumpOfTheCurvatureAtABoundary) {
  const Cable cable(pendulum(5, 2));
  // The first element is straight, the second bent: r'' jumps from 0 at the middle node.
  Trajectory trajectory = stretched(2, {0}, {1});
  trajectory.q[0].segment<3>(12) += Vec3(0, 0.1, 0);
  trajectory.q[0].segment<3>(15) += Vec3(0, 0.6, 0);
  const FieldEnvelope found = field_envelope(cable, ColorField::curvature, trajectory);
  const auto last = std::upper_bound(found.places.begin(), found.places.end(), 0.5);
  const auto second = static_cast<std::size_t>(last - found.places.begin()) - 1;
  EXPECT_EQ(found.places[second], 0.5);
  EXPECT_EQ(found.places[second - 1], 0.5) << "the boundary is there twice";
  EXPECT_NEAR(found.greatest[second - 1], 0, 1e-6);
  // r''(0⁺) = 6 (0, 0.1)/l² − 2 (0, 0.6)/l with l = 0.5, at a slope of 1.
  EXPECT_NEAR(found.greatest[second], std::abs(6 * 0.1 / 0.25 - 2 * 0.6 / 0.5), 1e-6);
  EXPECT_NEAR(found.mean[second], found.greatest[second], 1e-15) << "of a single output";
}

TEST(FieldEnvelope, HasEnoughPlacesOnAnyMeshAndTheWholeCable) {
  for (const int elements : {1, 7, 64, 1000}) {
    const Cable cable(pendulum(5, elements));
    const FieldEnvelope found =
        field_envelope(cable, ColorField::axial_force, stretched(elements, {0, 1}, {1, 1.01}));
    EXPECT_EQ(found.places.front(), 0);
    EXPECT_DOUBLE_EQ(found.places.back(), 1);
    EXPECT_TRUE(std::is_sorted(found.places.begin(), found.places.end()));
    EXPECT_GE(found.places.size(), std::min<std::size_t>(33, 2U * static_cast<std::size_t>(elements)));
    EXPECT_LE(found.places.size(), 2U * static_cast<std::size_t>(elements) + 500U);
    for (int e = 1; e < elements; ++e)
      EXPECT_EQ(std::count_if(found.places.begin(), found.places.end(),
                              [&](double s) { return std::abs(s - 1.0 * e / elements) < 1e-12; }),
                2)
          << elements << " elements, boundary " << e;
  }
}

TEST(FieldEnvelope, LeavesOutWhatIsNotFinite) {
  const Cable cable(pendulum(5, 4));
  Trajectory trajectory = stretched(4, {0, 1, 2}, {1, 1.1, 1.3});
  trajectory.q[2][7] = std::numeric_limits<double>::quiet_NaN();
  const FieldEnvelope found = field_envelope(cable, ColorField::axial_strain, trajectory);
  for (const double value : found.greatest) EXPECT_NEAR(value, strain(1.1), 1e-12);
  for (const double value : found.mean) EXPECT_NEAR(value, strain(1.1) / 2, 1e-12);
  trajectory.times.clear();
  trajectory.q.clear();
  trajectory.v.clear();
  const FieldEnvelope none = field_envelope(cable, ColorField::axial_strain, trajectory);
  EXPECT_FALSE(std::isfinite(none.peak));
  EXPECT_TRUE(std::isnan(none.mean.front()));
}

}  // namespace field_envelope_test
}  // namespace plumb
