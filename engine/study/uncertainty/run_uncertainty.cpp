#include "engine/study/uncertainty/run_uncertainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "engine/integrate/integrate.h"
#include "engine/integrate/method_info.h"
#include "engine/read/uncertain_keys.h"
#include "engine/run/probes_json.h"
#include "engine/run/sampled_run.h"
#include "engine/study/reference/comparable_times.h"
#include "engine/study/uncertainty/explanation.h"
#include "engine/study/uncertainty/uncertainty_parts.h"

namespace plumb {
namespace {

/// Of one run, s of the processor: an estimate must not take longer than anyone waits for it.
constexpr double longest_run = 60;

/// What a planned run saw at the times of each reference, or why it has nothing to show.
struct Seen {
  std::vector<ProbeTable> at_references;
  std::string fault;

  ColumnValues column(std::size_t reference, const std::string& name) const {
    if (!fault.empty()) return {{}, fault};
    return {at_references[reference].find(name)->values, {}};
  }
};

template <class Archive>
void members(Archive& a, Seen& seen) {
  a("at_references", seen.at_references);
  a("fault", seen.fault);
}

Seen see(const PlannedRun& planned, const std::vector<std::vector<double>>& times) {
  if (!planned.fault.empty()) return {{}, planned.fault};
  const Trajectory trajectory = integrate(planned.spec, {}, longest_run);
  if (trajectory.outcome != Outcome::completed) return {{}, trajectory.message};
  Seen seen;
  for (const std::vector<double>& at : times)
    seen.at_references.push_back(probe(planned.spec, trajectory, at));
  return seen;
}

/// The samples of some of the uncertain inputs.
struct Samples {
  std::vector<UncertainInput> inputs;
  std::size_t first = 0;           // of the runs
  std::vector<std::string> texts;  // one a sample
};

/// The runs that are asked for, and what was seen of them.
struct Runs {
  ThreeMeshes meshes;
  std::vector<PlannedRun> planned;
  std::vector<Seen> seen;  // as `planned`
  bool has_numerical = false;
  std::vector<Samples> samples;
};

/// Those that a reference does not take as the case does.
std::vector<UncertainInput> inputs_beside(const UncertaintySpec& uncertainty, const SharedErrors& shares) {
  std::vector<UncertainInput> inputs;
  for (const UncertainInput& input : uncertainty.inputs)
    if (!shares.has_input(input.key)) inputs.push_back(input);
  return inputs;
}

constexpr std::size_t finer_run = 3;  // after three meshes

const Samples* samples_of(const Runs& runs, const std::vector<UncertainInput>& inputs) {
  const auto same = [&](const Samples& samples) { return samples.inputs == inputs; };
  const auto found = std::find_if(runs.samples.begin(), runs.samples.end(), same);
  return found == runs.samples.end() ? nullptr : &*found;
}

Runs plan(const LoadedCase& loaded) {
  const Case& spec = loaded.spec;
  Runs runs;
  runs.meshes = three_meshes(spec.cable.elements);
  runs.has_numerical = spec.uncertainty->numerical;
  if (runs.has_numerical) {
    for (const int elements : runs.meshes.elements) {
      PlannedRun mesh{spec, {}};
      mesh.spec.cable.elements = elements;
      mesh.spec = exact_in_time(mesh.spec);
      runs.planned.push_back(std::move(mesh));
    }
    runs.planned.push_back(finer_in_time(spec));
  }
  if (spec.uncertainty->samples == 0) return runs;
  for (const Reference& reference : loaded.references) {
    const std::vector<UncertainInput> inputs = inputs_beside(*spec.uncertainty, reference.shares);
    if (reference.kind == ReferenceKind::computed || inputs.empty() || samples_of(runs, inputs) != nullptr)
      continue;
    PlannedSamples planned = planned_samples(loaded, inputs);
    runs.samples.push_back({inputs, runs.planned.size(), std::move(planned.texts)});
    for (PlannedRun& sample : planned.runs) runs.planned.push_back(std::move(sample));
  }
  return runs;
}

void carry_out(Runs& runs, const std::vector<std::vector<double>>& times, Runner& runner) {
  std::vector<StudyPoint<Seen>> points;
  for (const PlannedRun& planned : runs.planned)
    points.push_back({fmt::format("run {}", points.size()), [&] { return see(planned, times); }});
  runs.seen = runner.run("uncertainty", points);
}

InputSampling sampling_of(const Run& run, const Runs& runs) {
  const UncertaintySpec& spec = *run.loaded.spec.uncertainty;
  InputSampling sampling;
  sampling.samples = spec.samples;
  sampling.seed = spec.seed;
  for (const UncertainInput& input : spec.inputs)
    sampling.inputs.push_back({input, *uncertain_value(run.loaded.spec, input.key)});
  for (const Samples& samples : runs.samples)
    for (std::size_t k = 0; k < samples.texts.size(); ++k) {
      const Seen& seen = runs.seen[samples.first + k];
      sampling.completed += seen.fault.empty();
      if (!seen.fault.empty())
        sampling.failures.push_back(fmt::format("{}: {}", samples.texts[k], seen.fault));
    }
  return sampling;
}

UncertaintyPart not_asked(const char* name, const char* why) {
  return {name, PartState::not_estimated, why, {}};
}

UncertaintyPart input_of(const Case& spec, const Runs& runs, const Reference& reference, std::size_t r,
                         const std::string& column) {
  const UncertaintySpec& uncertainty = *spec.uncertainty;
  const std::vector<UncertainInput> inputs = inputs_beside(uncertainty, reference.shares);
  if (reference.kind == ReferenceKind::computed)
    return {"input", PartState::no_part, "the reference is computed from the same input", {}};
  if (uncertainty.inputs.empty()) return not_asked("input", "the case says of no input how uncertain it is");
  if (inputs.empty())
    return {"input", PartState::no_part, "the reference has the same value of every uncertain input", {}};
  if (uncertainty.samples == 0) return not_asked("input", "[uncertainty] of the case has samples = 0");
  const Samples& samples = *samples_of(runs, inputs);
  std::vector<ColumnValues> columns;
  for (std::size_t k = 0; k < samples.texts.size(); ++k)
    columns.push_back(runs.seen[samples.first + k].column(r, column));
  return input_part(inputs.size(), uncertainty.seed, columns);
}

/// Whether a budget is that of a reference, and was computed.
bool is_of(const ErrorBudget* budget, const std::string& reference) {
  return budget != nullptr && budget->reference == reference && budget->left_out.empty();
}

/// What the budget knows of errors that the figures of a series have themselves, and that the run has not.
std::vector<DataError> data_errors(const ErrorBudget& budget, const SeriesUncertainty& series,
                                   bool shares_mesh) {
  std::vector<DataError> errors;
  for (const BudgetEntry& entry : budget.entries) {
    if (!entry.numerical || (entry.of_mesh && shares_mesh) || !entry.run.completed()) continue;
    errors.push_back({entry.name, difference_at(budget, entry.run, series)});
  }
  return errors;
}

std::vector<UncertaintyPart> parts_of(const Run& run, const Runs& runs, const ErrorBudget* budget,
                                      std::size_t r, const SeriesUncertainty& series,
                                      const SampledRun& sampled) {
  const Case& spec = run.loaded.spec;
  const Reference& reference = run.loaded.references[r];
  const std::string& column = series.column;
  const std::vector<double>& own = sampled.values.find(column)->values;
  const bool shares_mesh = reference.shares.has_mesh_of(spec.cable);
  const char* why_not = "[uncertainty] of the case has numerical = false";
  std::vector<UncertaintyPart> parts;
  if (shares_mesh) {
    parts.push_back(shared_mesh_part(spec.cable.elements));
  } else if (!runs.has_numerical) {
    parts.push_back(not_asked("mesh", why_not));
  } else {
    std::array<ColumnValues, 3> meshes;
    for (std::size_t k = 0; k < meshes.size(); ++k) meshes[k] = runs.seen[k].column(r, column);
    parts.push_back(mesh_part(runs.meshes, meshes));
  }
  parts.push_back(runs.has_numerical ? time_part(spec.method, own, runs.seen[finer_run].column(r, column))
                                     : not_asked("time integration", why_not));
  parts.push_back(interpolation_part(sampled.errors.find(column)->values));
  parts.push_back(input_of(spec, runs, reference, r, column));
  parts.push_back(data_part(*reference.find(series.series), own.size(),
                            is_of(budget, series.reference) ? data_errors(*budget, series, shares_mesh)
                                                            : std::vector<DataError>{}));
  return parts;
}

/// Why a run cannot be held against a reference; empty where it can.
std::string obstacle(const Run& run, const Reference& reference, const std::vector<double>& times) {
  if (run.trajectory.outcome != Outcome::completed) return "the run did not complete";
  if (const std::string other = difference(reference.cable, run.loaded.spec.cable); !other.empty())
    return "the reference is for another cable: " + other;
  if (times.empty()) return "no time of the reference can be compared";
  if (!(times.back() > 0)) return "no time of the reference can be compared but the start";
  return {};
}

}  // namespace

Uncertainty run_uncertainty(const Run& run, Runner& runner, const ErrorBudget* budget) {
  const auto started = std::chrono::steady_clock::now();
  const Case& spec = run.loaded.spec;
  Uncertainty result;
  std::vector<std::vector<std::size_t>> rows;
  std::vector<std::vector<double>> times;
  bool any = false;
  for (std::size_t r = 0; r < spec.references.size(); ++r) {
    const Reference& reference = run.loaded.references[r];
    ComparableTimes comparable = comparable_times(run, spec.references[r], reference);
    rows.push_back(std::move(comparable.rows));
    times.push_back(std::move(comparable.times));
    any = any || obstacle(run, reference, times.back()).empty();
  }
  Runs runs;
  if (any) {
    runs = plan(run.loaded);
    carry_out(runs, times, runner);
  }
  result.runs = static_cast<int>(runs.planned.size());
  result.sampling = sampling_of(run, runs);
  for (std::size_t r = 0; r < run.loaded.references.size(); ++r) {
    const Reference& reference = run.loaded.references[r];
    const ReferenceUse& use = spec.references[r];
    const std::string why_not = obstacle(run, reference, times[r]);
    if (!why_not.empty()) {
      for (const Comparison& pair : use.compare)
        result.left_out.push_back(fmt::format("{}: {}: {}", use.name, pair.column, why_not));
      continue;
    }
    const SampledRun seen = sample(spec, run.trajectory, times[r]);
    for (const Comparison& pair : use.compare) {
      const std::vector<double>& own = seen.values.find(pair.column)->values;
      const ReferenceSeries& data = *reference.find(pair.series);
      SeriesUncertainty series;
      series.reference = use.name;
      series.series = pair.series;
      series.column = pair.column;
      series.unit = data.unit;
      series.published = reference.kind == ReferenceKind::published;
      series.times = times[r];
      for (std::size_t t = 0; t < own.size(); ++t) series.error.push_back(own[t] - data.values[rows[r][t]]);
      series.parts = parts_of(run, runs, budget, r, series, seen);
      conclude(series);
      if (is_of(budget, use.name)) series.explanation = explanation(*budget, series);
      series.shared_model = reference.shares.model;
      result.series.push_back(std::move(series));
    }
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return result;
}

}  // namespace plumb
