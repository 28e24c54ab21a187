#pragma once

#include <string>
#include <utility>
#include <vector>

namespace plumb {

/// A mark in a chart. Data attributes let scripts find it; its title is shown where it is pointed at.
struct SvgMark {
  double x = 0, y = 0;
  std::string css;        ///< class
  std::string title;      ///< of several lines
  std::string link = {};  ///< where it leads; empty: nowhere
  std::string data = {};  ///< attributes, escaped: `data-kind="validation"`
  bool hollow = false;
};

struct SvgLine {
  std::vector<std::pair<double, double>> points;
  std::string css;  ///< class
};

struct SvgAxis {
  double from = 0, to = 1;
  bool logarithmic = false;
  std::string label = {};
  /// Places and texts; none: round numbers.
  std::vector<std::pair<double, std::string>> ticks = {};
};

/// A small chart that a page shows without scripts and in its own colours. Lines and marks are drawn in their
/// order; what is not finite, or of a logarithmic axis not above 0, is left out.
struct SvgChart {
  double width = 320, height = 180;  ///< in its own units, some pixels
  SvgAxis x, y;
  std::string alt;  ///< what it shows
  std::vector<SvgLine> lines = {};
  std::vector<SvgMark> marks = {};
};
std::string to_svg(const SvgChart& chart);

/// An axis that all of the values fit on, with some room; those that cannot be on it do not count.
SvgAxis fitted_axis(const std::vector<double>& values, bool logarithmic, const std::string& label);

}  // namespace plumb
