#include "render/plot/plot_layout.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>

#include "engine/base/errors.h"

namespace plumb {
namespace plot_layout_test {

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

// A dozen and more straight lines on logarithmic axes.
Plot many_curves(int curves) {
  Plot plot;
  plot.panels.resize(1);
  Panel& panel = plot.panels[0];
  panel.x.scale = panel.y.scale = Scale::logarithmic;
  for (int k = 0; k < curves; ++k) {
    Series series;
    series.label = "a method of some name, variant " + std::to_string(k);
    series.marker = Marker::circle;
    for (int i = 0; i < 8; ++i) {
      series.x.push_back(1e-4 * std::pow(2.0, i) * (1 + 0.2 * k));
      series.y.push_back(0.1 * std::pow(2.0, -(1 + k % 5) * i));
    }
    panel.series.push_back(series);
  }
  return plot;
}

TEST(PlotLayout, LogarithmicAxesGiveEveryDecadeTheSameLength) {
  Plot plot;
  plot.panels.resize(1);
  Panel& panel = plot.panels[0];
  panel.x.scale = panel.y.scale = Scale::logarithmic;
  panel.series.resize(1);
  panel.series[0].x = {1e-4, 1e-3, 1e-2, 1e2};
  panel.series[0].y = {1, 1e-5, 1e-9, 1e-10};
  const PanelLayout layout = plot_layout(plot, Font()).panels[0];
  EXPECT_NEAR(layout.x(1e-3) - layout.x(1e-4), layout.x(1e2) - layout.x(1e1), 1e-9);
  EXPECT_NEAR(layout.y(1e-3) - layout.y(1e-2), layout.y(1e-9) - layout.y(1e-8), 1e-9);
  for (const Point& point : pixels(panel.series[0], layout))
    EXPECT_TRUE(layout.frame.contains(point)) << point.transpose();
}

TEST(PlotLayout, WhatIsNotAboveZeroHasNoPartInALogarithmicAxis) {
  Plot plot;
  plot.panels.resize(1);
  Panel& panel = plot.panels[0];
  panel.y.scale = Scale::logarithmic;
  panel.series.resize(1);
  panel.series[0].x = {-50, 1, 2, 3, 70};
  panel.series[0].y = {0, 1e-3, -1, 1e-1, -1e-9};
  const PanelLayout layout = plot_layout(plot, Font()).panels[0];
  EXPECT_GT(layout.x.range.lo, 0.9) << "the x of a point that is not drawn";
  EXPECT_LT(layout.x.range.hi, 3.1);
  EXPECT_GT(layout.y.range.lo, 1e-4);
  const std::vector<Point> points = pixels(panel.series[0], layout);
  for (const std::size_t i : {0U, 2U, 4U}) EXPECT_FALSE(points[i].allFinite()) << i;
  for (const std::size_t i : {1U, 3U}) EXPECT_TRUE(points[i].allFinite()) << i;
}

TEST(PlotLayout, PanelsThatShareAnAxisShareItsScale) {
  Plot plot = two_panels(1, 1);
  plot.panels[1].x.scale = Scale::logarithmic;
  for (const PanelLayout& panel : plot_layout(plot, Font()).panels) {
    EXPECT_EQ(panel.x.scale, Scale::logarithmic);
    EXPECT_GT(panel.x.range.lo, 0);
  }
}

TEST(PlotLayout, LegendOfManyEntriesStandsInAlignedColumnsWithoutOverlap) {
  const Font font;
  for (const int curves : {7, 14, 24}) {
    const Plot plot = many_curves(curves);
    const PlotSizes sizes(plot.font_size);
    const PanelLayout panel = plot_layout(plot, font).panels[0];
    ASSERT_TRUE(panel.legend.has_value());
    const LegendLayout& legend = *panel.legend;
    ASSERT_EQ(legend.series.size(), static_cast<std::size_t>(curves));
    std::set<double> lefts;
    for (std::size_t i = 0; i < legend.at.size(); ++i) {
      lefts.insert(legend.at[i].x());
      const double wide = legend_sample(plot.panels[0], sizes) + sizes.gap +
                          font.measure(plot.panels[0].series[legend.series[i]].label, sizes.legend).width;
      EXPECT_LE(legend.at[i].x() + wide, plot.width) << curves << " curves, entry " << i;
      EXPECT_LE(legend.at[i].y(), legend.box.bottom);
      for (std::size_t j = 0; j < i; ++j) {
        const bool other_row = std::abs(legend.at[j].y() - legend.at[i].y()) >= sizes.legend.size;
        EXPECT_TRUE(other_row || std::abs(legend.at[j].x() - legend.at[i].x()) >= wide)
            << curves << " curves, entries " << i << " and " << j;
      }
    }
    EXPECT_LE(lefts.size(), 4U) << "columns";
    EXPECT_GE(lefts.size(), curves > 7 ? 2U : 1U) << "columns";
    if (legend.outside) {
      EXPECT_LE(legend.box.bottom, panel.frame.top);
    }
  }
}

Rule floor_at(double value) {
  Rule rule;
  rule.to = value;
  rule.label = "below: not certified";
  return rule;
}

TEST(PlotLayout, RuleFillsItsBandAndItsLabelIsInsideThePanel) {
  Plot plot = many_curves(5);
  plot.panels[0].y.range = {1e-12, 1};
  plot.panels[0].rules = {floor_at(1e-9)};
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  ASSERT_EQ(panel.rules.size(), 1U);
  const RuleLayout& rule = panel.rules[0];
  EXPECT_NEAR(rule.area.top, panel.y(1e-9), 1e-9);
  EXPECT_EQ(rule.area.bottom, panel.frame.bottom) << "0 has no place, so the band goes to the end";
  EXPECT_GT(rule.label.width(), 0);
  EXPECT_GE(rule.label.left, panel.frame.left);
  EXPECT_LE(rule.label.right, panel.frame.right);
  EXPECT_LE(rule.label.bottom, panel.frame.bottom);
  EXPECT_GE(rule.label.top, panel.frame.top);
  for (const Series& series : plot.panels[0].series)
    for (const Point& point : pixels(series, panel))
      EXPECT_FALSE(rule.label.contains(point)) << point.transpose();
}

TEST(PlotLayout, RulesNeitherWidenAnAxisNorShowWhereTheyAreOutsideIt) {
  Plot plot = many_curves(5);
  const PanelLayout without = plot_layout(plot, Font()).panels[0];
  plot.panels[0].rules = {floor_at(1e-30)};
  Rule upright;
  upright.upright = true;
  upright.from = upright.to = 1e9;
  plot.panels[0].rules.push_back(upright);
  const PanelLayout with = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(with.y.range.lo, without.y.range.lo);
  EXPECT_EQ(with.x.range.hi, without.x.range.hi);
  EXPECT_TRUE(with.rules.empty());
}

TEST(PlotLayout, GivenTicksReplaceTheRoundOnesWhereTheyAreInside) {
  Plot plot;
  plot.panels.resize(1);
  plot.panels[0].x.scale = Scale::logarithmic;
  plot.panels[0].x.range = {3, 70};
  plot.panels[0].x.ticks = {2, 4, 4.01, 8, 16, 64, 128};
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(panel.x_ticks.major, (std::vector<double>{4, 4.01, 8, 16, 64}));
  EXPECT_EQ(panel.x_ticks.labels, (std::vector<std::string>{"4", "", "8", "16", "64"}));
}

TEST(PlotLayout, TicksMayHaveNamesForWhichRoomIsMade) {
  Plot plot;
  plot.panels.resize(1);
  plot.panels[0].y.range = {-1, 3};
  plot.panels[0].y.ticks = {0, 1, 5};
  const double narrow = plot_layout(plot, Font()).panels[0].frame.left;
  plot.panels[0].y.tick_labels = {"a name of some length", "b", "outside"};
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(panel.y_ticks.labels, (std::vector<std::string>{"a name of some length", "b"}));
  EXPECT_GT(panel.frame.left, narrow + 200);
}

Plot bars() {
  Plot plot;
  plot.panels.resize(1);
  Panel& panel = plot.panels[0];
  panel.x.range = {0, 10};
  panel.y.range = {0, 2};
  panel.bars = {{{0, 8}, {0.5, 1.5}, palette[0]}, {{8, 12}, {0.5, 1.5}, palette[1]}};
  return plot;
}

TEST(PlotLayout, ABarEndsAtItsValuesOrAtThePanel) {
  const Plot plot = bars();
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  const Rect inner = bar_area(plot.panels[0].bars[0], panel);
  EXPECT_DOUBLE_EQ(inner.left, panel.frame.left);
  EXPECT_DOUBLE_EQ(inner.right, panel.x(8));
  EXPECT_DOUBLE_EQ(inner.top, panel.y(1.5));
  EXPECT_DOUBLE_EQ(inner.bottom, panel.y(0.5));
  EXPECT_DOUBLE_EQ(bar_area(plot.panels[0].bars[1], panel).right, panel.frame.right);
  EXPECT_EQ(bar_area({{11, 12}, {0, 1}, {}}, panel).width(), 0) << "outside";
}

TEST(PlotLayout, LegendCoversNoBar) {
  Plot plot = bars();
  plot.panels[0].series.resize(1);
  plot.panels[0].series[0].label = "accurate";
  plot.panels[0].series[0].line_width = 0;
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  ASSERT_TRUE(panel.legend.has_value());
  const Rect bar = bar_area(plot.panels[0].bars[0], panel);
  EXPECT_TRUE(panel.legend->box.bottom <= bar.top || panel.legend->box.top >= bar.bottom);
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
  plot.panels[0].y.scale = Scale::logarithmic;
  plot.panels[0].y.range = {0, 1};
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "0 on a logarithmic axis";
  plot = two_panels(1, 1);
  plot.panels[0].y.scale = Scale::logarithmic;
  plot.panels[0].equal_axes = true;
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "equal axes that are not linear";
  plot = two_panels(1, 1);
  plot.panels[0].rules = {floor_at(std::nan(""))};
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "rule at no number";
  plot = two_panels(1, 1);
  plot.panels[0].bars = {{{0, std::nan("")}, {0, 1}, {}}};
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "bar that ends at no number";
  plot = two_panels(1, 1);
  plot.panels[0].y.ticks = {0, 1};
  plot.panels[0].y.tick_labels = {"one"};
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "a name for one of two ticks";
  plot = two_panels(1, 1);
  plot.width = 100;
  plot.height = 80;
  EXPECT_THROW(plot_layout(plot, font), OutputError) << "too small";
}

}  // namespace plot_layout_test
}  // namespace plumb
