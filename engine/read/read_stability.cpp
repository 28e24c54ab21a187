#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/nearest.h"
#include "engine/integrate/method_info.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/straight_frequency.h"
#include "engine/read/case_sections.h"

namespace plumb {
namespace {

constexpr double most_steps_of_a_run = 1e9;
constexpr const char* usual_parameter = "f";

template <class T>
void sort_out(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Methods that integrate over time.
std::vector<std::string> dynamic_methods() {
  std::vector<std::string> names;
  for (const MethodInfo& info : method_infos())
    if (info.dynamic) names.push_back(info.name);
  return names;
}

std::vector<std::string> methods_with_steps() {
  std::vector<std::string> names;
  for (const MethodInfo& info : method_infos())
    if (info.dynamic && info.takes_step) names.push_back(info.name);
  return names;
}

std::vector<double> usual_values(const std::string& parameter) {
  if (parameter != usual_parameter) return {};
  return {1, 2, 3, 5, 7, 10, 14, 20};
}

/// All but the steps, which depend on the durations.
StabilitySpec default_stability(const std::map<std::string, double>& parameters, const CableSpec& cable,
                                const TimeSpec& time) {
  StabilitySpec spec;
  if (parameters.contains(usual_parameter)) spec.parameter = usual_parameter;
  spec.parameter_values = usual_values(spec.parameter);
  spec.elements = {1, 2, 4, 8, 16, 32, cable.elements};
  sort_out(spec.elements);
  for (const double share : {0.125, 0.25, 0.5, 1.0})
    spec.durations.push_back(std::max(share * time.end, std::min(time.output_interval, time.end)));
  sort_out(spec.durations);
  spec.methods = dynamic_methods();
  spec.loosest_tolerance = 1e-2;
  spec.tightest_tolerance = 1e-8;
  spec.steps = 14;
  constexpr double share_of_length = 0.01;
  spec.tolerance = share_of_length * cable.length;
  spec.time_limit = 2;
  // What has to be given its step, and is not stable with any.
  for (const MethodInfo& info : method_infos())
    if (info.dynamic && !info.implicit && !info.takes_tolerances) spec.limit_methods.push_back(info.name);
  return spec;
}

/// Steps left to their defaults lie about that up to which the simplest explicit method is stable: most of
/// them above it, as implicit methods go far beyond.
void set_default_steps(StabilitySpec& spec, const CableSpec& cable) {
  constexpr double below = 1.0 / 8, above = 125, usual_energy_step = 1e-2;
  const double limit = 2 / straight_frequency(cable);
  if (!(spec.largest_step > 0)) spec.largest_step = std::min(above * limit, spec.durations.front());
  if (!(spec.smallest_step > 0)) spec.smallest_step = std::min(below * limit, 0.1 * spec.largest_step);
  if (!(spec.energy_step > 0)) spec.energy_step = std::min(usual_energy_step, spec.durations.front());
}

void read_parameter(TableReader& table, const std::map<std::string, double>& parameters,
                    StabilitySpec& spec) {
  const std::string fallback = spec.parameter;
  spec.parameter = table.optional_text("parameter", fallback);
  if (!spec.parameter.empty() && !parameters.contains(spec.parameter)) {
    std::vector<std::string> names;
    for (const auto& [name, value] : parameters) names.push_back(name);
    table.refuse_value("parameter", "must be one of [parameters]" + suggestion(spec.parameter, names));
  }
  if (spec.parameter != fallback) spec.parameter_values = usual_values(spec.parameter);
  if (const auto values = table.numbers("parameter_values", Range::any(""))) {
    if (spec.parameter.empty())
      table.refuse_value("parameter_values", "must be left out without a parameter to vary");
    spec.parameter_values = *values;
    sort_out(spec.parameter_values);
  } else if (!spec.parameter.empty() && spec.parameter_values.empty()) {
    table.refuse_value("parameter", "must have its values in parameter_values");
  }
}

void read_methods(TableReader& table, std::string_view key, const std::vector<std::string>& allowed,
                  std::vector<std::string>& methods) {
  const auto chosen = table.choices(key, allowed);
  if (!chosen) return;
  methods.clear();
  for (std::size_t k = 0; k < allowed.size(); ++k)
    if (std::find(chosen->begin(), chosen->end(), k) != chosen->end()) methods.push_back(allowed[k]);
}

/// A case that is run for a shorter time, as with --set time.end=0.1, or with rarer outputs, has a study that
/// suits it.
void suit_case(StabilitySpec& spec, const TimeSpec& time) {
  for (double& duration : spec.durations)
    duration = std::max(duration, std::min(time.output_interval, time.end));
  sort_out(spec.durations);
  const double shortest = std::min(spec.durations.front(), time.end);
  spec.largest_step = std::min(spec.largest_step, shortest);
  spec.smallest_step = std::min(spec.smallest_step, 0.1 * shortest);
  spec.energy_step = std::min(spec.energy_step, shortest);
}

void check_steps(const TableReader& table, const StabilitySpec& spec, const TimeSpec& time) {
  if (spec.smallest_step >= spec.largest_step)
    table.refuse_value("smallest_step",
                       fmt::format("must be less than the largest step, {} (s)", spec.largest_step));
  const double longest = std::max(spec.durations.back(), time.end);
  for (const auto& [key, step] :
       {std::pair{"smallest_step", spec.smallest_step}, std::pair{"energy_step", spec.energy_step}})
    if (longest / step > most_steps_of_a_run)
      table.refuse_value(key, fmt::format("gives {:.3g} steps until {} s; at most {} are allowed",
                                          longest / step, longest, most_steps_of_a_run));
}

}  // namespace

StabilitySpec stability_of(const Case& spec) {
  StabilitySpec study = spec.stability.value_or(default_stability(spec.parameters, spec.cable, spec.time));
  if (!spec.stability) set_default_steps(study, spec.cable);
  for (auto* methods : {&study.methods, &study.limit_methods}) leave_out_others(spec, *methods);
  return study;
}

StabilitySpec read_stability(TableReader table, const std::map<std::string, double>& parameters,
                             const CableSpec& cable, const TimeSpec& time) {
  StabilitySpec spec = default_stability(parameters, cable, time);
  read_parameter(table, parameters, spec);
  if (const auto elements = table.wholes("elements", 1, most_elements_of_a_cable)) {
    spec.elements = *elements;
    spec.elements.push_back(cable.elements);
    sort_out(spec.elements);
  }
  if (const auto durations = table.numbers("durations", Range::positive("s"))) {
    spec.durations = *durations;
    sort_out(spec.durations);
  }
  read_methods(table, "methods", dynamic_methods(), spec.methods);
  read_methods(table, "limit_methods", methods_with_steps(), spec.limit_methods);
  table.read(spec);
  table.finish();

  check_accuracy(table, spec.tolerance, cable);
  set_default_steps(spec, cable);
  check_steps(table, spec, time);
  suit_case(spec, time);
  if (spec.tightest_tolerance >= spec.loosest_tolerance)
    table.refuse_value("tightest_tolerance",
                       fmt::format("must be less than the loosest tolerance, {}", spec.loosest_tolerance));
  return spec;
}

}  // namespace plumb
