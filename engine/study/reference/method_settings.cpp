#include "engine/study/reference/method_settings.h"

#include "engine/study/reference/method_curves.h"

namespace plumb {

MethodSpec MethodSetting::with(double setting) const {
  MethodSpec result = method;
  if (by_step)
    result.step = setting;
  else
    result.rtol = result.atol = setting;
  return result;
}

std::vector<MethodSetting> method_variants(const std::vector<std::string>& methods) {
  // Any range serves, as only the curves' methods are asked for.
  WorkPrecisionSpec any;
  any.largest_step = any.loosest_tolerance = 1e-1;
  any.smallest_step = any.tightest_tolerance = 1e-3;
  StudyExtent extent;
  extent.methods = methods;
  extent.points = 3;
  std::vector<MethodSetting> variants;
  for (const CurvePlan& plan : study_curves(any, extent, 1, false)) {
    MethodSetting& variant = variants.emplace_back();
    variant.label = plan.label;
    variant.info = plan.method;
    variant.method = plan.points.front();
    variant.by_step = variant.method.step.has_value();
    variant.method.step.reset();
    variant.method.rtol.reset();
    variant.method.atol.reset();
  }
  return variants;
}

}  // namespace plumb
