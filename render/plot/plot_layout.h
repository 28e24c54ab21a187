#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/gl/shapes.h"
#include "render/gl/text.h"
#include "render/plot/axis_ticks.h"
#include "render/plot/plot.h"

namespace plumb {

/// Sizes of a plot's parts, pixels, all in proportion to its font size.
struct PlotSizes {
  explicit PlotSizes(double font_size);

  TextStyle title;
  TextStyle panel_title;
  TextStyle label;
  TextStyle tick;
  TextStyle legend;
  double line;         ///< width of a series' line
  double marker;       ///< diameter
  double marker_line;  ///< width of an open marker's outline
  int frame;           ///< width of a panel's outline
  int grid;
  double tick_length;
  double gap;  ///< between things that stand beside each other
};

/// The way from data to pixels along one axis.
struct AxisMap {
  AxisRange range;
  double start = 0;  ///< pixel of range.lo
  double end = 0;    ///< pixel of range.hi
  Scale scale = Scale::linear;

  /// Not a number for a value that a logarithmic axis has no place for.
  double operator()(double value) const;
};

struct LegendLayout {
  Rect box;
  bool outside = false;             ///< above the panel, as no place inside was free of data
  std::vector<std::size_t> series;  ///< indices of the entries
  std::vector<Point> at;            ///< left end of each entry's base line
};

/// The colours of a heat map beside its panel.
struct ColorBarLayout {
  Rect area;  ///< whole pixels
  AxisMap values;
  AxisTicks ticks;
  double tick_left = 0;   ///< where the labels of the ticks begin
  double label_base = 0;  ///< of the turned text: an x
  double exponent_base = 0;
};

/// A rule that reaches into its panel.
struct RuleLayout {
  std::size_t rule = 0;  ///< index
  Rect area;             ///< of a line, without width
  Rect label;            ///< the place of its label; empty: it has none, or there is no room
  Point at{0, 0};        ///< where the label's pen starts; upright rules have theirs turned
};

struct PanelLayout {
  Rect frame;  ///< whole pixels
  AxisMap x;
  AxisMap y;
  AxisTicks x_ticks;
  AxisTicks y_ticks;
  bool x_labels = true;   ///< false where the panel below shows them
  double title_base = 0;  ///< base lines of what stands around the frame, pixels
  double x_tick_base = 0;
  double x_label_base = 0;
  double y_label_base = 0;  ///< of the turned text: an x
  double y_exponent_base = 0;
  std::vector<RuleLayout> rules;
  std::optional<LegendLayout> legend;
  std::optional<ColorBarLayout> color_bar;
};

/// An entry of a plot's key: a category, or a line.
struct KeyEntry {
  bool category = true;
  std::size_t index = 0;  ///< among those of its kind
  Rect sample;            ///< of the colour, or what the line runs through from left to right
  Point at{0, 0};         ///< left end of the label's base line
};

struct PlotLayout {
  double title_base = 0;
  std::vector<KeyEntry> key;
  std::vector<PanelLayout> panels;
};

/// Where everything in a plot goes. Needs the font, but nothing that draws.
/// Throws OutputError when a series' x and y or their extents differ in number, a given range is not one or
/// has no place on a logarithmic axis, equal axes are not linear, a rule or bar is not a number, ticks have
/// labels but not one each, cells or a heat map do not fit their edges or the key, or the plot is too small.
PlotLayout plot_layout(const Plot& plot, const Font& font);

/// Points of a series in pixels; those that cannot be drawn are not finite.
std::vector<Point> pixels(const Series& series, const PanelLayout& panel);

/// The part of a bar that is in its panel, in pixels; empty where there is none.
Rect bar_area(const Bar& bar, const PanelLayout& panel);

/// "×10^{−5}" for -5, empty for 0.
std::string exponent_label(int exponent);

/// Length of a sample of a line, pixels: `least`, or longer where fewer than two dashes or four dots of it
/// would show, which would look like another line.
double line_sample(const Series& line, double least, const PlotSizes& sizes);

/// Length of the samples of lines in the panel's legend, pixels: longer where dashes must show beside
/// markers.
double legend_sample(const Panel& panel, const PlotSizes& sizes);

}  // namespace plumb
