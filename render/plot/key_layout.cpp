#include "render/plot/key_layout.h"

#include <array>

#include "render/plot/cell_grid.h"

namespace plumb {
namespace {

const std::string& label_of(const PlotKey& key, const KeyEntry& entry) {
  return entry.category ? key.categories[entry.index].label : key.lines[entry.index].label;
}

}  // namespace

KeyLayout key_layout(const PlotKey& key, double top, double width, const PlotSizes& sizes, const Font& font) {
  KeyLayout layout;
  const double row_height = 1.5 * sizes.legend.size, left = sizes.gap, right = width - sizes.gap;
  std::size_t row_begin = 0;
  double x = left, y = top;
  const auto centre_row = [&] {
    const double shift = (right - (x - 2 * sizes.gap)) / 2;
    for (std::size_t k = row_begin; k < layout.entries.size() && shift > 0; ++k) {
      layout.entries[k].sample.left += shift;
      layout.entries[k].sample.right += shift;
      layout.entries[k].at.x() += shift;
    }
    row_begin = layout.entries.size();
  };
  const auto add = [&](bool category, std::size_t index) {
    KeyEntry entry;
    entry.category = category;
    entry.index = index;
    if (label_of(key, entry).empty()) return;
    const double sample =
        category ? 1.3 * sizes.legend.size : line_sample(key.lines[index], 2.2 * sizes.legend.size, sizes);
    const double length = sample + 0.6 * sizes.gap + font.measure(label_of(key, entry), sizes.legend).width;
    if (x > left && x + length > right) {
      centre_row();
      x = left;
      y += row_height;
    }
    entry.sample = {x, y + 0.1 * row_height, x + sample, y + 0.9 * row_height};
    entry.at = {x + sample + 0.6 * sizes.gap, y + 0.5 * row_height + 0.36 * sizes.legend.size};
    layout.entries.push_back(entry);
    x += length + 2 * sizes.gap;
  };
  for (std::size_t k = 0; k < key.categories.size(); ++k) add(true, k);
  for (std::size_t k = 0; k < key.lines.size(); ++k) add(false, k);
  centre_row();
  if (!layout.entries.empty()) layout.height = y + row_height - top + 0.3 * sizes.gap;
  return layout;
}

void draw_key(Painter& painter, const PlotKey& key, const std::vector<KeyEntry>& entries,
              const PlotSizes& sizes, const PlotTheme& theme) {
  for (const KeyEntry& entry : entries) {
    if (entry.category) {
      draw_cell(painter, entry.sample, key.categories[entry.index], sizes);
    } else {
      const Series& line = key.lines[entry.index];
      const double y = (entry.sample.top + entry.sample.bottom) / 2;
      painter.line(std::array{Point(entry.sample.left, y), Point(entry.sample.right, y)},
                   line.line_width * sizes.line, seen_on(theme, line.color.value_or(theme.ink)), line.dash);
    }
    painter.text(label_of(key, entry), sizes.legend, entry.at.x(), entry.at.y(), Align::left, theme.ink);
  }
}

}  // namespace plumb
