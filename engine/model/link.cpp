#include "engine/model/link.h"

#include "engine/kernels/kernels.h"

namespace plumb {
namespace {

using Matrix3 = Eigen::Matrix3d;

}  // namespace

Link::Link(double axial_stiffness, double length, StrainModel strain)
    : stiffness_(axial_stiffness), length_(length), green_(strain == StrainModel::green_geometric) {}

bool Link::is_whole(const Vec3& d) const {
  return d.norm() > slope_floor * length_;
}

double Link::strain(const Vec3& d) const {
  return green_ ? 0.5 * (d.squaredNorm() / (length_ * length_) - 1) : d.norm() / length_ - 1;
}

double Link::energy(const Vec3& d) const {
  const double e = strain(d);
  return 0.5 * stiffness_ * length_ * e * e;
}

Vec3 Link::gradient(const Vec3& d) const {
  const double axis = green_ ? length_ : d.norm();
  return (stiffness_ * strain(d) / axis) * d;
}

Matrix3 Link::tangent(const Vec3& d) const {
  const double axis = green_ ? length_ : d.norm();
  const double across = stiffness_ * strain(d) / axis;
  const double along =
      green_ ? stiffness_ / (length_ * length_ * length_) : (stiffness_ / length_ - across) / d.squaredNorm();
  return across * Matrix3::Identity() + along * d * d.transpose();
}

Vec3 Link::discrete_gradient(const Vec3& d0, const Vec3& d1) const {
  const double axis = green_ ? length_ : 0.5 * (d0.norm() + d1.norm());
  return (stiffness_ * 0.5 * (strain(d0) + strain(d1)) / axis) * (0.5 * (d0 + d1));
}

Matrix3 Link::discrete_tangent(const Vec3& d0, const Vec3& d1) const {
  const double axis = green_ ? length_ : 0.5 * (d0.norm() + d1.norm());
  const double mean = stiffness_ * 0.5 * (strain(d0) + strain(d1)) / axis;
  // With s the sum of both lengths, the engineering bar's mean is EA (1/l − 2/s).
  const double by_d1 = green_ ? 0.5 * stiffness_ / (length_ * length_ * length_)
                              : 0.5 * stiffness_ / (axis * axis * d1.norm());
  return 0.5 * mean * Matrix3::Identity() + by_d1 * (0.5 * (d0 + d1)) * d1.transpose();
}

}  // namespace plumb
