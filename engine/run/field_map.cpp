#include "engine/run/field_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/cable.h"
#include "engine/run/cable_field.h"

namespace plumb {
namespace {

constexpr std::size_t most_samples = 4;

// Of the whole numbers from `first` to before `end`, no more than so many, evenly.
std::vector<std::size_t> some_between(std::size_t first, std::size_t end) {
  const std::size_t count = std::min(most_samples, end - first);
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(first + (2 * k + 1) * (end - first) / (2 * count));
  return result;
}

}  // namespace

FieldMap field_map(const Cable& cable, ColorField field, const Trajectory& trajectory, int most_columns,
                   int most_rows) {
  FieldMap map;
  const std::vector<double>& times = trajectory.times;
  const std::size_t outputs = times.size();
  if (outputs < 2) return map;
  const std::size_t columns = std::min(outputs, static_cast<std::size_t>(most_columns));
  const auto first_of = [&](std::size_t column) { return column * outputs / columns; };
  for (std::size_t c = 0; c <= columns; ++c) {
    const std::size_t k = first_of(c);
    map.time_edges.push_back(c == 0         ? times.front()
                             : c == columns ? times.back()
                                            : times[k - 1] / 2 + times[k] / 2);
  }
  const int elements = cable.elements();
  const int rows = elements > most_rows ? most_rows : elements * (most_rows / elements);
  for (int r = 0; r <= rows; ++r) map.place_edges.push_back(static_cast<double>(r) / rows * cable.length());
  const int places = rows >= elements ? 1 : static_cast<int>(most_samples);

  map.values.assign(static_cast<std::size_t>(rows) * columns, 0);
  for (std::size_t c = 0; c < columns; ++c) {
    const std::vector<std::size_t> chosen = some_between(first_of(c), first_of(c + 1));
    for (int r = 0; r < rows; ++r) {
      double sum = 0;
      int count = 0;
      for (const std::size_t output : chosen)
        for (int p = 0; p < places; ++p) {
          const double s = (r + (p + 0.5) / places) / rows;
          const double value = field_value(cable, field, trajectory.q[output], trajectory.v[output], s);
          if (!std::isfinite(value)) continue;
          sum += value;
          ++count;
        }
      map.values[static_cast<std::size_t>(r) * columns + c] =
          count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return map;
}

}  // namespace plumb
