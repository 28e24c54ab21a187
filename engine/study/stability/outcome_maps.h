#pragma once

#include <functional>
#include <vector>

#include "engine/case/case.h"
#include "engine/study/reference/method_settings.h"
#include "engine/study/reference/reference_motion.h"
#include "engine/study/runner.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// The motions that the maps of a study are made of.
struct StabilityMotions {
  ReferenceMotion base;                     ///< of the case itself, over the longest duration
  std::vector<ReferenceMotion> parameters;  ///< one each value but the case's own, in the order of the values
  std::vector<ReferenceMotion> elements;    ///< one each mesh but the case's own

  /// The one of that value, on the case's mesh; of that mesh, at the case's value.
  const ReferenceMotion& at_parameter(double value) const;
  const ReferenceMotion& on_mesh(int elements) const;
};

/// Plans runs of every variant over steps (or tolerances) and each of parameter, elements and duration, each
/// judged by its reference. A run to the longest duration serves for the shorter ones. What is returned makes
/// the maps of them once the runner has computed all; it, and what it is given here, must last as long.
std::function<std::vector<OutcomeMap>()> plan_outcome_maps(const StabilitySpec& what, double end,
                                                           const std::vector<MethodSetting>& variants,
                                                           const StabilityMotions& motions, Runner& runner);

/// `count` values of equal ratio, rising from `least` to `greatest`.
std::vector<double> equal_ratios(double least, double greatest, int count);

}  // namespace plumb
