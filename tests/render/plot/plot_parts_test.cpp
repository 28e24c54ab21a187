#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "engine/base/errors.h"
#include "render/image/color_map.h"
#include "render/plot/heat_map.h"
#include "render/plot/legend_layout.h"
#include "render/plot/plot_layout.h"
#include "render/plot/plot_renderer.h"
#include "render/plot/plot_theme.h"
#include "tests/render/image/pictures.h"

namespace plumb {
namespace plot_parts_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

HeatMap waves(int columns, int rows) {
  HeatMap map;
  for (int c = 0; c <= columns; ++c) map.x_edges.push_back(2.0 * c / columns);
  for (int r = 0; r <= rows; ++r) map.y_edges.push_back(1.0 * r / rows);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      map.values.push_back(2e-3 * std::sin(9.0 * c / columns + 2.0 * r / rows) * (1 - 0.8 * r / rows));
  map.label = "axial strain ε [1]";
  map.diverging = true;
  return map;
}

Series measured() {
  Series points;
  points.label = "measured";
  points.line_width = 0;
  points.marker = Marker::circle;
  for (int k = 0; k <= 12; ++k) {
    points.x.push_back(2.0 * k / 12);
    points.y.push_back(0.3 * std::cos(3 * points.x.back()));
    points.y_error.lower.push_back(points.y.back() - 0.06);
    points.y_error.upper.push_back(points.y.back() + 0.09);
    points.x_error.lower.push_back(points.x.back() - 0.05);
    points.x_error.upper.push_back(points.x.back() + 0.05);
  }
  return points;
}

Series ranged() {
  Series line;
  line.label = "mean and range";
  for (int k = 0; k <= 200; ++k) {
    line.x.push_back(2.0 * k / 200);
    line.y.push_back(0.3 * std::cos(3 * line.x.back()));
    line.band.lower.push_back(line.y.back() - 0.15);
    line.band.upper.push_back(line.y.back() + 0.1 + 0.1 * line.x.back());
  }
  return line;
}

/// Everything that a plot can have: a heat map over a panel with a band, error bars and rules that shares its
/// time, and one of logarithmic axes.
Plot all_parts() {
  Plot plot;
  plot.title = "Strain κ_{max} and ω_∞ at 10^{-3} m s^{-2}";
  plot.height = 1800;
  Panel map;
  map.y.label = "place [m]";
  map.heat_map = waves(60, 40);
  map.shares_x_below = true;
  Panel lines;
  lines.x.label = "time t [s]";
  lines.y.label = "height h_{tip} [m]";
  lines.series = {ranged(), measured()};
  lines.rules.resize(2);
  lines.rules[0].from = -0.05;
  lines.rules[0].to = 0.05;
  lines.rules[0].label = "tolerance";
  lines.rules[1].upright = true;
  lines.rules[1].from = lines.rules[1].to = 1.5;
  lines.rules[1].label = "released";
  lines.rules[1].dash = Dash::dashed;
  Panel logarithmic;
  logarithmic.x.label = "step Δt [s]";
  logarithmic.y.label = "error ε [m]";
  logarithmic.x.scale = logarithmic.y.scale = Scale::logarithmic;
  for (int s = 0; s < static_cast<int>(palette.size()); ++s) {
    Series series;
    series.label = "order p_{" + std::to_string(s + 1) + "}";
    for (int k = 0; k < 8; ++k) {
      series.x.push_back(std::pow(10.0, -5 + 0.5 * k));
      series.y.push_back(std::pow(series.x.back(), 0.4 * (s + 1)));
      series.y_error.lower.push_back(series.y.back() * (k < 3 ? -1 : 0.4));
      series.y_error.upper.push_back(series.y.back() * 2);
    }
    series.marker = Marker::square;
    logarithmic.series.push_back(series);
  }
  plot.panels = {map, lines, logarithmic};
  return plot;
}

std::array<int, 3> at(const Image& image, const Point& place) {
  const auto i =
      static_cast<std::size_t>(3 * (static_cast<int>(place.y()) * image.width + static_cast<int>(place.x())));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

std::array<int, 3> bytes(Color color) {
  const auto byte = [](float part) { return static_cast<int>(std::lround(255 * part)); };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

Plot small_map(std::vector<double> values) {
  Plot plot;
  plot.width = 800;
  plot.height = 600;
  plot.font_size = 18;
  plot.panels.resize(1);
  HeatMap map;
  map.x_edges = {0, 1, 3};
  map.y_edges = {0, 0.5, 2};
  map.values = std::move(values);
  plot.panels[0].heat_map = map;
  return plot;
}

TEST(PlotParts, LookRightAtTwoSizesAndInBothThemes) {
  const GlContext context;
  PlotRenderer renderer(context);
  for (const SceneTheme theme : {SceneTheme::light, SceneTheme::dark}) {
    const std::string name = theme == SceneTheme::light ? "plot_parts_light" : "plot_parts_dark";
    Plot plot = all_parts();
    plot.theme = theme;
    const Image large = renderer.draw(plot);
    keep(name, large);
    plot.width = 800;
    plot.height = 900;
    plot.font_size = 16;
    keep(name + "_small", renderer.draw(plot));
    EXPECT_EQ(at(large, {3, 3}), bytes(plot_theme(theme).paper));
    long different = 0;
    for (std::size_t i = 0; i < large.rgb.size(); i += 3)
      different += std::abs(large.rgb[i] - large.rgb[0]) > 60;
    EXPECT_GT(different, 100000) << name;
  }
}

TEST(PlotParts, StayInThePictureAndApart) {
  const Font font;
  for (const double scale : {0.4, 1.0, 2.0}) {
    Plot plot = all_parts();
    plot.width = static_cast<int>(plot.width * scale);
    plot.height = static_cast<int>(plot.height * scale);
    plot.font_size *= scale;
    const PlotSizes sizes(plot.font_size);
    const PlotLayout layout = plot_layout(plot, font);
    for (const PanelLayout& panel : layout.panels) {
      EXPECT_EQ(panel.frame.left, layout.panels[0].frame.left);
      EXPECT_EQ(panel.frame.right, layout.panels[0].frame.right) << "frames stay aligned beside a bar";
    }
    const ColorBarLayout& bar = layout.panels[0].color_bar.value();
    EXPECT_GT(bar.area.left, layout.panels[0].frame.right);
    for (const std::string& label : bar.ticks.labels)
      EXPECT_LT(bar.tick_left + font.measure(label, sizes.tick).width,
                bar.label_base - 0.7 * sizes.label.size);
    EXPECT_LT(bar.label_base, plot.width);
    EXPECT_EQ(layout.panels[0].x.range.lo, layout.panels[1].x.range.lo) << "one axis of time";
    EXPECT_EQ(layout.panels[0].x.range.hi, layout.panels[1].x.range.hi);
    EXPECT_FALSE(layout.panels[0].x_labels);
  }
}

TEST(PlotParts, LegendAvoidsBandsAndErrorBars) {
  const Plot plot = all_parts();
  const PlotLayout layout = plot_layout(plot, Font());
  for (const std::size_t p : {1U, 2U}) {
    const LegendLayout& legend = layout.panels[p].legend.value();
    if (legend.outside) continue;
    for (const Point& place : data_samples(plot.panels[p], layout.panels[p], 8))
      EXPECT_FALSE(legend.box.contains(place)) << "panel " << p << " at " << place.transpose();
  }
  Plot tall = plot;
  tall.panels = {plot.panels[1]};
  tall.panels[0].rules.clear();
  Series& line = tall.panels[0].series[0];
  tall.panels[0].series.pop_back();
  for (double& end : line.band.lower) end = -1;
  for (double& end : line.band.upper) end = 1;
  EXPECT_TRUE(plot_layout(tall, Font()).panels[0].legend->outside) << "the band fills the panel";
  line.band = {};
  EXPECT_FALSE(plot_layout(tall, Font()).panels[0].legend->outside);
}

TEST(PlotParts, BandsAndErrorBarsAreInTheRangeOfTheirAxis) {
  Plot plot;
  plot.panels.resize(1);
  plot.panels[0].series = {ranged(), measured()};
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_LT(panel.x.range.lo, -0.05);
  EXPECT_GT(panel.x.range.hi, 2.05);
  EXPECT_GT(panel.y.range.hi, 0.6);
  EXPECT_LT(panel.y.range.lo, -0.45);
}

TEST(HeatMap, CellsHaveTheColourOfTheirValue) {
  const GlContext context;
  PlotRenderer renderer(context);
  Plot plot = small_map({1, 2, nan, 4});
  const Image image = renderer.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(panel.x.range.lo, 0) << "the map fills its panel";
  EXPECT_EQ(panel.x.range.hi, 3);
  EXPECT_EQ(panel.y.range.hi, 2);
  const auto seen = [&](double x, double y) { return at(image, {panel.x(x), panel.y(y)}); };
  EXPECT_EQ(seen(0.1, 0.1), bytes(map_color(0)));
  EXPECT_EQ(seen(0.97, 0.47), bytes(map_color(0)));
  EXPECT_EQ(seen(1.03, 0.47), bytes(map_color(1.0 / 3)));
  EXPECT_EQ(seen(0.5, 1), bytes(Color::hex(0xFFFFFF))) << "not a number";
  EXPECT_EQ(seen(2, 1.9), bytes(map_color(1)));
  EXPECT_EQ(renderer.draw(plot), image) << "the same pixels again";
  plot.panels[0].heat_map->values[3] = 4.1;
  EXPECT_NE(renderer.draw(plot), image);
}

TEST(HeatMap, ThatDivergesIsEvenAboutZeroUnlessTold) {
  HeatMap map = waves(4, 4);
  map.values.assign(16, 0);
  map.values[3] = -1;
  map.values[5] = 3;
  EXPECT_EQ(color_range(map).lo, -3);
  EXPECT_EQ(color_range(map).hi, 3);
  map.range = {-1, 2};
  EXPECT_EQ(color_range(map).hi, 2);
  map.range.reset();
  map.diverging = false;
  EXPECT_EQ(color_range(map).lo, -1);
  map.values.assign(16, nan);
  EXPECT_LT(color_range(map).lo, color_range(map).hi) << "even of nothing";
}

TEST(HeatMap, OnALogarithmicAxisIsWhereItsEdgesAre) {
  const GlContext context;
  PlotRenderer renderer(context);
  Plot plot = small_map({1, 2, 3, 4});
  plot.panels[0].heat_map->x_edges = {1, 10, 1e4};
  plot.panels[0].x.scale = Scale::logarithmic;
  const Image image = renderer.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(at(image, {panel.x(9.5), panel.y(0.2)}), bytes(map_color(0)));
  EXPECT_EQ(at(image, {panel.x(10.7), panel.y(0.2)}), bytes(map_color(1.0 / 3)));
}

TEST(PlotParts, WhatDoesNotFitIsRefused) {
  const Font font;
  const auto refused = [&](auto change) {
    Plot plot = all_parts();
    change(plot);
    try {
      plot_layout(plot, font);
      return std::string();
    } catch (const OutputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refused([](Plot&) {}), "");
  EXPECT_EQ(refused([](Plot& plot) { plot.panels[1].series[0].band.lower.pop_back(); }),
            "plot: series 'mean and range' has 201 points and from 200 to 201 ends of an extent");
  EXPECT_EQ(refused([](Plot& plot) {
              plot.panels[1].series[1].y_error = {{1}, {2}};
            }),
            "plot: series 'measured' has 13 points and from 1 to 1 ends of an extent");
  EXPECT_EQ(refused([](Plot& plot) { plot.panels[0].heat_map->values.pop_back(); }),
            "plot: 2399 values of a heat map for 40 rows of 60");
  EXPECT_NE(refused([](Plot& plot) { plot.panels[0].heat_map->x_edges[3] = 0; }), "");
  EXPECT_EQ(refused([](Plot& plot) {
              plot.panels[0].heat_map->range = {1, 1};
            }),
            "plot: colours from 1 to 1: must be finite and ascending");
}

}  // namespace plot_parts_test
}  // namespace plumb
