#pragma once

#include "render/gl/painter.h"
#include "render/plot/plot_layout.h"

namespace plumb {

/// Throws OutputError where edges of cells are not finite or do not rise.
void check_edges(const std::vector<double>& edges);

/// Throws OutputError where edges do not rise, cells and edges differ in number, or a category is not one of
/// so many.
void check_cells(const CellGrid& cells, std::size_t categories);

/// Fills the cells of a panel, with their letters where these can be read.
void draw_cells(Painter& painter, const CellGrid& cells, const std::vector<CellCategory>& categories,
                const PanelLayout& panel, const PlotSizes& sizes);

/// Fills a rectangle with a category's colour and puts its letter in the middle.
void draw_cell(Painter& painter, const Rect& place, const CellCategory& category, const PlotSizes& sizes);

/// Black or white, whichever can be read better on a colour.
Color ink_on(Color color);

}  // namespace plumb
