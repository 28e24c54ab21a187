#include "render/plot/plot_renderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "render/plot/plot_layout.h"
#include "tests/render/image/pictures.h"

namespace plumb {
namespace plot_renderer_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <typename Function>
Series sampled(const std::string& label, int count, double end, Function f) {
  Series s;
  s.label = label;
  for (int i = 0; i <= count; ++i) {
    s.x.push_back(end * i / count);
    s.y.push_back(f(s.x.back()));
  }
  return s;
}

double mid(double t) {
  return -0.19 + 0.19 * std::cos(7 * t) * (1 - 0.1 * t) - 0.01 * std::cos(31 * t);
}

Series published(Series s) {
  s.label = "published";
  s.line_width = 0;
  s.marker = Marker::circle;
  s.color = palette[1];
  return s;
}

Plot over_time() {
  Plot plot;
  plot.title = "Vertical position of the middle";
  Panel upper;
  upper.y.label = "mid y [m]";
  upper.height_share = 2.4;
  upper.shares_x_below = true;
  upper.series.push_back(sampled("Plumb", 1000, 2, mid));
  upper.series.push_back(published(sampled("", 100, 2, mid)));
  Panel lower;
  lower.x.label = "time [s]";
  lower.y.label = "difference [m]";
  lower.y.zero_line = true;
  lower.series.push_back(
      sampled("", 100, 2, [](double t) { return 1e-5 * (std::sin(21 * t) * t + 0.3 * std::cos(77 * t)); }));
  plot.panels = {upper, lower};
  return plot;
}

Plot tip_path() {
  Plot plot;
  plot.title = "Tip in the horizontal plane";
  plot.height = 1600;
  const auto x = [](double t) {
    return (1 - 0.15 * t) * std::cos(3.5 * t) * (0.75 + 0.25 * std::cos(7 * t));
  };
  const auto z = [](double t) {
    return -(1 - 0.15 * t) * std::sin(3.5 * t) * (0.75 + 0.25 * std::cos(7 * t));
  };
  const auto path = [&](int count) {
    Series s = sampled("Plumb", count, 2, z);
    for (double& value : s.x) value = x(value);
    return s;
  };
  Panel upper;
  upper.x.label = "tip x [m]";
  upper.y.label = "tip z [m]";
  upper.equal_axes = true;
  upper.height_share = 3;
  upper.series = {path(1000), published(path(100))};
  Panel lower;
  lower.x.label = "time [s]";
  lower.y.label = "difference [m]";
  lower.y.zero_line = true;
  lower.series = {sampled("x", 200, 2, [](double t) { return 2e-3 * t * std::sin(9 * t); }),
                  sampled("z", 200, 2, [](double t) { return 3e-3 * t * std::cos(11 * t); })};
  plot.panels = {upper, lower};
  return plot;
}

Plot energies() {
  Plot plot;
  plot.title = "Energies";
  Panel upper;
  upper.y.label = "energy [J]";
  upper.height_share = 2.4;
  upper.shares_x_below = true;
  upper.y.zero_line = true;
  const auto kinetic = [](double t) { return 0.021 - 0.5 * mid(t) * 0.0785; };
  const auto axial = [](double t) { return 4e-4 * std::pow(std::sin(40 * t), 2); };
  const auto bending = [](double t) { return 1e-4 * std::pow(std::sin(9 * t), 2); };
  upper.series = {sampled("kinetic", 500, 2, kinetic), sampled("axial", 500, 2, axial),
                  sampled("bending", 500, 2, bending),
                  sampled("potential", 500, 2, [](double t) { return 0.0785 * 0.5 * mid(t); }),
                  sampled("total", 500, 2, [](double) { return 0.021; })};
  upper.series[4].color = palette[6];
  upper.series[4].dash = Dash::dashed;
  Panel lower;
  lower.x.label = "time [s]";
  lower.y.label = "drift [1]";
  lower.series = {sampled("", 500, 2, [](double t) { return 3.2e-9 * t * (1 + 0.1 * std::sin(60 * t)); })};
  plot.panels = {upper, lower};
  return plot;
}

class PlotRendererTest : public testing::Test {
 protected:
  GlContext context_;
  PlotRenderer renderer_{context_};
};

TEST_F(PlotRendererTest, TwentyRepeatsAreTheSameToThePixel) {
  const Image first = renderer_.draw(over_time());
  for (int repeat = 1; repeat < 20; ++repeat) {
    const GlContext another;
    ASSERT_EQ(PlotRenderer(another).draw(over_time()), first) << "repeat " << repeat;
  }
}

TEST_F(PlotRendererTest, SamePlotGivesTheSamePixels) {
  const Image over = renderer_.draw(over_time());
  const Image path = renderer_.draw(tip_path());
  const Image energy = renderer_.draw(energies());
  keep("plot_over_time", over);
  keep("plot_tip_path", path);
  keep("plot_energies", energy);
  EXPECT_EQ(renderer_.draw(over_time()), over);
  EXPECT_EQ(renderer_.draw(tip_path()), path);
  EXPECT_EQ(PlotRenderer(context_).draw(energies()), energy);
}

// A 400 x 300 plot of one series, with given ranges, so that places in it are known.
Plot small(Series series) {
  Plot plot;
  plot.width = 400;
  plot.height = 300;
  plot.font_size = 12;
  Panel panel;
  panel.x.range = {0, 10};
  panel.y.range = {0, 1};
  panel.series = {std::move(series)};
  plot.panels.push_back(panel);
  return plot;
}

std::array<int, 3> at(const Image& image, const Point& place) {
  const auto i =
      static_cast<std::size_t>(3 * (static_cast<int>(place.y()) * image.width + static_cast<int>(place.x())));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

constexpr std::array every_marker = {Marker::circle,      Marker::square,        Marker::diamond,
                                     Marker::triangle_up, Marker::triangle_down, Marker::triangle_right,
                                     Marker::cross,       Marker::plus,          Marker::circled_cross};

constexpr std::array<int, 3> blue = {0x00, 0x72, 0xB2};

TEST_F(PlotRendererTest, LineRunsThroughThePixelsOfItsData) {
  Series line;
  line.x = {2, 8};
  line.y = {0.37, 0.37};
  line.line_width = 2;
  const Plot plot = small(line);
  const Image image = renderer_.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(at(image, {panel.x(3.3), panel.y(0.37)}), blue);
  EXPECT_NE(at(image, {panel.x(1.3), panel.y(0.37)}), blue) << "before the line";
  EXPECT_NE(at(image, {panel.x(3.3), panel.y(0.47)}), blue) << "above the line";
}

TEST_F(PlotRendererTest, NotANumberLeavesAGap) {
  Series line;
  line.x = {1, 3, 5, 7, 9};
  line.y = {0.37, 0.37, nan, 0.37, 0.37};
  line.line_width = 2;
  const Plot plot = small(line);
  const Image image = renderer_.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(at(image, {panel.x(2.2), panel.y(0.37)}), blue);
  EXPECT_NE(at(image, {panel.x(5.2), panel.y(0.37)}), blue);
  EXPECT_EQ(at(image, {panel.x(7.8), panel.y(0.37)}), blue);
}

TEST_F(PlotRendererTest, EachMarkerAddsItsOwnPixels) {
  for (const Marker marker : every_marker) {
    Series series;
    series.x = {2, 5, 8};
    series.y = {0.2, 0.5, 0.8};
    series.line_width = 0;
    series.marker = marker;
    const Image all = renderer_.draw(small(series));
    series.y[1] = nan;
    EXPECT_NE(renderer_.draw(small(series)), all) << "marker " << static_cast<int>(marker);
  }
}

TEST_F(PlotRendererTest, MarkersDifferInFormOpenAndFilled) {
  std::vector<Image> pictures;
  for (const Marker marker : every_marker)
    for (const bool open : {true, false}) {
      if (!open && (marker == Marker::cross || marker == Marker::plus || marker == Marker::circled_cross))
        continue;
      Series series;
      series.x.push_back(5);
      series.y.push_back(0.5);
      series.line_width = 0;
      series.marker = marker;
      series.marker_size = 3;
      series.open_marker = open;
      pictures.push_back(renderer_.draw(small(series)));
    }
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " and " << j;
}

TEST_F(PlotRendererTest, TrianglePointsUpwardsOrDownwards) {
  for (const bool up : {true, false}) {
    Series series;
    series.x.push_back(5);
    series.y.push_back(0.5);
    series.line_width = 0;
    series.marker = up ? Marker::triangle_up : Marker::triangle_down;
    series.marker_size = 4;
    series.open_marker = false;
    const Plot plot = small(series);
    const Image image = renderer_.draw(plot);
    const PanelLayout panel = plot_layout(plot, Font()).panels[0];
    const Point middle(panel.x(5), panel.y(0.5));
    const double radius = PlotSizes(plot.font_size).marker * 2;
    const double tip = up ? -1 : 1;
    EXPECT_EQ(at(image, middle), blue);
    EXPECT_EQ(at(image, middle + radius * Point(0, 1.15 * tip)), blue) << "near the tip, up: " << up;
    EXPECT_NE(at(image, middle - radius * Point(0, 1.15 * tip)), blue) << "beyond the base, up: " << up;
    EXPECT_EQ(at(image, middle + radius * Point(0.9, -0.6 * tip)), blue) << "near a base corner, up: " << up;
    EXPECT_NE(at(image, middle + radius * Point(0.9, 0.6 * tip)), blue) << "beside the tip, up: " << up;
  }
}

TEST_F(PlotRendererTest, ValueNotAboveZeroLeavesAGapOnALogarithmicAxis) {
  Series line;
  line.x = {1, 3, 5, 7, 9};
  line.y = {0.37, 0.37, 0, 0.37, 0.37};
  line.line_width = 2;
  Plot plot = small(line);
  plot.panels[0].y.range = {0.01, 1};
  plot.panels[0].y.scale = Scale::logarithmic;
  const Image image = renderer_.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(at(image, {panel.x(2.2), panel.y(0.37)}), blue);
  EXPECT_NE(at(image, {panel.x(4.2), panel.y(0.37)}), blue);
  EXPECT_NE(at(image, {panel.x(5.7), panel.y(0.37)}), blue);
  EXPECT_EQ(at(image, {panel.x(7.8), panel.y(0.37)}), blue);
}

TEST_F(PlotRendererTest, BandIsShadedBelowTheSeriesAndLineOfARuleIsDrawn) {
  Series line;
  line.x = {2, 8};
  line.y = {0.1, 0.1};
  line.line_width = 2;
  Plot plot = small(line);
  Rule band;
  band.to = 0.25;
  Rule upright;
  upright.upright = true;
  upright.from = upright.to = 6.03;
  upright.color = Color{};
  plot.panels[0].rules = {band, upright};
  const Image image = renderer_.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(at(image, {panel.x(3.3), panel.y(0.1)}), blue);
  const std::array<int, 3> shaded = at(image, {panel.x(3.3), panel.y(0.07)});
  EXPECT_LT(shaded[0], 250);
  EXPECT_GT(shaded[0], 200);
  EXPECT_EQ(at(image, {panel.x(3.3), panel.y(0.37)}), (std::array<int, 3>{255, 255, 255})) << "above it";
  EXPECT_LT(at(image, {panel.x(6.03), panel.y(0.77)})[0], 160) << "the upright line";
}

TEST_F(PlotRendererTest, ABarIsFilledBelowTheSeries) {
  Series line;
  line.x = {2, 8};
  line.y = {0.1, 0.1};
  line.line_width = 2;
  Plot plot = small(line);
  plot.panels[0].bars = {{{1, 5}, {0.05, 0.3}, Color::hex(0x009E73)}};
  const Image image = renderer_.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(at(image, {panel.x(3.3), panel.y(0.1)}), blue);
  EXPECT_EQ(at(image, {panel.x(3.3), panel.y(0.2)}), (std::array<int, 3>{0, 0x9E, 0x73}));
  EXPECT_NE(at(image, {panel.x(6.3), panel.y(0.2)}), (std::array<int, 3>{0, 0x9E, 0x73}));
  EXPECT_NE(at(image, {panel.x(3.3), panel.y(0.4)}), (std::array<int, 3>{0, 0x9E, 0x73}));
}

// Work against error for many methods, as a study has it.
Plot work_precision(int curves) {
  Plot plot;
  plot.title = "Error against work";
  plot.width = 2000;
  plot.height = 1700;
  Panel panel;
  panel.x.label = "time loop [s]";
  panel.y.label = "greatest tip error [m]";
  panel.x.scale = panel.y.scale = Scale::logarithmic;
  for (int k = 0; k < curves; ++k) {
    const int order = 1 + k % 6;
    Series s;
    s.label = "method-of-order-" + std::to_string(order) + ", variant " + std::to_string(k / 6);
    for (int i = 0; i < 9; ++i) {
      s.x.push_back(2e-4 * std::pow(2.0, i) * (1 + 0.35 * k));
      s.y.push_back(
          std::max(0.3 * std::pow(2.0, -order * i) * (1 + 0.1 * k), 3e-13 * (1 + 0.2 * (k + i) / 9)));
    }
    s.marker = every_marker[static_cast<std::size_t>(k) % 5];
    s.open_marker = k >= 6;
    s.dash = k < 6 ? Dash::solid : Dash::dashed;
    panel.series.push_back(s);
  }
  Series failed;
  failed.label = "failed";
  failed.x = {3e-4, 7e-4, 2e-3};
  failed.y = {0.8, 0.8, 0.8};
  failed.line_width = 0;
  failed.marker = Marker::cross;
  Series wrong = failed;
  wrong.label = "stable but wrong";
  wrong.x = {4e-4, 1e-3, 4e-3};
  wrong.y = {0.4, 0.2, 0.3};
  wrong.marker = Marker::circled_cross;
  panel.series.push_back(failed);
  panel.series.push_back(wrong);
  Rule floor;
  floor.to = 1e-12;
  floor.label = "below 10^{\u221212} m the reference is not certified";
  panel.rules.push_back(floor);
  Rule limit;
  limit.upright = true;
  limit.from = limit.to = 0.05;
  limit.label = "h_{max} = 1 ms";
  limit.dash = Dash::dashed;
  panel.rules.push_back(limit);
  panel.y.range = {1e-13, 1};
  plot.panels.push_back(panel);
  return plot;
}

TEST_F(PlotRendererTest, LogarithmicPlotsRepeatToThePixel) {
  const Image some = renderer_.draw(work_precision(5));
  const Image many = renderer_.draw(work_precision(12));
  keep("plot_work_precision", some);
  keep("plot_work_precision_many", many);
  EXPECT_EQ(renderer_.draw(work_precision(5)), some);
  EXPECT_EQ(renderer_.draw(work_precision(12)), many);
}

TEST_F(PlotRendererTest, NothingIsDrawnOutsideTheFrame) {
  Series line;
  line.x = {-100, 100};
  line.y = {-10, 11};
  line.line_width = 8;
  Series none;
  const Image with = renderer_.draw(small(line));
  const Image without = renderer_.draw(small(none));
  const Rect frame = plot_layout(small(line), Font()).panels[0].frame;
  int outside = 0;
  int inside = 0;
  for (int y = 0; y < with.height; ++y)
    for (int x = 0; x < with.width; ++x) {
      const Point place(x + 0.5, y + 0.5);
      if (at(with, place) != at(without, place)) (frame.contains(place) ? inside : outside) += 1;
    }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(inside, 1000);
}

TEST_F(PlotRendererTest, EmptyAndConstantDataHaveAxesThatCanBeRead) {
  Plot plot;
  plot.title = "Nothing, one point, always the same";
  Panel empty;
  empty.y.label = "nothing";
  Panel constant;
  constant.y.label = "constant";
  constant.series = {sampled("always 1e-7", 10, 2, [](double) { return 1e-7; })};
  Panel point;
  point.y.label = "one point";
  point.series.resize(1);
  point.series[0].x = {3};
  point.series[0].y = {-4};
  point.series[0].marker = Marker::circle;
  Panel hole;
  hole.series = {sampled("", 10, 2, [](double) { return nan; })};
  plot.panels = {empty, constant, point, hole};
  for (const PanelLayout& panel : plot_layout(plot, Font()).panels) {
    EXPECT_GE(panel.x_ticks.major.size(), 2U);
    EXPECT_GE(panel.y_ticks.major.size(), 2U);
  }
  keep("plot_degenerate", renderer_.draw(plot));
}

}  // namespace plot_renderer_test
}  // namespace plumb
