#include "report/verdict/series_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

/// Of all that is compared in one unit: beside a tip that moves, one that hardly does so is held to the same.
Magnitude compared_scale(const Reference& reference, const ReferenceUse& use, const std::string& unit,
                         double length) {
  Magnitude scale;
  for (const Comparison& pair : use.compare) {
    const ReferenceSeries& series = *reference.find(pair.series);
    if (series.unit != unit) continue;
    std::vector<double> claimed;
    for (std::size_t k = 0; k < reference.times.size(); ++k)
      if (use.coverage.has(reference.times[k])) claimed.push_back(series.values[k]);
    scale.add(claimed);
  }
  if (scale.size == 0 && unit == "m") scale.size = length;
  return scale;
}

PrintError print_error(const SeriesError& error, const ReferenceSeries& series, std::size_t first,
                       const std::vector<std::size_t>& rows) {
  PrintError print;
  std::vector<double> difference;
  for (const std::size_t row : rows) {
    const double exact = series.exact[first + row];
    difference.push_back(series.values[first + row] - exact);
    print.greatest = std::max(print.greatest, std::abs(exact));
  }
  const DifferenceNorms norms = norms_of(error.times, difference);
  print.max = norms.max;
  print.max_time = norms.max_time;
  print.rms = norms.rms;
  print.uncertainty = series.exact_uncertainty;
  return print;
}

void add_errors(const Run& run, std::optional<std::size_t> given_run, std::vector<SeriesError>& result) {
  const Case& spec = run.loaded.spec;
  for (std::size_t r = 0; r < spec.references.size(); ++r) {
    const ReferenceUse& use = spec.references[r];
    const Reference& reference = run.loaded.references[r];
    Demand demand{reference.times,
                  use.coverage,
                  "the reference",
                  "",
                  "",
                  use.tolerance,
                  reference.abscissa == Abscissa::mode};
    const std::vector<double> claimed = demand.claimed_times();
    const SampledRun sampled = sample_of(run, given_run, claimed);
    for (const Comparison& pair : use.compare) {
      const ReferenceSeries& series = *reference.find(pair.series);
      SeriesError error;
      error.given_run = given_run;
      error.reference = r;
      error.series = pair.series;
      error.column = demand.column = pair.column;
      error.unit = demand.unit = series.unit;
      const Covered covered =
          cover(demand, {{run_name(run, given_run), outputs_of(run, given_run), sampled}});
      error.coverage = covered.coverage;
      const auto first =
          static_cast<std::size_t>(std::find_if(reference.times.begin(), reference.times.end(),
                                                [&](double t) { return use.coverage.has(t); }) -
                                   reference.times.begin());
      error.scale = compared_scale(reference, use, error.unit, spec.cable.length);
      for (const std::size_t k : covered.times) error.times.push_back(claimed[k]);
      const auto hold_against = [&](const std::vector<double>& figures) {
        error.expected.clear();
        error.difference.clear();
        for (std::size_t k = 0; k < covered.times.size(); ++k) {
          error.expected.push_back(figures[first + covered.times[k]]);
          error.difference.push_back(sampled.values.find(pair.column)->values[covered.rows[0][k]] -
                                     error.expected.back());
        }
        const DifferenceNorms norms = norms_of(error.times, error.difference);
        error.max = norms.max;
        error.max_time = norms.max_time;
        error.rms = norms.rms;
      };
      hold_against(series.values);
      if (!series.exact.empty()) error.print = print_error(error, series, first, covered.times);
      result.push_back(error);
      if (series.exact.empty()) continue;
      hold_against(series.exact);
      error.exact = true;
      error.print.reset();
      result.push_back(std::move(error));
    }
  }
}

/// The external run that is meant; nullptr for one of Plumb's own.
const GivenRun* given_of(const Run& run, std::optional<std::size_t> given_run) {
  if (given_run) return &run.loaded.given_runs[*given_run];
  return reports_given_run(run.loaded.spec) ? &run.loaded.given_runs.front() : nullptr;
}

}  // namespace

void Magnitude::add(const std::vector<double>& values) {
  if (values.empty()) return;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  size = std::max({size, std::abs(*least), std::abs(*most)});
  reach = std::max(reach, *most - *least);
}

DifferenceNorms norms_of(const std::vector<double>& times, const std::vector<double>& difference) {
  DifferenceNorms norms;
  for (std::size_t k = 0; k < difference.size() && !std::isnan(norms.max); ++k) {
    const double distance = std::abs(difference[k]);
    if (distance <= norms.max) continue;
    norms.max = distance;
    norms.max_time = times[k];
  }
  if (!(norms.max > 0)) {
    norms.rms = norms.max;
    return norms;
  }
  // Scaled, so that a square does not overflow where the number itself does not.
  double squares = 0;
  for (const double x : difference) squares += x / norms.max * (x / norms.max);
  norms.rms = norms.max * std::sqrt(squares / static_cast<double>(difference.size()));
  return norms;
}

std::string failure_of(const Run& run, std::optional<std::size_t> given_run) {
  if (!given_run && run.trajectory.outcome != Outcome::completed && has_modes(run))
    return fmt::format("the run ended as {}", word(run.trajectory.outcome));
  if (!given_run)
    return run.trajectory.outcome == Outcome::completed
               ? ""
               : fmt::format("the run ended early, {} at {:.4g} s", word(run.trajectory.outcome),
                             run.trajectory.end_time);
  const GivenRun& given = run.loaded.given_runs[*given_run];
  if (!given.ending.failed()) return "";
  return fmt::format("the run of {} failed, {}", run_name(run, given_run), given.ending.in_words());
}

std::string given_name(const SeriesError& error, const Case& spec) {
  return error.given_run ? spec.given_runs[*error.given_run].name : "";
}

SampledRun sample_of(const Run& run, std::optional<std::size_t> given_run, const std::vector<double>& times) {
  const GivenRun* given = given_of(run, given_run);
  if (given == nullptr && has_modes(run)) return sample_modes(run.modes, times);
  return given != nullptr ? sample(*given, times) : sample(run.loaded.spec, run.trajectory, times);
}

const std::vector<double>& outputs_of(const Run& run, std::optional<std::size_t> given_run) {
  const GivenRun* given = given_of(run, given_run);
  return given != nullptr ? given->times : has_modes(run) ? run.modes.times : run.trajectory.times;
}

std::string run_name(const Run& run, std::optional<std::size_t> given_run) {
  return given_run ? run.loaded.spec.given_runs[*given_run].name : reported_name(run.loaded.spec);
}

std::vector<SeriesError> series_errors(const Run& run) {
  std::vector<SeriesError> result;
  add_errors(run, {}, result);
  for (std::size_t k = reports_given_run(run.loaded.spec) ? 1 : 0; k < run.loaded.given_runs.size(); ++k)
    add_errors(run, k, result);
  return result;
}

}  // namespace plumb
