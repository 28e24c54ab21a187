#include "report/verdict/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace plumb {
namespace {

constexpr auto nowhere = std::numeric_limits<std::size_t>::max();

/// Why a run says nothing at a claimed time; empty where it does. `row` is that of its sample, or nowhere.
std::string obstacle(const ComparedRun& run, std::size_t row, double t, const Demand& demand) {
  if (demand.of_modes)
    return row != nowhere
               ? ""
               : fmt::format("{} does not have mode {:g}: it has {}", run.name, t,
                             run.outputs.empty() ? "none" : fmt::format("those to {:g}", run.outputs.back()));
  if (run.outputs.empty()) return run.name + " has no outputs";
  if (row == nowhere)
    return fmt::format(
        "{} does not have t = {:.4g} s: it is from {:.4g} to {:.4g} s, and nothing is extrapolated", run.name,
        t, run.outputs.front(), run.outputs.back());
  const Column* errors = run.sampled.errors.find(demand.column);
  if (errors == nullptr) return fmt::format("{} has no column {}", run.name, demand.column);
  const double error = errors->values[row];
  const auto faults = run.sampled.faults.find(demand.column);
  if (faults != run.sampled.faults.end() && !faults->second[row].empty())
    return fmt::format("{} of {}: {}", demand.column, run.name, faults->second[row]);
  if (bearable(error, demand.tolerance)) return "";
  if (faults != run.sampled.faults.end())
    return fmt::format(
        "{} of {} is {:.2g} {} off up to {:.4g} s where every second output is left out, more than {:g} % of "
        "the tolerance",
        demand.column, run.name, error, demand.unit, t, 100 * bearable_share);
  const KnownTime& at = run.sampled.times[row];
  if (run.sampled.between_is_unknown)
    return fmt::format("{} has no output at t = {:.4g} s, and equilibria are not interpolated", run.name, t);
  const double tried = tried_distance(run.outputs, at);
  if (tried == 0)
    return fmt::format(
        "{} has no output within {:.3g} s of t = {:.4g} s, and {} outputs are too few to tell how "
        "good interpolation is",
        run.name, at.distance / 2, t, run.outputs.size());
  if (!(at.distance <= tried * (1 + 1e-9)))
    return fmt::format(
        "{} has no output within {:.3g} s of t = {:.4g} s, and interpolation was not tried as far "
        "as {:.3g} s",
        run.name, tried, t, at.distance);
  return fmt::format(
      "{} has no output at t = {:.4g} s, and interpolation may be {:.2g} {} off there, more than "
      "{:g} % of the tolerance",
      run.name, t, error, demand.unit, 100 * bearable_share);
}

/// The place in the sample of each claimed time.
std::vector<std::size_t> places(const SampledRun& sampled, std::size_t count) {
  std::vector<std::size_t> result(count, nowhere);
  for (std::size_t row = 0; row < sampled.rows.size(); ++row) result[sampled.rows[row]] = row;
  return result;
}

double longest_gap(const std::vector<double>& outputs, double first, double last) {
  double longest = 0;
  for (std::size_t k = 1; k < outputs.size(); ++k)
    if (outputs[k] > first && outputs[k - 1] < last) longest = std::max(longest, outputs[k] - outputs[k - 1]);
  return longest;
}

/// "no more than to 1 s and 90 % of the times there"
std::string allowance_of(const CoverageSpec& claimed) {
  std::string text;
  if (claimed.from) text += fmt::format(" from {:g} s", *claimed.from);
  if (claimed.to) text += fmt::format(" to {:g} s", *claimed.to);
  if (claimed.share < 1)
    text += fmt::format("{} {:g} % of the times{}", text.empty() ? "" : " and", 100 * claimed.share,
                        text.empty() ? "" : " there");
  return text.empty() ? "" : "the case claims no more than" + text;
}

}  // namespace

std::vector<double> Demand::claimed_times() const {
  std::vector<double> result;
  for (const double t : times)
    if (claimed.has(t)) result.push_back(t);
  return result;
}

