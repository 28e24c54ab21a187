#include "report/study/economy/economy_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/method_info.h"
#include "engine/study/economy/candidates.h"
#include "report/study/economy/economy_text.h"

namespace plumb {
namespace {

/// Candidates that are alike, and how they look.
struct Family {
  const char* label;
  Color color;
  Marker marker;
  bool (*has)(const Candidate& candidate);
};

bool is_cable(const Candidate& candidate) {
  return candidate.cable.model == CableModel::cable;
}
bool is_implicit(const Candidate& candidate) {
  return find_method(candidate.method.name)->implicit;
}
bool is_reduced(const Candidate& candidate) {
  return candidate.cable.quadrature == QuadratureRule::reduced;
}
bool is_slack(const Candidate& candidate) {
  return candidate.cable.second_moment == 0;
}

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"rigid rod", Color::hex(0x000000), Marker::diamond,
       [](const Candidate& candidate) { return candidate.cable.model == CableModel::rigid; }},
      {"chain", Color::hex(0xE69F00), Marker::triangle_up,
       [](const Candidate& candidate) { return candidate.cable.model == CableModel::chain; }},
      {"cable", Color::hex(0x0072B2), Marker::circle,
       [](const Candidate& candidate) {
         return is_cable(candidate) && !is_implicit(candidate) && !is_reduced(candidate) &&
                !is_slack(candidate);
       }},
      {"reduced quadrature", Color::hex(0x009E73), Marker::square,
       [](const Candidate& candidate) {
         return is_cable(candidate) && !is_implicit(candidate) && is_reduced(candidate);
       }},
      {"no bending", Color::hex(0xCC79A7), Marker::triangle_down,
       [](const Candidate& candidate) {
         return is_cable(candidate) && !is_implicit(candidate) && !is_reduced(candidate) &&
                is_slack(candidate);
       }},
      {"long implicit steps", Color::hex(0x56B4E9), Marker::square,
       [](const Candidate& candidate) { return is_cable(candidate) && is_implicit(candidate); }},
  };
  return all;
}

void add(Series& series, const TriedCandidate& tried, double error) {
  series.x.push_back(1e3 * tried.seconds);
  series.y.push_back(error);
}

bool drawable(const TriedCandidate& tried) {
  return tried.seconds > 0 && tried.estimate > 0 && std::isfinite(tried.estimate);
}

}  // namespace

Figure economy_figure(const Economy& economy) {
  Panel panel;
  panel.x.label = "time loop [ms]";
  panel.x.scale = Scale::logarithmic;
  panel.y.label = "picture error, estimated [px]";
  panel.y.scale = Scale::logarithmic;
  for (const Family& family : families()) {
    Series series;
    series.label = family.label;
    series.color = family.color;
    series.marker = family.marker;
    series.line_width = 0;
    for (const TriedCandidate& tried : economy.tried)
      if (drawable(tried) && family.has(tried.candidate)) add(series, tried, tried.estimate);
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  Series truth;
  truth.label = "true error";
  truth.color = Color::hex(0x555555);
  truth.marker = Marker::cross;
  truth.line_width = 0;
  for (const TriedCandidate& tried : economy.tried)
    if (tried.seconds > 0 && tried.true_error > 0 && std::isfinite(tried.true_error))
      add(truth, tried, tried.true_error);
  if (!truth.x.empty()) panel.series.push_back(std::move(truth));
  const TriedCandidate* choice = economy.choice();
  if (choice != nullptr && drawable(*choice)) {
    Series chosen;
    chosen.label = "chosen";
    chosen.color = Color::hex(0xD55E00);
    chosen.marker = Marker::circle;
    chosen.marker_size = 2;
    chosen.line_width = 0;
    add(chosen, *choice, choice->estimate);
    panel.series.push_back(std::move(chosen));
  }
  // The range of the errors has the tolerance in it.
  double lo = economy.tolerance / economy_safety, hi = economy.tolerance;
  for (const Series& series : panel.series)
    for (const double y : series.y) {
      lo = std::min(lo, y);
      hi = std::max(hi, y);
    }
  panel.y.range = {lo / 2, hi * 2};
  panel.rules.push_back({.from = economy.tolerance,
                         .to = economy.tolerance,
                         .label = fmt::format("tolerance of the scene, {:g} px", economy.tolerance),
                         .color = Color::hex(0xD55E00),
                         .dash = Dash::solid});
  panel.rules.push_back({.from = economy.tolerance / economy_safety,
                         .to = economy.tolerance / economy_safety,
                         .label = fmt::format("to hold: 1/{:g} of it", economy_safety),
                         .color = {},
                         .dash = Dash::dashed});
  Figure figure;
  figure.name = "economy";
  figure.title = "Picture error against cost: what the scene needs";
  figure.alt =
      fmt::format("Estimated picture error over time of {} candidates, with the tolerance of {:g} px",
                  economy.tried.size(), economy.tolerance);
  if (choice != nullptr)
    figure.alt +=
        fmt::format("; chosen: {}, {}", in_words(choice->candidate), pixels_in_words(choice->estimate));
  figure.plot.title = figure.title;
  figure.plot.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace plumb
