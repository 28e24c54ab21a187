#include "engine/study/work_precision/observed_order.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

struct Slopes {
  double mean, spread;

  double allowed_spread() const { return 0.1 + 0.1 * mean; }
  bool agree() const {
    constexpr double least_slope = 0.5;
    return mean >= least_slope && spread <= allowed_spread();
  }
};

/// Of the runs from `first` to `last`, two or more.
Slopes slopes_between(std::span<const StepError> curve, std::size_t first, std::size_t last) {
  double sum = 0, low = INFINITY, high = -INFINITY;
  for (std::size_t k = first; k < last; ++k) {
    const double slope =
        std::log(curve[k].error / curve[k + 1].error) / std::log(curve[k].step / curve[k + 1].step);
    sum += slope;
    low = std::min(low, slope);
    high = std::max(high, slope);
  }
  return {sum / static_cast<double>(last - first), high - low};
}

ObservedOrder fit(std::span<const StepError> part) {
  const auto n = static_cast<double>(part.size());
  double mean_x = 0, mean_y = 0;
  for (const StepError& run : part) {
    mean_x += std::log(run.step) / n;
    mean_y += std::log(run.error) / n;
  }
  double xx = 0, xy = 0, yy = 0;
  for (const StepError& run : part) {
    const double x = std::log(run.step) - mean_x, y = std::log(run.error) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  ObservedOrder result;
  result.order = xy / xx;
  result.deviation = std::sqrt(std::max(0.0, yy - result.order * xy) / ((n - 2) * xx));
  result.largest_step = part.front().step;
  result.smallest_step = part.back().step;
  return result;
}

}  // namespace

ObservedOrder observed_order(std::span<const StepError> curve, double floor, double ceiling, double highest) {
  constexpr std::size_t fewest = 3;
  const auto usable = [&](std::size_t k) {
    return curve[k].step > 0 && curve[k].error > std::max(floor, 0.0) && curve[k].error < ceiling &&
           (k == 0 || curve[k].step < curve[k - 1].step);
  };
  for (std::size_t last = curve.size(); last-- > 0;) {
    if (!usable(last)) continue;
    std::size_t first = last;
    while (first > 0 && usable(first - 1) &&
           (first == last || slopes_between(curve, first - 1, last).agree()))
      --first;
    if (last - first + 1 < fewest) continue;
    const Slopes seen = slopes_between(curve, first, last);
    for (std::size_t k = last; k + 1 < curve.size(); ++k)
      if (usable(k) && usable(k + 1) &&
          slopes_between(curve, k, k + 1).mean > seen.mean + seen.allowed_spread())
        return {};
    const ObservedOrder found = fit(curve.subspan(first, last - first + 1));
    return found.order <= 1.1 * highest ? found : ObservedOrder{};
  }
  return {};
}

}  // namespace plumb
