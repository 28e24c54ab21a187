#include "report/diff/number_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "engine/base/csv.h"
#include "engine/base/interrupt.h"

namespace plumb {
namespace {

std::optional<double> number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

/// The texts of a row, which tell what its numbers belong to.
std::string kind_of(const CsvLine& line) {
  std::string kind;
  for (const CsvCell& cell : line.cells)
    if (!number(cell.text)) kind += cell.text + '\n';
  return kind;
}

/// The largest number of each column, by kind of row.
using Scales = std::map<std::string, std::vector<double>>;

void add_scales(const std::vector<CsvLine>& lines, Scales& scales) {
  for (const CsvLine& line : lines) {
    stop_if_interrupted();
    std::vector<double>& of_kind = scales[kind_of(line)];
    of_kind.resize(std::max(of_kind.size(), line.cells.size()), 0);
    for (std::size_t c = 0; c < line.cells.size(); ++c)
      if (const auto value = number(line.cells[c].text); value && std::isfinite(*value))
        of_kind[c] = std::max(of_kind[c], std::abs(*value));
  }
}

bool alike(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

NumberDifference number_difference(const std::string& a, const std::string& name_a, const std::string& b,
                                   const std::string& name_b) {
  const std::vector<CsvLine> first = parse_csv(a, name_a), second = parse_csv(b, name_b);
  NumberDifference result;
  if (first.size() != second.size()) {
    result.unlike = fmt::format("{} and {} rows", first.size(), second.size());
    return result;
  }
  Scales scales;
  add_scales(first, scales);
  add_scales(second, scales);
  for (std::size_t row = 0; row < first.size(); ++row) {
    const auto& cells = first[row].cells;
    const auto& others = second[row].cells;
    if (cells.size() != others.size()) {
      result.unlike =
          fmt::format("line {}: {} and {} cells", second[row].number, cells.size(), others.size());
      return result;
    }
    stop_if_interrupted();
    const std::vector<double>& largest = scales[kind_of(first[row])];
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto x = number(cells[c].text), y = number(others[c].text);
      if (x && y) ++result.numbers;
      if (cells[c].text == others[c].text) continue;
      if (!x || !y) {
        result.unlike =
            fmt::format("line {}: '{}' and '{}'", second[row].number, cells[c].text, others[c].text);
        return result;
      }
      if (alike(*x, *y)) continue;
      ++result.differing;
      const double relative = std::abs(*x - *y) / largest[c];
      if (relative <= result.greatest && !result.where.empty()) continue;
      result.greatest = std::isfinite(relative) ? relative : HUGE_VAL;
      const std::string& column =
          c < first.front().cells.size() ? first.front().cells[c].text : cells[c].text;
      result.where =
          fmt::format("line {}, {}: {} and {}", second[row].number, column, cells[c].text, others[c].text);
    }
  }
  return result;
}

}  // namespace plumb
