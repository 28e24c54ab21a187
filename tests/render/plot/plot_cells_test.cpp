#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/base/errors.h"
#include "render/plot/cell_grid.h"
#include "render/plot/plot_layout.h"
#include "render/plot/plot_renderer.h"
#include "tests/render/image/pictures.h"

namespace plumb {
namespace plot_cells_test {

Panel grid_panel(int columns, int rows) {
  Panel panel;
  panel.title = "method";
  CellGrid cells;
  for (int k = 0; k <= columns; ++k) cells.x_edges.push_back(std::pow(10.0, k));
  for (int k = 0; k <= rows; ++k) cells.y_edges.push_back(k);
  for (int k = 0; k < rows * columns; ++k) cells.categories.push_back(k % 3);
  panel.x.scale = Scale::logarithmic;
  panel.x.label = "step [s]";
  panel.x.range = {cells.x_edges.front(), cells.x_edges.back()};
  panel.y.range = {cells.y_edges.front(), cells.y_edges.back()};
  panel.cells = cells;
  return panel;
}

Plot grid_plot(int panels, int columns) {
  Plot plot;
  plot.title = "Outcomes";
  plot.width = 800;
  plot.height = 700;
  plot.font_size = 16;
  plot.columns = columns;
  plot.key.categories = {{"good", "", Color::hex(0x009E73)},
                         {"bad", "B", Color::hex(0xD55E00)},
                         {"", "W", Color::hex(0x3A3A3A)}};
  plot.key.lines.resize(1);
  plot.key.lines[0].label = "limit";
  for (int p = 0; p < panels; ++p) plot.panels.push_back(grid_panel(4, 3));
  return plot;
}

std::array<int, 3> at(const Image& image, const Point& place) {
  const auto i =
      static_cast<std::size_t>(3 * (static_cast<int>(place.y()) * image.width + static_cast<int>(place.x())));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

constexpr std::array<int, 3> green{0x00, 0x9E, 0x73}, orange{0xD5, 0x5E, 0x00}, dark{0x3A, 0x3A, 0x3A};

TEST(PlotCells, EachHasTheColourOfItsCategory) {
  const GlContext context;
  PlotRenderer renderer(context);
  const Plot plot = grid_plot(1, 1);
  const Image image = renderer.draw(plot);
  keep("plot_cells", image);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      // Near a corner, where no letter is.
      const Point place(panel.x(std::pow(10.0, column + 0.1)), panel.y(row + 0.1));
      const std::array expected{green, orange, dark};
      EXPECT_EQ(at(image, place), expected[static_cast<std::size_t>((row * 4 + column) % 3)])
          << row << ", " << column;
    }
  EXPECT_EQ(renderer.draw(plot), image) << "the same pixels again";
}

TEST(PlotCells, LetterStandsInItsCellUnlessThatIsTooSmall) {
  const GlContext context;
  PlotRenderer renderer(context);
  const auto letters_matter = [&](Plot plot) {
    const Image with = renderer.draw(plot);
    for (CellCategory& category : plot.key.categories) category.label.clear();
    const Image without_labels = renderer.draw(plot);
    for (CellCategory& category : plot.key.categories) category.letter.clear();
    return renderer.draw(plot) != without_labels;
  };
  EXPECT_TRUE(letters_matter(grid_plot(1, 1)));
  Plot fine = grid_plot(1, 1);
  fine.panels[0] = grid_panel(200, 100);
  EXPECT_FALSE(letters_matter(fine));
}

TEST(PlotCells, AnEmptyCellIsLeftOutAndASeriesLiesOverTheCells) {
  const GlContext context;
  PlotRenderer renderer(context);
  Plot plot = grid_plot(1, 1);
  plot.panels[0].cells->categories[0] = -1;
  Series line;
  line.x = {3e3, 3e3};
  line.y = {0, 3};
  line.color = Color::hex(0x0000FF);
  line.line_width = 2;
  plot.panels[0].series = {line};
  const Image image = renderer.draw(plot);
  const PanelLayout panel = plot_layout(plot, Font()).panels[0];
  EXPECT_EQ(at(image, {panel.x(3), panel.y(0.5)}), (std::array<int, 3>{255, 255, 255}));
  EXPECT_EQ(at(image, {panel.x(3e3), panel.y(1.25)}), (std::array<int, 3>{0, 0, 255}));
}

TEST(PlotColumns, PanelsRunAlongLevelRowsWithinTheirColumns) {
  const Plot plot = grid_plot(5, 3);
  const PlotLayout layout = plot_layout(plot, Font());
  ASSERT_EQ(layout.panels.size(), 5U);
  for (std::size_t p = 0; p < 5; ++p) {
    const Rect& frame = layout.panels[p].frame;
    const double left = 800 / 3 * static_cast<double>(p % 3);
    EXPECT_GT(frame.left, left) << p;
    EXPECT_LT(frame.right, left + 800.0 / 3) << p;
    EXPECT_EQ(frame.top, layout.panels[p / 3 * 3].frame.top) << "row of panel " << p;
    EXPECT_EQ(layout.panels[p].x.start, frame.left);
  }
  EXPECT_GT(layout.panels[3].frame.top, layout.panels[0].frame.bottom);
}

TEST(PlotKey, ExplainsCategoriesWithALabelAndLinesBetweenTitleAndPanels) {
  const Font font;
  Plot plot = grid_plot(2, 2);
  const PlotLayout layout = plot_layout(plot, font);
  ASSERT_EQ(layout.key.size(), 3U) << "two categories and a line: one category has no label";
  for (const KeyEntry& entry : layout.key) {
    EXPECT_GT(entry.sample.top, layout.title_base);
    EXPECT_LT(entry.sample.bottom, layout.panels[0].frame.top);
    EXPECT_GT(entry.sample.left, 0);
  }
  plot.key.categories[0].label = std::string(40, 'w');
  plot.key.categories[1].label = std::string(40, 'w');
  const PlotLayout wrapped = plot_layout(plot, font);
  EXPECT_GT(wrapped.key[1].sample.top, wrapped.key[0].sample.bottom - 1) << "a row of its own";
  EXPECT_GT(wrapped.panels[0].frame.top, layout.panels[0].frame.top);
}

TEST(PlotCells, WhatDoesNotFitIsRefused) {
  const Font font;
  const auto refused = [&](auto change, int columns = 1) {
    Plot plot = grid_plot(1, columns);
    change(plot.panels[0].cells.value());
    EXPECT_THROW(plot_layout(plot, font), OutputError);
  };
  refused([](CellGrid& cells) { cells.categories.pop_back(); });
  refused([](CellGrid& cells) { cells.categories[2] = 3; });
  refused([](CellGrid& cells) { cells.categories[2] = -2; });
  refused([](CellGrid& cells) { cells.x_edges[1] = cells.x_edges[0]; });
  refused([](CellGrid& cells) { cells.y_edges[1] = std::nan(""); });
  refused([](CellGrid& cells) { cells.x_edges.clear(); });
  refused([](CellGrid&) {}, 0);
}

TEST(InkOn, IsBlackOnLightAndWhiteOnDark) {
  EXPECT_GT(ink_on(Color::hex(0x3A3A3A)).r, 0.9F);
  EXPECT_LT(ink_on(Color::hex(0x9AD0F0)).r, 0.1F);
  EXPECT_LT(ink_on(Color::hex(0xFFFFFF)).r, 0.1F);
  EXPECT_GT(ink_on(Color::hex(0x000000)).r, 0.9F);
}

}  // namespace plot_cells_test
}  // namespace plumb
