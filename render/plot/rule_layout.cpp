#include "render/plot/rule_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/plot/legend_layout.h"

namespace plumb {

namespace {

// The pixel of a value that may be infinite or, on a logarithmic axis, have no place: then an end of the
// axis.
double cut(const AxisMap& axis, double value) {
  if (!(value > axis.range.lo)) return axis.start;
  if (!(value < axis.range.hi)) return axis.end;
  return axis(value);
}

// Tries both ends of a rule, inside and outside of a band, and takes the place that hides the least.
void place_label(RuleLayout& placed, const Rule& rule, const Rect& frame, const std::vector<Point>& data,
                 const PlotSizes& sizes, const Font& font) {
  const double length = font.measure(rule.label, sizes.legend).width;
  const double height = 1.2 * sizes.legend.size;
  const double rise = 0.92 * sizes.legend.size;  // from the top of the place to the base line
  const double pad = 0.3 * sizes.gap;
  const double along = rule.upright ? frame.height() : frame.width();
  if (rule.label.empty() || length + 2 * sizes.gap > along) return;

  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const double end : {1.0, 0.0}) {
    const double from = sizes.gap + end * (along - 2 * sizes.gap - length);
    std::vector<Rect> places;
    if (rule.upright) {
      const double top = frame.bottom - from - length;
      for (const double left :
           {placed.area.left + pad, placed.area.left - pad - height, placed.area.right + pad})
        places.push_back({left, top, left + height, top + length});
    } else {
      const double left = frame.left + from;
      for (const double top :
           {placed.area.top + pad, placed.area.top - pad - height, placed.area.bottom + pad})
        places.push_back({left, top, left + length, top + height});
    }
    for (const Rect& place : places) {
      if (place.left < frame.left || place.right > frame.right || place.top < frame.top ||
          place.bottom > frame.bottom)
        continue;
      const auto hidden = static_cast<std::size_t>(
          std::count_if(data.begin(), data.end(), [&](const Point& p) { return place.contains(p); }));
      if (hidden >= least) continue;
      least = hidden;
      placed.label = place;
      placed.at = rule.upright ? Point(place.left + rise, place.bottom) : Point(place.left, place.top + rise);
    }
  }
}

}  // namespace

std::vector<RuleLayout> rule_layouts(const Panel& panel, const PanelLayout& layout, const PlotSizes& sizes,
                                     const Font& font) {
  std::vector<RuleLayout> result;
  if (panel.rules.empty()) return result;
  const std::vector<Point> data = data_samples(panel, layout, sizes.gap);
  for (std::size_t i = 0; i < panel.rules.size(); ++i) {
    const Rule& rule = panel.rules[i];
    const AxisMap& axis = rule.upright ? layout.x : layout.y;
    const auto [lo, hi] = std::minmax(rule.from, rule.to);
    if (hi < axis.range.lo || lo > axis.range.hi) continue;
    RuleLayout placed;
    placed.rule = i;
    placed.area = layout.frame;
    if (rule.upright) {
      placed.area.left = cut(axis, lo);
      placed.area.right = cut(axis, hi);
    } else {
      placed.area.top = cut(axis, hi);
      placed.area.bottom = cut(axis, lo);
    }
    place_label(placed, rule, layout.frame, data, sizes, font);
    result.push_back(placed);
  }
  return result;
}

}  // namespace plumb
