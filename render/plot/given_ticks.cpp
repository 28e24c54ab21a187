#include "render/plot/given_ticks.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace plumb {

AxisTicks given_ticks(const AxisMap& axis, const std::vector<double>& values,
                      const std::vector<std::string>& labels, const TickRoom& room) {
  AxisTicks ticks;
  double free_from = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = values[k];
    const double at = std::abs(axis(value) - axis.start);
    if (!(value >= axis.range.lo && value <= axis.range.hi)) continue;
    std::string label = labels.empty() ? fmt::format("{:g}", value) : labels[k];
    const double half = room.extent(label) / 2;
    if (at - half < free_from)
      label.clear();
    else
      free_from = at + half + room.gap;
    ticks.major.push_back(value);
    ticks.labels.push_back(std::move(label));
  }
  return ticks;
}

}  // namespace plumb
