#include "engine/run/cable_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/case/case_words.h"
#include "engine/model/cable.h"
#include "engine/run/probes.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace cable_field_test {

/// A cable of 1 m in four elements on an arc of a radius, stretched evenly.
Eigen::VectorXd arc(double radius, double stretch) {
  Eigen::VectorXd q(30);
  for (int node = 0; node <= 4; ++node) {
    const double angle = 0.25 * node * stretch / radius;
    q.segment<6>(6 * node) << radius * std::sin(angle), radius * (1 - std::cos(angle)), 0,
        stretch * std::cos(angle), stretch * std::sin(angle), 0;
  }
  return q;
}

TEST(CableField, OfAStretchedArcIsThatOfItsStretchAndRadius) {
  const Cable cable(pendulum(5, 4));
  const Eigen::VectorXd q = arc(4, 1.1), v = Eigen::VectorXd::Zero(30);
  const double strain = (1.1 * 1.1 - 1) / 2;
  for (const double s : {0.0, 0.25, 0.75, 1.0}) {
    const auto value = [&](ColorField field) { return field_value(cable, field, q, v, s); };
    EXPECT_NEAR(value(ColorField::axial_strain), strain, 1e-9) << s;
    const double bent = 7.95774715459e-5 * 0.25;
    EXPECT_NEAR(value(ColorField::axial_force), 40 * strain * 1.1 - bent * 0.25 / 1.1, 1e-7) << s;
    EXPECT_NEAR(value(ColorField::curvature), 0.25, 1e-3) << s;
    EXPECT_NEAR(value(ColorField::bending_moment), bent / 1.1, 1e-7) << s;
  }
}

TEST(CableField, ForceAndMomentHoldTheLoadBeyondThem) {
  for (const StrainModel strain : {StrainModel::green_geometric, StrainModel::engineering_material}) {
    Case spec = pendulum(5, 64);
    spec.cable.area = 1e-2;  // EA = 200 N, EI = 2 N m²: stretched and bent as much
    spec.cable.youngs_modulus = 2e4;
    spec.cable.second_moment = 1e-4;
    spec.cable.strain = strain;
    spec.supports.first = Support::clamped;
    spec.loads = {.gravity = Vec3::Zero(), .end_force = {30, 0, 20}, .applied = {}};
    const Trajectory held = run(spec, method("statics", 0.25), {1, 1});
    ASSERT_EQ(held.outcome, Outcome::completed) << held.message;
    const Cable cable(spec);
    const Eigen::VectorXd &q = held.q.back(), none = Eigen::VectorXd::Zero(q.size());
    for (const double s : {0.1, 0.33, 0.5, 0.77, 0.95}) {
      const CablePoint point = cable.at(q, s);
      const double force = spec.loads.end_force.dot(point.slope.normalized());
      const double moment = (tip(held) - point.position).cross(spec.loads.end_force).norm();
      EXPECT_NEAR(field_value(cable, ColorField::axial_force, q, none, s), force, 4e-3) << word(strain) << s;
      EXPECT_NEAR(field_value(cable, ColorField::bending_moment, q, none, s), moment, 2e-3)
          << word(strain) << s;
    }
  }
}

TEST(CableField, SpeedOfATurningCableGrowsAlongIt) {
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  const Eigen::VectorXd q = cable.start_q(spec.start), v = cable.start_v(spec.start);
  for (const double s : {0.0, 0.3, 1.0})
    EXPECT_NEAR(field_value(cable, ColorField::speed, q, v, s), 4 * s, 1e-9) << s;
}

TEST(CableField, EachButNoneHasATitleAndAUnit) {
  for (const auto& [field, written] : words_of<ColorField>) {
    EXPECT_EQ(title(field).empty(), field == ColorField::none) << written;
    EXPECT_EQ(unit(field).empty(), field == ColorField::none) << written;
  }
  EXPECT_EQ(unit(ColorField::bending_moment), "N m");
  EXPECT_EQ(unit(ColorField::speed), "m/s");
}

}  // namespace cable_field_test
}  // namespace plumb
