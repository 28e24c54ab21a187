#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/method_info.h"

namespace plumb {

/// A curve to be drawn: a method in one of its variants, over a range of steps or tolerances.
struct CurvePlan {
  std::string label;  ///< "generalized-alpha, ρ∞ = 0.5"
  const MethodInfo* method = nullptr;
  std::string stated_order;        ///< of this variant: "5", "1 to 2"
  std::vector<MethodSpec> points;  ///< from the largest step or the loosest tolerance
};

/// The curves of the methods of `extent` that a study draws on each mesh. A method that takes both a step and
/// tolerances has a curve of either kind; in the quick form, which draws no variants, only that of steps.
/// Steps are those that divide the output interval next to evenly spaced logarithms, so that no output need
/// be interpolated.
std::vector<CurvePlan> study_curves(const WorkPrecisionSpec& spec, const StudyExtent& extent,
                                    double output_interval, bool quick);

}  // namespace plumb
