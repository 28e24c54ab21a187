#include "render/plot/cell_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/errors.h"

namespace plumb {

void check_edges(const std::vector<double>& edges) {
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (!std::isfinite(edges[k]) || (k > 0 && !(edges[k] > edges[k - 1])))
      throw OutputError(fmt::format("plot: edge {} of the cells, {}: must be finite and rise", k, edges[k]));
}

Color ink_on(Color color) {
  const double luminance =
      0.2126 * std::pow(color.r, 2.2) + 0.7152 * std::pow(color.g, 2.2) + 0.0722 * std::pow(color.b, 2.2);
  // Equal contrast to either by the ratio of the W3C.
  constexpr double even = 0.18;
  return luminance > even ? Color::hex(0x111111) : Color::hex(0xFFFFFF);
}

void check_cells(const CellGrid& cells, std::size_t categories) {
  check_edges(cells.x_edges);
  check_edges(cells.y_edges);
  const std::size_t columns = std::max<std::size_t>(1, cells.x_edges.size()) - 1;
  const std::size_t rows = std::max<std::size_t>(1, cells.y_edges.size()) - 1;
  if (cells.categories.size() != rows * columns)
    throw OutputError(
        fmt::format("plot: {} cells for {} rows of {}", cells.categories.size(), rows, columns));
  for (const int category : cells.categories)
    if (category < -1 || category >= static_cast<int>(categories))
      throw OutputError(fmt::format("plot: a cell of category {}: there are {}", category, categories));
}

void draw_cell(Painter& painter, const Rect& place, const CellCategory& category, const PlotSizes& sizes) {
  painter.fill(place, category.color);
  if (category.letter.empty()) return;
  constexpr double share_of_height = 0.62, share_of_width = 0.8, least = 8;
  TextStyle style{std::min(share_of_height * place.height(), sizes.tick.size), Weight::regular};
  const double width = painter.font().measure(category.letter, style).width;
  if (width > share_of_width * place.width()) style.size *= share_of_width * place.width() / width;
  if (style.size < least) return;
  const double middle_of_letter = 0.36 * style.size;
  Color ink = ink_on(category.color);
  ink.a = 0.75F;
  painter.text(category.letter, style, (place.left + place.right) / 2,
               (place.top + place.bottom) / 2 + middle_of_letter, Align::center, ink);
}

void draw_cells(Painter& painter, const CellGrid& cells, const std::vector<CellCategory>& categories,
                const PanelLayout& panel, const PlotSizes& sizes) {
  painter.clip(panel.frame);
  const std::size_t columns = cells.x_edges.empty() ? 0 : cells.x_edges.size() - 1;
  for (std::size_t k = 0; k < cells.categories.size(); ++k) {
    if (cells.categories[k] < 0) continue;
    const std::size_t row = k / columns, column = k % columns;
    // Whole pixels, with a gap of one that tells neighbours apart.
    const Rect place{std::round(panel.x(cells.x_edges[column])) + 1,
                     std::round(panel.y(cells.y_edges[row + 1])) + 1,
                     std::round(panel.x(cells.x_edges[column + 1])), std::round(panel.y(cells.y_edges[row]))};
    draw_cell(painter, place, categories[static_cast<std::size_t>(cells.categories[k])], sizes);
  }
  painter.clip_nothing();
}

}  // namespace plumb
