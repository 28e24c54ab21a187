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

}  // namespace plumb
