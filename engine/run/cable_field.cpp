#include "engine/run/cable_field.h"

#include "engine/model/cable.h"

namespace plumb {

double field_value(const Cable& cable, ColorField field, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                   double s) {
  const Element& element = cable.element();
  switch (field) {
    case ColorField::none:
      break;
    case ColorField::speed:
      return cable.interpolate(v, s).norm();
    default:
      break;
  }
  const CablePoint point = cable.at(q, s);
  switch (field) {
    case ColorField::axial_strain:
      return element.strain(point.slope);
    case ColorField::axial_force:
      return element.axial_force(point.slope, point.bend);
    case ColorField::curvature:
      return element.curvature(point.slope, point.bend);
    case ColorField::bending_moment:
      return element.bending_moment(point.slope, point.bend);
    default:
      return 0;
  }
}

std::string_view title(ColorField field) {
  switch (field) {
    case ColorField::none:
      break;
    case ColorField::axial_strain:
      return "axial strain";
    case ColorField::axial_force:
      return "axial force";
    case ColorField::curvature:
      return "curvature";
    case ColorField::bending_moment:
      return "bending moment";
    case ColorField::speed:
      return "speed";
  }
  return {};
}

std::string_view unit(ColorField field) {
  switch (field) {
    case ColorField::none:
      break;
    case ColorField::axial_strain:
      return unit(Quantity::axial_strain);
    case ColorField::axial_force:
      return unit(Quantity::axial_force);
    case ColorField::curvature:
      return unit(Quantity::curvature);
    case ColorField::bending_moment:
      return unit(Quantity::bending_moment);
    case ColorField::speed:
      return unit(Quantity::velocity);
  }
  return {};
}

}  // namespace plumb
