#include <fmt/format.h>

#include <map>

#include "report/study/sweep/sweep_results.h"

namespace plumb {
namespace {

/// One colour for each outcome, told apart by people with any of the common colour blindnesses: what is right
/// in blue and green, what is wrong and says so in warm colours and greys.
Color color_of(Outcome outcome) {
  static const std::map<Outcome, Color> colors{{Outcome::accurate, Color::hex(0x0072B2)},
                                               {Outcome::inaccurate, Color::hex(0x56B4E9)},
                                               {Outcome::unstable, Color::hex(0xD55E00)},
                                               {Outcome::diverged, Color::hex(0x7F2A00)},
                                               {Outcome::no_convergence, Color::hex(0xE69F00)},
                                               {Outcome::singular, Color::hex(0xCC79A7)},
                                               {Outcome::unstable_equilibrium, Color::hex(0x8C564B)},
                                               {Outcome::out_of_time, Color::hex(0x999999)},
                                               {Outcome::completed, Color::hex(0x009E73)},
                                               {Outcome::not_run, Color::hex(0x000000)}};
  return colors.at(outcome);
}

}  // namespace

std::vector<Figure> sweep_figures(const Sweep& sweep) {
  constexpr double half_height = 0.36;
  std::vector<std::pair<std::string, OutcomeCounts>> rows = outcome_counts_by_method(sweep);
  rows.insert(rows.begin(), {"all methods", outcome_counts(sweep)});

  Panel panel;
  panel.x.label = "share of the runs [%]";
  panel.x.range = {0, 100};
  panel.y.range = {-0.7, static_cast<double>(rows.size()) - 0.3};
  for (const Outcome outcome : shown_outcomes(sweep)) {
    Series entry;
    entry.label = word(outcome);
    entry.color = color_of(outcome);
    entry.line_width = 0;
    entry.marker = Marker::square;
    entry.open_marker = false;
    entry.marker_size = 1.6;
    panel.series.push_back(std::move(entry));
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    // From the top down, as they are read.
    const std::size_t from_top = rows.size() - 1 - k;
    const auto& [name, counts] = rows[from_top];
    panel.y.ticks.push_back(static_cast<double>(k));
    panel.y.tick_labels.push_back(name);
    double all = 0, share = 0;
    for (const auto& [outcome, count] : counts) all += static_cast<double>(count);
    const auto y = static_cast<double>(k);
    for (const Outcome outcome : shown_outcomes(sweep)) {
      const auto found = counts.find(outcome);
      if (found == counts.end()) continue;
      const double next = share + 100 * static_cast<double>(found->second) / all;
      panel.bars.push_back({{share, next}, {y - half_height, y + half_height}, color_of(outcome)});
      share = next;
    }
  }

  Figure figure;
  figure.name = "sweep_outcomes";
  figure.title = fmt::format("How {} random cases ended", sweep.runs.size());
  figure.alt = "Bars of the shares of each outcome, for all runs and for each method:";
  const OutcomeCounts counts = outcome_counts(sweep);
  for (const Outcome outcome : shown_outcomes(sweep)) {
    const auto found = counts.find(outcome);
    figure.alt +=
        fmt::format(" {} {}", word(outcome),
                    share_in_words(found == counts.end() ? 0 : found->second, std::ssize(sweep.runs)));
  }
  figure.plot.title = figure.title;
  figure.plot.height = 300 + 62 * static_cast<int>(rows.size());
  figure.plot.font_size = 30;
  figure.plot.panels.push_back(std::move(panel));
  return {std::move(figure)};
}

}  // namespace plumb
