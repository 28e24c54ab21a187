#include "render/plot_layout.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "engine/errors.h"

namespace plumb {
namespace {

Series wave(const std::string& label, double amplitude, double phase) {
  Series series;
  series.label = label;
  for (int i = 0; i <= 400; ++i) {
    series.x.push_back(0.005 * i);
    series.y.push_back(amplitude * std::sin(4 * series.x.back() + phase));
  }
  return series;
}

Plot two_panels(double upper, double lower) {
  Plot plot;
  plot.title = "Two panels";
  plot.panels.resize(2);
  plot.panels[0].series = {wave("a", upper, 0), wave("b", upper, 1)};
  plot.panels[0].y.label = "y [m]";
  plot.panels[0].height_share = 2;
  plot.panels[0].shares_x_below = true;
  plot.panels[1].series = {wave("", lower, 0)};
  plot.panels[1].x.label = "time [s]";
  plot.panels[1].y.label = "difference [m]";
  return plot;
}

TEST(PlotLayout, FramesAreAlignedAndApartAndInsideThePicture) {
  const Font font;
  EXPECT_TRUE(rc::check([&] {
    Plot plot =
        two_panels(std::pow(10.0, *rc::gen::inRange(-9, 9)), std::pow(10.0, *rc::gen::inRange(-9, 9)));
    plot.width = *rc::gen::inRange(900, 2400);
    plot.height = *rc::gen::inRange(900, 2400);
    const PlotLayout layout = plot_layout(plot, font);
    const Rect& upper = layout.panels[0].frame;
    const Rect& lower = layout.panels[1].frame;
    RC_ASSERT(upper.left == lower.left && upper.right == lower.right);
    RC_ASSERT(layout.title_base < upper.top && upper.bottom < lower.top);
    RC_ASSERT(std::abs(upper.height() - 2 * lower.height()) <= 3);
    RC_ASSERT(layout.panels[1].x_label_base < plot.height);
    RC_ASSERT(upper.right < plot.width);
    const PlotSizes sizes(plot.font_size);
    for (const PanelLayout& panel : layout.panels)
      for (const std::string& label : panel.y_ticks.labels)
        RC_ASSERT(panel.frame.left - sizes.tick_length - font.measure(label, sizes.tick).width >
                  panel.y_label_base);
  }));
}

TEST(PlotLayout, SharedAxisHasTheRangeOfBothPanelsAndOnlyTheLowestShowsIt) {
  Plot plot = two_panels(1, 1);
  for (double& x : plot.panels[1].series[0].x) x += 3;
  const PlotLayout layout = plot_layout(plot, Font());
  EXPECT_EQ(layout.panels[0].x.range.lo, layout.panels[1].x.range.lo);
  EXPECT_EQ(layout.panels[0].x.range.hi, layout.panels[1].x.range.hi);
  EXPECT_LT(layout.panels[0].x.range.lo, 0);
  EXPECT_GT(layout.panels[0].x.range.hi, 5);
  EXPECT_FALSE(layout.panels[0].x_labels);
  EXPECT_TRUE(layout.panels[1].x_labels);
}

TEST(PlotLayout, EqualAxesHaveOneScaleAndHoldTheData) {
  Plot plot;
  plot.panels.resize(1);
  plot.panels[0].equal_axes = true;
  plot.panels[0].series = {wave("", 3, 0)};
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_NEAR(panel.x(1) - panel.x(0), panel.y(0) - panel.y(1), 1e-9);
  for (const Point& point : pixels(plot.panels[0].series[0], panel))
    EXPECT_TRUE(panel.frame.contains(point)) << point.transpose();
}

TEST(PlotLayout, LegendInsideCoversNoData) {
  const Plot plot = two_panels(1, 1);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  ASSERT_TRUE(panel.legend.has_value());
  if (panel.legend->outside) return;
  for (const Series& series : plot.panels[0].series)
    for (const Point& point : pixels(series, panel))
      EXPECT_FALSE(panel.legend->box.contains(point)) << point.transpose();
}

TEST(PlotLayout, LegendGoesAboveThePanelWhenTheDataFillIt) {
  Plot plot;
  plot.panels.resize(1);
  Series series;
  series.label = "everywhere";
  for (int i = 0; i < 4000; ++i) {
    series.x.push_back(i % 63);
    series.y.push_back(i / 63);
  }
  series.line_width = 0;
  series.marker = Marker::circle;
  plot.panels[0].series = {series};
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  ASSERT_TRUE(panel.legend.has_value());
  EXPECT_TRUE(panel.legend->outside);
  EXPECT_LE(panel.legend->box.bottom, panel.frame.top);
  EXPECT_GE(panel.legend->box.top, 0);
}

TEST(PlotLayout, PowersOfTenAreWrittenAsSuperscripts) {
  EXPECT_EQ(exponent_label(-5), "\u00d710^{\u22125}");
  EXPECT_EQ(exponent_label(7), "\u00d710^{7}");
  EXPECT_EQ(exponent_label(0), "");
}

TEST(PlotLayout, WhatCannotBeDrawnIsRefused) {
  const Font font;
  Plot plot = two_panels(1, 1);
  plot.panels[0].series[0].y.pop_back();
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "x and y differ in number";
  plot = two_panels(1, 1);
  plot.panels[0].y.range = {1, 1};
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "empty range";
  plot = two_panels(1, 1);
  plot.panels[0].y.range = {1, 1 + 1e-15};
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "range of some units in the last place";
  plot = two_panels(1, 1);
  plot.panels[1].x.range = {0, std::nan("")};
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "range without an end";
  plot = two_panels(1, 1);
  plot.panels[1].height_share = 0;
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "no height";
  plot = two_panels(1, 1);
  plot.font_size = 0;
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "no font size";
  plot = two_panels(1, 1);
  plot.width = 100;
  plot.height = 80;
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "too small";
}

}  // namespace
}  // namespace plumb
