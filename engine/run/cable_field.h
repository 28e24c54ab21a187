#pragma once

#include <Eigen/Core>
#include <string_view>

#include "engine/case/case.h"

namespace plumb {

class Cable;

/// A field of a cable (not `none`) in a state q with rates v, at the fraction s in [0, 1] of its length, in
/// the field's unit.
double field_value(const Cable& cable, ColorField field, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                   double s);

/// "axial strain", "N m" and so on; of `none` both are empty.
std::string_view title(ColorField);
std::string_view unit(ColorField);

}  // namespace plumb
