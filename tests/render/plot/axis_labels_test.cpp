#include "render/plot/axis_labels.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "render/gl/dash.h"
#include "render/plot/key_layout.h"

namespace plumb {
namespace axis_labels_test {

Series slope(double from, double to, Dash dash = Dash::solid) {
  Series series;
  series.label = "a line";
  series.x = {from, to};
  series.y = {from, to};
  series.dash = dash;
  return series;
}

Panel labelled_panel() {
  Panel panel;
  panel.title = "A title";
  panel.x.label = "distance along the cable from its first end, as drawn [m]";
  panel.y.label = "drift of the total energy / kinetic energy at the start [1]";
  return panel;
}

bool meet(const Rect& a, const Rect& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

std::string shown(const PlacedText& text, const Font& font) {
  const Rect box = text.box(font);
  return "'" + text.text + "' " + std::to_string(box.left) + ".." + std::to_string(box.right) + ", " +
         std::to_string(box.top) + ".." + std::to_string(box.bottom);
}

TEST(AxisLabels, AreInThePictureAndNoneRunsIntoAnother) {
  const Font font;
  EXPECT_TRUE(rc::check([&] {
    const auto magnitude = [] { return std::pow(10.0, *rc::gen::inRange(-18, 12)); };
    Plot plot;
    plot.title = "A title of the whole that is rather long for so small a picture as this one is";
    plot.width = *rc::gen::inRange(900, 2400);
    plot.height = *rc::gen::inRange(1000, 2400);
    for (int p = *rc::gen::inRange(1, 4); p > 0; --p) {
      Panel panel = labelled_panel();
      const double size = magnitude();
      panel.series = {slope(*rc::gen::inRange(-9, 9) * size, *rc::gen::inRange(10, 20) * size)};
      panel.height_share = *rc::gen::inRange(4, 11) / 10.0;
      plot.panels.push_back(panel);
    }
    for (Panel& panel : plot.panels) panel.shares_x_below = *rc::gen::arbitrary<bool>();
    const PlotLayout layout = plot_layout(plot, font);
    const PlotSizes sizes(plot.font_size);
    std::vector<PlacedText> texts{plot_title(plot, layout, sizes, font)};
    for (std::size_t p = 0; p < plot.panels.size(); ++p)
      for (const PlacedText& text : axis_labels(plot.panels[p], layout.panels[p], sizes, font))
        texts.push_back(text);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const Rect box = texts[i].box(font);
      if (box.left < 0 || box.top < 0 || box.right > plot.width || box.bottom > plot.height)
        RC_FAIL("outside: " + shown(texts[i], font));
      for (std::size_t j = 0; j < i; ++j)
        if (meet(box, texts[j].box(font))) RC_FAIL(shown(texts[i], font) + " meets " + shown(texts[j], font));
    }
  }));
}

TEST(LegendSample, ShowsTheDashesOfItsLineHoweverWideThatIs) {
  const PlotSizes sizes(36);
  for (const double line_width : {0.5, 1.0, 2.0, 4.0})
    for (const Dash dash : {Dash::dashed, Dash::dotted}) {
      Panel panel;
      panel.series = {slope(0, 1, dash)};
      panel.series[0].line_width = line_width;
      const double width = line_width * sizes.line, length = legend_sample(panel, sizes);
      const auto drawn =
          dash_segments(std::vector<Point>{{width / 2, 0}, {length - width / 2, 0}}, dash, width);
      const auto [on, off] = dash_pattern(dash, width);
      std::size_t whole = 0;
      for (const auto& [a, b] : drawn) whole += std::abs((b - a).norm() - on) < 1e-9 * width ? 1 : 0;
      EXPECT_GE(whole, dash == Dash::dashed ? 2U : 4U) << "of a line of width " << line_width;
      ASSERT_GE(drawn.size(), 2U);
      EXPECT_NEAR((drawn[1].first - drawn[0].second).norm(), off, 1e-9 * width);

      PlotKey key;
      key.lines = panel.series;
      const KeyLayout placed = key_layout(key, 0, 1600, sizes, Font());
      ASSERT_EQ(placed.entries.size(), 1U);
      EXPECT_GE(placed.entries[0].sample.width(), length - 1e-9);
    }
}

TEST(LegendSample, OfASolidLineIsNoLongerThanOthers) {
  Panel panel;
  const PlotSizes sizes(36);
  panel.series = {slope(0, 1)};
  const double solid = legend_sample(panel, sizes);
  panel.series[0].line_width = 4;
  EXPECT_EQ(legend_sample(panel, sizes), solid);
  EXPECT_EQ(dash_pattern(Dash::solid, 3)[1], 0);
}

}  // namespace axis_labels_test
}  // namespace plumb
