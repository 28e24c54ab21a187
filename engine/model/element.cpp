#include "engine/model/element.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace plumb {

Element::Element(double axial_stiffness, double bending_stiffness, double length, StrainModel strain)
    : axial_stiffness_(axial_stiffness),
      bending_stiffness_(bending_stiffness),
      length_(length),
      strain_(strain) {}

double Element::strain(const Vec3& slope) const {
  const double a = slope.squaredNorm();
  return strain_ == StrainModel::green_geometric ? 0.5 * (a - 1) : std::sqrt(a) - 1;
}

double Element::curvature(const Vec3& slope, const Vec3& slope_rate) const {
  const double a = std::max(slope.squaredNorm(), slope_floor * slope_floor);
  return slope.cross(slope_rate).norm() /
         std::sqrt(strain_ == StrainModel::green_geometric ? a * a * a : a * a);
}

double Element::axial_force(const Vec3& slope, const Vec3& slope_rate) const {
  const double axial = axial_stiffness_ * strain(slope);
  if (strain_ == StrainModel::engineering_material) return axial;
  return axial * slope.norm() - bending_moment(slope, slope_rate) * curvature(slope, slope_rate);
}

double Element::bending_moment(const Vec3& slope, const Vec3& slope_rate) const {
  const double moment = bending_stiffness_ * curvature(slope, slope_rate);
  return strain_ == StrainModel::green_geometric ? moment / std::max(slope.norm(), slope_floor) : moment;
}

}  // namespace plumb
