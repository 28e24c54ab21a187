#include "engine/study/work_precision/cheapest.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {

std::string duration_in_words(double seconds) {
  if (seconds >= 1) return fmt::format("{:.3g} s", seconds);
  return seconds >= 1e-3 ? fmt::format("{:.3g} ms", seconds * 1e3) : fmt::format("{:.3g} µs", seconds * 1e6);
}

std::vector<CheapestRun> cheapest_runs(const WorkPrecision& study, const std::vector<std::string>& labels,
                                       const std::vector<WorkError>& points, double floor, double ceiling) {
  std::vector<CheapestRun> result;
  constexpr int lowest = -300;
  // A power that is `ceiling` itself but for round-off counts as that.
  const int highest = static_cast<int>(std::ceil(std::log10(ceiling) - 1e-9)) - 1;
  for (int power = highest; power > lowest; --power) {
    const double error = std::pow(10.0, power);
    if (error < floor) break;
    const WorkError* best = nullptr;
    for (const WorkError& point : points)
      if (point.work >= 0 && point.error >= 0 && point.error <= error && (!best || point.work < best->work))
        best = &point;
    if (!best) break;
    const auto k = static_cast<std::size_t>(best - points.data());
    const WorkPrecisionRun& run = study.runs[k];
    result.push_back(
        {error, k,
         fmt::format("below 1e{} m: {} with {} element{}, {}, {}", power, labels[k], run.elements,
                     run.elements == 1 ? "" : "s", run.setting(), study.work_in_words(best->work))});
  }
  return result;
}

}  // namespace plumb
