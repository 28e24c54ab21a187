#include "engine/case/range.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {

bool Range::contains(double x) const {
  return std::isfinite(x) && (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high) &&
         (!whole || x == std::round(x));
}

std::string Range::allowed() const {
  std::string text = whole ? "a whole number" : "a number";
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  if (has_low && has_high && !low_open && !high_open) {
    text += fmt::format(" from {} to {}", low, high);
  } else {
    if (has_low) text += fmt::format(" {} {}", low_open ? "greater than" : "of at least", low);
    if (has_low && has_high) text += " and";
    if (has_high) text += fmt::format(" {} {}", high_open ? "less than" : "of at most", high);
  }
  if (!unit.empty()) text += fmt::format(" ({})", unit);
  return text;
}

}  // namespace plumb
