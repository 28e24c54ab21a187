#include "engine/study/reference/method_curves.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {
namespace {

std::vector<double> logarithmic(double first, double last, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(first * std::pow(last / first, k / (count - 1.0)));
  return values;
}

/// Without repetitions, which rounding to whole fractions of the output interval makes of long steps.
std::vector<double> steps(const WorkPrecisionSpec& spec, int count, double output_interval) {
  std::vector<double> result;
  for (double step : logarithmic(spec.largest_step, spec.smallest_step, count)) {
    if (step < output_interval) step = output_interval / std::round(output_interval / step);
    if (result.empty() || step < result.back() * (1 - 1e-9)) result.push_back(step);
  }
  return result;
}

/// Two significant digits: a tolerance is chosen, not measured.
double rounded(double tolerance) {
  const double unit = std::pow(10.0, std::floor(std::log10(tolerance)) - 1);
  return std::stod(fmt::format("{:.1e}", std::round(tolerance / unit) * unit));
}

std::string stated_order(const MethodInfo& method, const MethodSpec& variant) {
  if (const auto order = variant.parameters.find("order"); order != variant.parameters.end())
    return fmt::format("{:g}", order->second);
  if (const auto order = variant.parameters.find("max_order"); order != variant.parameters.end())
    return order->second > 1 ? fmt::format("1 to {:g}", order->second) : "1";
  return method.order;
}

}  // namespace

std::vector<CurvePlan> study_curves(const WorkPrecisionSpec& spec, const StudyExtent& extent,
                                    double output_interval, bool quick) {
  std::vector<CurvePlan> curves;
  const auto add = [&](const MethodInfo& method, const MethodSpec& variant, const std::string& label) {
    const bool both = method.takes_step && method.takes_tolerances && !quick;
    if (method.takes_step) {
      CurvePlan curve{label + (both ? ", fixed step" : ""), &method, stated_order(method, variant), {}};
      for (const double step : steps(spec, extent.points, output_interval)) {
        curve.points.push_back(variant);
        curve.points.back().step = step;
      }
      curves.push_back(std::move(curve));
    }
    if (method.takes_tolerances && (both || !method.takes_step)) {
      CurvePlan curve{label + (both ? ", controlled step" : ""), &method, stated_order(method, variant), {}};
      for (const double exact : logarithmic(spec.loosest_tolerance, spec.tightest_tolerance, extent.points)) {
        curve.points.push_back(variant);
        curve.points.back().rtol = curve.points.back().atol = rounded(exact);
      }
      curves.push_back(std::move(curve));
    }
  };
  for (const std::string& name : extent.methods) {
    const MethodInfo* method = find_method(name);
    if (method == nullptr) continue;
    const MethodSpec plain = plain_method(*method);
    const VariedParameter& varied = method->varied;
    if (quick || varied.values.empty())
      add(*method, plain, name);
    else
      for (const double value : varied.values) {
        MethodSpec variant = plain;
        variant.parameters[varied.name] = value;
        add(*method, variant, fmt::format("{}, {}", name, fmt::format(fmt::runtime(varied.label), value)));
      }
  }
  return curves;
}

}  // namespace plumb
