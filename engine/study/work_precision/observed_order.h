#pragma once

#include <limits>
#include <span>

#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// One run of a curve as the fit of its order sees it.
struct StepError {
  double step = 0;    ///< mean step, s
  double error = -1;  ///< m; -1: the run gave none
};

/// The slope of log error over log step by least squares over the asymptotic part of a curve, whose runs go
/// from the largest step to the smallest. The part is the finest stretch of three or more consecutive runs
/// with errors between `floor` and `ceiling` (m) whose local slopes agree to 0.1 and a tenth of their mean
/// and are at least 0.5 on average: above it the step is too large for the theory to hold, below it something
/// other than the step errs. Finer runs may only fall more slowly: where the error falls faster below, the
/// stretch is not asymptotic, and there is none. Nor is there where the slope is more than a tenth above
/// `highest`, the highest order that the method can choose: order and step then change together.
ObservedOrder observed_order(std::span<const StepError> curve, double floor, double ceiling,
                             double highest = std::numeric_limits<double>::infinity());

}  // namespace plumb
