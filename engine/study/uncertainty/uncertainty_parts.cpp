#include "engine/study/uncertainty/uncertainty_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/study/uncertainty/comparison_words.h"

namespace plumb {
namespace {

/// An index is taken as bounds of a uniform distribution about the solution (JCGM 100:2008, 4.3.7), as all
/// other parts are. ASME V&V 20-2009 (section 2-5) also has 1.15, for errors to one side, and 2, for normal
/// ones: of made comparisons whose errors are known twice the first covers 99.9 %, twice the second 85 %.
constexpr double index_coverage = std::numbers::sqrt3;

std::vector<double> standard(std::vector<double> index) {
  for (double& value : index) value /= index_coverage;
  return index;
}

UncertaintyPart part(const char* name, PartState state, std::string how, std::vector<double> values = {}) {
  return {name, state, std::move(how), std::move(values)};
}

constexpr const char* index_words = "over √3, as bounds of a uniform distribution";

/// The greatest difference of three columns where that is no more than rounding, as in a motion that every
/// mesh has exactly.
std::optional<double> change_by_rounding(const std::array<ColumnValues, 3>& columns) {
  constexpr double rounding = 1e-11;
  double change = 0, size = 0;
  if (columns[0].values.empty()) return {};
  for (std::size_t t = 0; t < columns[0].values.size(); ++t)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (!std::isfinite(columns[k].values[t])) return {};
      change = std::max(change, std::abs(columns[k].values[t] - columns[0].values[t]));
      size = std::max(size, std::abs(columns[k].values[t]));
    }
  return change <= rounding * size ? std::optional(change) : std::nullopt;
}

}  // namespace

UncertaintyPart mesh_part(const ThreeMeshes& meshes, const std::array<ColumnValues, 3>& columns) {
  constexpr const char* name = "mesh";
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (!columns[k].fault.empty())
      return part(
          name, PartState::not_estimated,
          fmt::format("the run with {} elements has no result: {}", meshes.elements[k], columns[k].fault));
  const std::string of = fmt::format("meshes of {}, {} and {} elements, exact in time", meshes.elements[0],
                                     meshes.elements[1], meshes.elements[2]);
  if (const std::optional<double> change = change_by_rounding(columns))
    return part(name, PartState::estimated,
                fmt::format("{}, agree to {:.2g}, which is rounding", of, *change),
                std::vector<double>(columns[0].values.size(), *change));
  const MeshIndex index = mesh_index(columns[0].values, columns[1].values, columns[2].values, meshes.of);
  if (index.order < 0)
    return part(name, PartState::not_estimated,
                of + ": the changes from one to the next do not fall, so that there is no order");
  const bool is_finest = meshes.of == OfThree::finest;
  const ColumnValues &own = columns[is_finest ? 0 : 2], &other = columns[is_finest ? 1 : 0];
  if (!is_possible_order(index.order))
    return part(
        name, PartState::bounded,
        fmt::format(
            "{}: their changes are of order {:.2g}, which elements of this kind do not have ({:g} to "
            "{:g}), so that nothing is extrapolated: three times the greatest change to the {} mesh up to "
            "each time as a bound; {}",
            of, index.order, least_possible_order, greatest_possible_order, is_finest ? "next" : "finest",
            index_words),
        standard(two_run_bound(own.values, other.values)));
  return part(name, PartState::estimated,
              fmt::format("grid convergence index of the {} of {}: order {:.2f} of the greatest changes{}, "
                          "safety factor {:g}; at each time of the greatest change up to then; {}",
                          is_finest ? "finest" : "coarsest", of, index.order,
                          index.order > mesh_order ? fmt::format(", counted as {:g}", mesh_order) : "",
                          certain_factor, index_words),
              standard(index.values));
}

UncertaintyPart time_part(const MethodSpec& method, const std::vector<double>& run,
                          const ColumnValues& finer) {
  constexpr const char* name = "time integration";
  if (!finer.fault.empty()) return part(name, PartState::not_estimated, finer.fault);
  const Refinement refinement = refinement_of(method);
  const std::string how =
      method.step ? fmt::format("{} with half its step, {:.3g} s, counted as of order {:g}", method.name,
                                *method.step / refinement.ratio, refinement.order)
                  : fmt::format(
                        "{} with a tenth of its tolerances, rtol {:.3g}, to which errors are taken to "
                        "be proportional",
                        method.name, *method.rtol / refinement.ratio);
  return part(
      name, PartState::estimated,
      fmt::format("grid convergence index of two runs, the other one {}; safety factor 3, as the order "
                  "is not observed; at each time of the greatest change up to then; {}",
                  how, index_words),
      standard(two_run_index(run, finer.values, refinement.ratio, refinement.order)));
}

