#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/case/scene_settings.h"
#include "render/gl/shapes.h"
#include "render/image/color.h"

namespace plumb {

/// Texts may have markup (markup.h): "10^{-3}", "κ_{max}". What users wrote goes through literal() first.

/// From where to where each point of a series may be; both empty: not shown. It has a part in the range of
/// its axis.
struct Extent {
  std::vector<double> lower;
  std::vector<double> upper;  ///< as many as points, as `lower`
};

/// Points joined by a line, shown by markers, or both. Points that are not finite, or not above 0 on a
/// logarithmic axis, are left out and break the line.
struct Series {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x;
  std::vector<double> y;       ///< as many as x
  std::optional<Color> color;  ///< default: the palette's, by the place of the series in its panel
  double line_width = 1;       ///< in units of the plot's line width; 0: no line
  Dash dash = Dash::solid;
  Marker marker = Marker::none;
  bool open_marker = true;  ///< outline only, so that what lies below shows
  double marker_size = 1;   ///< in units of the plot's marker size
  Extent band = {};         ///< of y, shaded below all lines
  Extent x_error = {};      ///< bars with caps, where they are longer than the marker
  Extent y_error = {};
};

enum class Scale { linear, logarithmic };

struct Axis {
  std::string label;                           ///< with its unit: "time [s]"
  std::optional<std::array<double, 2>> range;  ///< lo < hi; default: the data's with a small margin
  bool zero_line = false;                      ///< draws a line at 0, where that is in the range
  Scale scale = Scale::linear;
  std::vector<double> ticks = {};             ///< marked and labelled instead of round values; ascending
  std::vector<std::string> tick_labels = {};  ///< one for each of `ticks`, instead of its value; or none
  std::string column = {};                    ///< of a run's probes, that it shows; empty: none
};

/// A value worth knowing along one axis, below the series: a line, or a shaded band between two values. It
/// has no part in the range of its axis; of a band, what is in the range is drawn.
struct Rule {
  bool upright = false;  ///< at a value of x, rather than of y
  double from = 0;
  double to = 0;               ///< equal to `from`: a line; either may be infinite
  std::string label;           ///< written along it, where it hides the least of the data; may be empty
  std::optional<Color> color;  ///< default: a grey
  Dash dash = Dash::solid;     ///< of a line
};

/// A filled rectangle between two values of x and two of y, below the series. It has no part in the ranges of
/// the axes, and is drawn as far as it is in them.
struct Bar {
  std::array<double, 2> x;
  std::array<double, 2> y;
  Color color;
};

/// A kind of cell, told by its colour and by its letter.
struct CellCategory {
  std::string label;   ///< in the key; empty: not there
  std::string letter;  ///< in every cell, where there is room
  Color color;
};

/// Rectangles that fill a panel below its series and rules, in place of grid lines. Each is of one category.
struct CellGrid {
  std::vector<double> x_edges;  ///< rising, one more than columns
  std::vector<double> y_edges;  ///< rising, one more than rows
  std::vector<int>
      categories;  ///< rows from below, each from the left: places in PlotKey::categories; -1: none
};

/// Rectangles that fill a panel as those of a CellGrid do, each coloured by a number, with a bar of the
/// colours to the right of the panel.
struct HeatMap {
  std::vector<double> x_edges;  ///< rising, one more than columns
  std::vector<double> y_edges;  ///< rising, one more than rows
  std::vector<double> values;   ///< rows from below, each from the left; what is not finite is left out
  std::string label;            ///< of the colours' bar, with the unit
  std::optional<std::array<double, 2>> range;  ///< lo < hi; default: the values', even about 0 if diverging
  bool diverging = false;                      ///< two hues that part at the middle of the range
};

/// What a plot says once of all its panels, below its title.
struct PlotKey {
  std::vector<CellCategory> categories;
  std::vector<Series> lines;  ///< of whose looks samples are shown; they have no points
};

/// One coordinate system. Series are drawn in order, the last on top.
struct Panel {
  std::string title;  ///< small, above the panel; may be empty
  Axis x;
  Axis y;
  std::optional<CellGrid> cells;
  std::vector<Series> series;
  std::vector<Rule> rules;
  std::vector<Bar> bars = {};
  std::optional<HeatMap> heat_map = {};
  double height_share = 1;      ///< of the height, relative to the other panels, > 0
  bool equal_axes = false;      ///< one unit is as long along x as along y; linear axes only
  bool shares_x_below = false;  ///< has the x axis of the panel below, which alone shows its labels
  bool legend = true;           ///< for series with a label
};

/// A figure: panels stacked from the top, in rows where it has several columns. `font_size` suits a print at
/// half a page's width.
struct Plot {
  std::string title;
  std::vector<Panel> panels;
  PlotKey key;
  int columns = 1;        ///< ≥ 1; panels run along the rows, and share the width of a column
  int width = 1600;       ///< pixels
  int height = 1200;      ///< pixels
  double font_size = 36;  ///< of labels, pixels, > 0; widths of lines and markers go with it
  SceneTheme theme = SceneTheme::light;  ///< colours that would not be seen on it are shifted
};

}  // namespace plumb
