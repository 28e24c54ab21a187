#include <fmt/format.h>

#include <algorithm>

#include "engine/integrate/method_roles.h"
#include "engine/read/case_sections.h"

namespace plumb {
namespace {

void include(std::vector<int>& elements, int more) {
  elements.push_back(more);
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

StudyExtent default_extent(const CableSpec& cable) {
  StudyExtent extent;
  extent.elements = {4, 8, 16, 32};
  include(extent.elements, cable.elements);
  for (const MethodInfo& info : method_infos())
    if (info.dynamic) extent.methods.push_back(info.name);
  extent.points = 10;
  extent.repeats = 5;
  extent.time_limit = 2;
  return extent;
}

/// Seconds in all, so that every run of a case can afford it.
StudyExtent default_quick_extent(const CableSpec& cable) {
  constexpr int finest = 32;
  StudyExtent extent;
  extent.elements = {cable.elements};
  if (2 * cable.elements <= finest) include(extent.elements, 2 * cable.elements);
  extent.methods = few_unlike_methods();
  extent.points = 5;
  extent.repeats = 1;
  extent.time_limit = 0.1;
  return extent;
}

/// Reads the keys of an extent from a table that may have others.
void read_extent(TableReader& table, const CableSpec& cable, StudyExtent& extent) {
  if (const auto elements = table.wholes("elements", 1, most_elements_of_a_cable)) {
    extent.elements = *elements;
    include(extent.elements, cable.elements);
  }
  std::vector<std::string> names;
  for (const MethodInfo& info : method_infos())
    if (info.dynamic) names.push_back(info.name);
  if (const auto methods = table.choices("methods", names)) {
    extent.methods.clear();
    for (std::size_t k = 0; k < names.size(); ++k)
      if (std::find(methods->begin(), methods->end(), k) != methods->end())
        extent.methods.push_back(names[k]);
  }
  table.read(extent);
}

WorkPrecisionSpec default_work_precision(const CableSpec& cable, const TimeSpec& time) {
  WorkPrecisionSpec spec;
  spec.end = time.end;
  spec.loosest_tolerance = 1e-3;
  spec.tightest_tolerance = 1e-11;
  spec.full = default_extent(cable);
  spec.quick = default_quick_extent(cable);
  return spec;
}

/// Steps left to their defaults follow from the end of the study.
void set_default_steps(WorkPrecisionSpec& spec, const TimeSpec& time) {
  constexpr double fewest_steps = 50, most_steps = 1e5;
  if (!(spec.largest_step > 0)) spec.largest_step = std::min(spec.end / fewest_steps, time.output_interval);
  if (!(spec.smallest_step > 0)) spec.smallest_step = spec.end / most_steps;
}

}  // namespace

WorkPrecisionSpec work_precision_of(const Case& spec) {
  WorkPrecisionSpec study = spec.work_precision.value_or(default_work_precision(spec.cable, spec.time));
  if (!spec.work_precision) set_default_steps(study, spec.time);
  for (StudyExtent* extent : {&study.full, &study.quick}) leave_out_others(spec, extent->methods);
  return study;
}

WorkPrecisionSpec read_work_precision(TableReader table, const CableSpec& cable, const TimeSpec& time) {
  constexpr double most_steps = 1e9;
  WorkPrecisionSpec spec = default_work_precision(cable, time);
  table.read(spec);
  // A case that is run for a shorter time, as with --set time.end=0.1, has a study that is as short.
  spec.end = std::min(time.end, spec.end);
  read_extent(table, cable, spec.full);
  TableReader quick = table.table("quick");
  read_extent(quick, cable, spec.quick);
  table.finish();
  quick.finish();

  if (spec.end < time.output_interval)
    table.refuse_value("end",
                       fmt::format("must be at least the output interval, {} (s)", time.output_interval));
  set_default_steps(spec, time);
  if (spec.largest_step > spec.end)
    table.refuse_value("largest_step", fmt::format("must be at most the end of the study, {} (s)", spec.end));
  if (spec.smallest_step >= spec.largest_step)
    table.refuse_value("smallest_step",
                       fmt::format("must be less than the largest step, {} (s)", spec.largest_step));
  if (spec.end / spec.smallest_step > most_steps)
    table.refuse_value("smallest_step",
                       fmt::format("gives {:.3g} steps until the end, {} s; at most {} are allowed",
                                   spec.end / spec.smallest_step, spec.end, most_steps));
  if (spec.tightest_tolerance >= spec.loosest_tolerance)
    table.refuse_value("tightest_tolerance",
                       fmt::format("must be less than the loosest tolerance, {}", spec.loosest_tolerance));
  return spec;
}

}  // namespace plumb