Covered cover(const Demand& demand, const std::vector<ComparedRun>& runs) {
  const std::vector<double> claimed = demand.claimed_times();
  std::vector<std::vector<std::size_t>> place_of;
  for (const ComparedRun& run : runs) place_of.push_back(places(run.sampled, claimed.size()));

  Covered covered;
  covered.rows.resize(runs.size());
  Coverage& coverage = covered.coverage;
  coverage.demanded = claimed.size();
  coverage.share = demand.claimed.share;
  coverage.of_modes = demand.of_modes;
  coverage.allowance = allowance_of(demand.claimed);
  std::string first_obstacle;
  for (std::size_t k = 0; k < claimed.size(); ++k) {
    std::string why_not;
    double error = 0;
    bool interpolated = false;
    for (std::size_t r = 0; r < runs.size() && why_not.empty(); ++r) {
      const std::size_t row = place_of[r][k];
      why_not = obstacle(runs[r], row, claimed[k], demand);
      if (!why_not.empty()) continue;
      error += runs[r].sampled.errors.find(demand.column)->values[row];
      interpolated = interpolated || !runs[r].sampled.times[row].output;
    }
    if (!why_not.empty()) {
      if (first_obstacle.empty()) first_obstacle = std::move(why_not);
      continue;
    }
    covered.times.push_back(k);
    for (std::size_t r = 0; r < runs.size(); ++r) covered.rows[r].push_back(place_of[r][k]);
    coverage.interpolated += interpolated;
    coverage.interpolation_error = std::max(coverage.interpolation_error, error);
  }
  // A time so near to 0 that a run has its start for it is the start.
  bool after_start = false;
  for (std::size_t k = 0; k < covered.times.size(); ++k)
    after_start = after_start || std::all_of(runs.begin(), runs.end(), [&](const ComparedRun& run) {
                    const std::size_t r = static_cast<std::size_t>(&run - runs.data());
                    return run.sampled.times[covered.rows[r][k]].time > 0;
                  });
  coverage.compared = covered.times.size();
  if (coverage.compared > 0) {
    coverage.first = claimed[covered.times.front()];
    coverage.last = claimed[covered.times.back()];
    for (const ComparedRun& run : runs)
      coverage.longest_gap =
          std::max(coverage.longest_gap, longest_gap(run.outputs, coverage.first, coverage.last));
  }

  const auto least = coverage.share * static_cast<double>(coverage.demanded) * (1 - 1e-9);
  const std::string why = first_obstacle.empty() ? "" : ": " + first_obstacle;
  if (std::none_of(claimed.begin(), claimed.end(), [](double t) { return t > 0; }))
    coverage.lacking = fmt::format("{} has no time after t = 0{}", demand.of,
                                   coverage.allowance.empty() ? "" : " in what the case claims");
  else if (static_cast<double>(coverage.compared) < least)
    coverage.lacking = fmt::format("only {} of {} {}s of {} can be compared{}", coverage.compared,
                                   coverage.demanded, demand.of_modes ? "mode" : "time", demand.of, why);
  else if (!after_start)
    coverage.lacking = fmt::format("no time of {} after t = 0 can be compared{}", demand.of, why);
  if (!coverage.lacking.empty() && coverage.share < 1)
    coverage.lacking += fmt::format(" ({})", coverage.allowance);
  return covered;
}

std::string in_words(const Coverage& coverage, const std::string& unit) {
  if (coverage.of_modes)
    return fmt::format("over {} of {} modes from {:g} to {:g}{}{}", coverage.compared, coverage.demanded,
                       coverage.first, coverage.last, coverage.allowance.empty() ? "" : "; ",
                       coverage.allowance);
  std::string text =
      fmt::format("over {} of {} times from {:.4g} to {:.4g} s, outputs at most {:.3g} s apart",
                  coverage.compared, coverage.demanded, coverage.first, coverage.last, coverage.longest_gap);
  if (coverage.interpolated > 0)
    text +=
        fmt::format("; {} of them interpolated, which may be {:.2g} {} off (every second output left out)",
                    coverage.interpolated, coverage.interpolation_error, unit);
  if (!coverage.allowance.empty()) text += "; " + coverage.allowance;
  return text;
}

}  // namespace plumb
