#include "report/figure/figure_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "render/gl/gl_context.h"
#include "render/gl/markup.h"
#include "render/image/png.h"
#include "render/plot/plot_renderer.h"
#include "report/diff/number_difference.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace figure_csv_test {

/// A plot with one of everything that numbers go into.
Plot one_of_each() {
  Plot plot;
  plot.width = 700;
  plot.height = 1100;
  plot.font_size = 16;
  plot.key.categories = {{"good", "", Color::hex(0x009E73)}, {"", "B", Color::hex(0xD55E00)}};
  plot.panels.resize(3);
  Series line;
  line.label = literal("tip_{x}");
  line.x = {0, 1, 2};
  line.y = {0.5, 0.75, 0.25};
  line.band = {{0.4, 0.6, 0.1}, {0.6, 0.9, 0.4}};
  Series points = line;
  points.label.clear();
  points.band = {};
  points.line_width = 0;
  points.marker = Marker::circle;
  points.x_error = {{-0.1, 0.8, 1.9}, {0.1, 1.2, 2.1}};
  points.y_error = {{0.3, 0.5, 0.125}, {0.7, 1, 0.375}};
  Rule rule;
  rule.from = -1;
  rule.to = 0.125;
  rule.label = "floor: 10^{-3}";
  Panel& lines = plot.panels[0];
  lines.series = {line, points};
  lines.rules = {rule};
  lines.bars = {{{0, 1}, {0, 0.5}, Color::hex(0x336699)}};
  lines.x.ticks = {0, 2};
  lines.x.tick_labels = {"first", "last"};
  Panel& cells = plot.panels[1];
  cells.cells = CellGrid{{1, 100, 10000}, {0, 2}, {0, 1}};
  cells.x.scale = Scale::logarithmic;
  cells.x.range = {1, 10000};
  cells.y.range = {0, 2};
  HeatMap map;
  map.x_edges = {0, 1, 2};
  map.y_edges = {0, 1, 2};
  map.values = {0.1, 0.2, 0.3, 0.4};
  plot.panels[2].heat_map = map;
  return plot;
}

bool has_row(const std::string& csv, const std::string& row) {
  return csv.find("\n" + row + "\n") != std::string::npos;
}

TEST(FigureCsv, HoldsEverythingThatWasDrawnFromNumbers) {
  const std::string csv = to_csv(one_of_each());
  EXPECT_TRUE(csv.starts_with("panel,kind,series,x,y,x_to,y_to,value\n"));
  for (const char* row : {"1,point,tip_{x},1,0.75,,,", "1,band,tip_{x},1,0.6,1,0.9,", "1,point,#2,2,0.25,,,",
                          "1,x_error,#2,0.8,0.75,1.2,0.75,", "1,y_error,#2,2,0.125,2,0.375,",
                          "1,rule,floor: 10−3,,-1,,0.125,", "1,bar,,0,0,1,0.5,#336699", "1,tick,,2,,,,last",
                          "2,cell,,10,1,,,good", "2,cell,,1000,1,,,B", "3,cell,,0.5,1.5,,,0.3"})
    EXPECT_TRUE(has_row(csv, row)) << row << "\nnot in\n" << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 + 3 + 3 + 3 + 3 + 1 + 1 + 2 + 2 + 4);
}

// What stands in a plot's files after a change, beside what stood there before.
class ChangedFigure : public testing::Test {
 protected:
  void write(const std::string& where, const Plot& plot) {
    const Image image = PlotRenderer(context_).draw(plot);
    write_text(folder_ / (where + "/figures/a.png"), encode_png(image, {{renderer_keyword, "one"}}));
    write_text(folder_ / (where + "/figures/a.csv"), to_csv(plot));
  }
  /// Result by file, as the program says it.
  std::map<std::string, std::string> diff(const Plot& changed, int status) {
    write("a", one_of_each());
    write("b", changed);
    const Ended ended = plumb_in(folder_.path(), {"diff", "a", "b", "--json"});
    EXPECT_EQ(ended.status, status) << ended.err;
    std::map<std::string, std::string> results;
    const nlohmann::json json = nlohmann::json::parse(ended.out);
    for (const auto& file : json["files"]) results[file["name"]] = file["result"];
    return results;
  }
  GlContext context_;
  TemporaryFolder folder_;
};

TEST_F(ChangedFigure, ACellOfAHeatMapIsCaughtThoughNoPixelShowsIt) {
  Plot plot = one_of_each();
  plot.panels[2].heat_map->values[1] += 1e-7;
  const auto results = diff(plot, 1);
  EXPECT_EQ(results.at("figures/a.png"), "identical");
  EXPECT_EQ(results.at("figures/a.csv"), "different");
}

TEST_F(ChangedFigure, ACategoryOfACellIsCaught) {
  Plot plot = one_of_each();
  plot.panels[1].cells->categories[1] = 0;
  const auto results = diff(plot, 1);
  EXPECT_EQ(results.at("figures/a.png"), "different");
  EXPECT_EQ(results.at("figures/a.csv"), "different");
}

TEST_F(ChangedFigure, ACurveThatMovedByLessThanAPixelIsCaught) {
  Plot plot = one_of_each();
  plot.panels[0].series[0].y[1] += 1e-8;
  const auto results = diff(plot, 1);
  EXPECT_EQ(results.at("figures/a.png"), "identical");
  EXPECT_EQ(results.at("figures/a.csv"), "different");
}

TEST_F(ChangedFigure, ThatDidNotChangeIsTheSame) {
  const auto results = diff(one_of_each(), 0);
  EXPECT_EQ(results.at("figures/a.png"), "identical");
  EXPECT_EQ(results.at("figures/a.csv"), "identical");
}

TEST_F(ChangedFigure, BandsErrorBarsBarsAndRulesAreCaught) {
  const std::string before = to_csv(one_of_each());
  const auto found = [&](auto change) {
    Plot plot = one_of_each();
    change(plot.panels[0]);
    const NumberDifference difference = number_difference(before, "a", to_csv(plot), "b");
    return difference.unlike.empty() ? difference.greatest : 1;
  };
  EXPECT_EQ(found([](Panel&) {}), 0);
  EXPECT_GT(found([](Panel& panel) { panel.series[0].band.lower[2] += 1e-6; }), 1e-7);
  EXPECT_GT(found([](Panel& panel) { panel.series[1].x_error.upper[0] += 1e-6; }), 1e-7);
  EXPECT_GT(found([](Panel& panel) { panel.series[1].y_error.lower[0] += 1e-6; }), 1e-7);
  EXPECT_GT(found([](Panel& panel) { panel.bars[0].y[1] += 1e-6; }), 1e-7);
  EXPECT_GT(found([](Panel& panel) { panel.bars[0].color.r = 0; }), 1e-7);
  EXPECT_GT(found([](Panel& panel) { panel.rules[0].to += 1e-6; }), 1e-7);
  EXPECT_GT(found([](Panel& panel) { panel.x.tick_labels[1] = "end"; }), 1e-7);
}

}  // namespace figure_csv_test
}  // namespace plumb
