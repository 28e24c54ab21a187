#pragma once

#include <string>
#include <vector>

#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// The errors of one curve, in the order of falling steps or tolerances.
struct CurveErrors {
  std::string method;
  std::vector<double> errors;  ///< m; -1: the run gave none
};

/// Errors at which curves of three or more methods flatten: a curve is flat where its last three errors lie
/// within a factor of 1.5, and flat curves belong together where their levels do. Something that they share,
/// such as the reference, is likely the reason.
std::vector<CommonFloor> common_floors(const std::vector<CurveErrors>& curves);

}  // namespace plumb
