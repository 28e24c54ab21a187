#include "engine/base/time_interpolation.h"

#include <algorithm>

namespace plumb {
namespace {

constexpr std::size_t most_points = 4;

/// The times about t that the polynomial goes through: as many before it as after, as far as there are.
struct Stencil {
  std::size_t first;
  std::size_t count;
};

Stencil stencil(const std::vector<double>& times, double t) {
  const std::size_t count = std::min(times.size(), most_points);
  const auto after =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
  const std::size_t first = after < count / 2 ? 0 : after - count / 2;
  return {std::min(first, times.size() - count), count};
}

}  // namespace

double TimeInterpolation::value(double t) const {
  const auto own = std::lower_bound(times_.begin(), times_.end(), t);
  if (own != times_.end() && *own == t) return values_[static_cast<std::size_t>(own - times_.begin())];
  const auto [first, count] = stencil(times_, t);
  double sum = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < first + count; ++j)
      if (j != i) weight *= (t - times_[j]) / (times_[i] - times_[j]);
    sum += weight * values_[i];
  }
  return sum;
}

double TimeInterpolation::rate(double t) const {
  const auto [first, count] = stencil(times_, t);
  double sum = 0;
  for (std::size_t i = first; i < first + count; ++i)
    for (std::size_t k = first; k < first + count; ++k) {
      if (k == i) continue;
      double weight = 1 / (times_[i] - times_[k]);
      for (std::size_t j = first; j < first + count; ++j)
        if (j != i && j != k) weight *= (t - times_[j]) / (times_[i] - times_[j]);
      sum += weight * values_[i];
    }
  return sum;
}

std::string_view interpolation_in_words(std::size_t count) {
  return count >= most_points ? "cubically" : count == 3 ? "quadratically" : "linearly";
}

}  // namespace plumb