UncertaintyPart interpolation_part(const std::vector<double>& errors) {
  constexpr const char* name = "interpolation";
  if (std::all_of(errors.begin(), errors.end(), [](double error) { return error == 0; }))
    return part(name, PartState::no_part, "every time of the comparison is an output of the run");
  std::vector<double> values;
  for (const double error : errors) values.push_back(error / std::numbers::sqrt3);
  return part(name, PartState::estimated,
              "between outputs: the greatest change at those next to a time when every second output is left "
              "out, taken as bounds of a uniform distribution, over √3",
              std::move(values));
}

UncertaintyPart input_part(std::size_t inputs, long seed, const std::vector<ColumnValues>& samples) {
  constexpr const char* name = "input";
  std::vector<const std::vector<double>*> good;
  for (const ColumnValues& sample : samples)
    if (sample.fault.empty()) good.push_back(&sample.values);
  if (good.size() < 2)
    return part(
        name, PartState::not_estimated,
        fmt::format("{} of {} samples have a result, and two are needed", good.size(), samples.size()));
  const auto n = static_cast<double>(good.size());
  std::vector<double> deviations(good.front()->size());
  for (std::size_t t = 0; t < deviations.size(); ++t) {
    double mean = 0, squares = 0;
    for (const auto* values : good) mean += (*values)[t] / n;
    for (const auto* values : good) squares += ((*values)[t] - mean) * ((*values)[t] - mean);
    deviations[t] = std::sqrt(squares / (n - 1));
  }
  return part(name, PartState::estimated,
              fmt::format("standard deviation over {} of {} samples, a Latin hypercube of {} with seed {}, "
                          "exact in time; known itself to some {:.0f} %",
                          good.size(), samples.size(),
                          inputs == 1 ? "one input" : fmt::format("{} independent inputs", inputs), seed,
                          100 / std::sqrt(2 * (n - 1))),
              std::move(deviations));
}

UncertaintyPart data_part(const ReferenceSeries& series, std::size_t count,
                          const std::vector<DataError>& errors) {
  const DataUncertainty data = data_uncertainty(series);
  std::vector<double> squares(count, data.standard * data.standard);
  std::string how = data.how;
  for (const DataError& error : errors) {
    double greatest = 0;
    for (std::size_t t = 0; t < count; ++t) {
      const double size = std::abs(error.difference[t]);
      greatest = std::isnan(size) ? size : std::max(greatest, size);
      squares[t] += std::pow(greatest / index_coverage, 2);
    }
    how += fmt::format(
        "{}{}",
        &error == &errors.front() ? "; errors of the computation behind it, from the error budget: " : ", ",
        error.name);
  }
  if (!errors.empty()) how += fmt::format(", each the greatest up to each time, {}", index_words);
  for (double& value : squares) value = std::sqrt(value);
  return part("data", PartState::estimated, std::move(how), std::move(squares));
}

UncertaintyPart shared_mesh_part(int elements) {
  return part(
      "mesh", PartState::no_part,
      fmt::format(
          "the reference was computed on the same mesh of {} elements: its error is in both, and not in "
          "their difference",
          elements));
}

void conclude(SeriesUncertainty& series) {
  series.validation.assign(series.times.size(), 0.0);
  series.beyond.clear();
  std::size_t within = 0;
  series.greatest = 0;
  for (std::size_t t = 0; t < series.times.size(); ++t) {
    double squares = 0;
    for (const UncertaintyPart& each : series.parts)
      if (each.has_values()) squares += each.values[t] * each.values[t];
    series.validation[t] = std::sqrt(squares);
    const double size = std::abs(series.error[t]);
    const bool is_within = std::isfinite(size) && size <= coverage_factor * series.validation[t];
    within += is_within;
    if (!is_within) series.beyond.push_back(t);
    // One that is not a number stays the greatest.
    const double greatest = std::abs(series.error[series.greatest]);
    if (!std::isnan(greatest) && !(size <= greatest)) series.greatest = t;
  }
  series.share_within = static_cast<double>(within) / static_cast<double>(series.times.size());
  series.finding = comparison_finding(series);
}

}  // namespace plumb
