#include "report/study/sensitivity/sensitivity_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/gl/markup.h"
#include "report/study/panel_parts.h"

namespace plumb {
namespace {

constexpr Color nothing_color = Color::hex(0xD5D9E0);

/// The smaller of both directions, %; -1: neither.
double least_percent(const NumberSensitivity& number, std::size_t criterion) {
  double least = -1;
  for (const SearchedSide* side : {&number.up, &number.down})
    if (const double change = side->noticed[criterion].change; change > 0 && (least < 0 || change < least))
      least = change;
  return least < 0 ? -1 : 100 * least;
}

}  // namespace

Figure sensitivity_figure(const Sensitivity& found) {
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < found.criteria.size(); ++k)
    if (found.criteria[k].met) shown.push_back(k);
  double least = 1;
  const double greatest = 100 * (found.largest - 1);
  for (const NumberSensitivity& number : found.numbers)
    for (const std::size_t k : shown)
      if (const double change = least_percent(number, k); change > 0) least = std::min(least, change);
  const double from = std::pow(10, std::floor(std::log10(least) - 1e-9));

  Figure figure;
  Panel panel;
  panel.x.label = "smallest change that is noticed: factor − 1, up or down [%]";
  panel.x.scale = Scale::logarithmic;
  panel.x.range = {from, 1.2 * greatest};
  constexpr double group_height = 0.84;
  const double height = group_height / static_cast<double>(std::max<std::size_t>(1, shown.size()));
  std::string text;
  bool any_nothing = false;
  for (std::size_t n = 0; n < found.numbers.size(); ++n) {
    // From the top down, as they are read.
    const NumberSensitivity& number = found.numbers[found.numbers.size() - 1 - n];
    const double middle = static_cast<double>(n);
    panel.y.ticks.push_back(middle);
    panel.y.tick_labels.push_back(number.words);
    for (std::size_t place = 0; place < shown.size(); ++place) {
      const double change = least_percent(number, shown[place]);
      const double top = middle + group_height / 2 - height * static_cast<double>(place);
      any_nothing = any_nothing || change < 0;
      panel.bars.push_back({{from, change < 0 ? 1.2 * greatest : change},
                            {top - 0.92 * height, top - 0.08 * height},
                            change < 0 ? nothing_color : palette[place % palette.size()]});
    }
  }
  for (std::size_t place = 0; place < shown.size(); ++place) {
    const std::string& name = found.criteria[shown[place]].name;
    panel.series.push_back(bar_key(literal(name), palette[place % palette.size()]));
    text += fmt::format(" {}:", name);
    for (const NumberSensitivity& number : found.numbers) {
      const double change = least_percent(number, shown[place]);
      text += fmt::format("{} {} {}", &number == &found.numbers.front() ? "" : ",", number.words,
                          change < 0 ? std::string("nothing") : fmt::format("{:.2g} %", change));
    }
    text += ".";
  }
  if (any_nothing) panel.series.push_back(bar_key("nothing is noticed", nothing_color));
  // Pixels: of a bar, between groups, and of the legend, which has the space above them to itself.
  constexpr int row = 30, gap = 24, legend_row = 42, around = 280;
  const int group = gap + row * static_cast<int>(std::max<std::size_t>(1, shown.size()));
  const int legend = legend_row * static_cast<int>(panel.series.size() + 1);
  panel.y.range = {-0.6, static_cast<double>(found.numbers.size()) - 0.4 + 1.0 * legend / group};

  figure.name = "sensitivity";
  figure.title = "The smallest change of each number that a criterion notices";
  figure.alt =
      "Bars on a logarithmic scale, a group for each number of the model and in it one a criterion: "
      "the shorter, the more is noticed." +
      text;
  figure.plot.title = figure.title;
  figure.plot.height = around + static_cast<int>(found.numbers.size()) * group + legend;
  figure.plot.font_size = 30;
  figure.plot.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace plumb
