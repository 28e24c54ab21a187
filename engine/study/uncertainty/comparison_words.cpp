#include "engine/study/uncertainty/comparison_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plumb {

std::string comparison_finding(const SeriesUncertainty& series) {
  const auto count = series.times.size();
  const auto unknown = [](const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double x) { return !std::isfinite(x); });
  };
  if (unknown(series.error) || unknown(series.validation)) return "nothing can be said: it is not a number";
  if (series.beyond.empty())
    return count == 1 ? "not distinguishable at this uncertainty"
                      : fmt::format("not distinguishable at any of {} times", count);
  const auto excess = [&](std::size_t t) {
    return std::abs(series.error[t]) - coverage_factor * series.validation[t];
  };
  const std::size_t clearest =
      *std::max_element(series.beyond.begin(), series.beyond.end(),
                        [&](std::size_t a, std::size_t b) { return excess(a) < excess(b); });
  const std::size_t first = series.beyond.front(), last = series.beyond.back();
  const double size = std::abs(series.error[clearest]),
               expanded = coverage_factor * series.validation[clearest];
  std::string when;
  if (count > 1)
    when = fmt::format(
        "distinguishable at {} of {} times, {}: ", series.beyond.size(), count,
        first == last
            ? fmt::format("at {:.4g} s", series.times[first])
            : fmt::format("{} {:.4g} {} {:.4g} s",
                          last - first + 1 == series.beyond.size() ? "from" : "between", series.times[first],
                          last - first + 1 == series.beyond.size() ? "to" : "and", series.times[last]));
  return fmt::format("{}{} error between {:.3g} and {:.3g} {}{}{}", when,
                     series.published ? "model" : "numerical", size - expanded, size + expanded, series.unit,
                     count > 1 ? fmt::format(" at {:.4g} s", series.times[clearest]) : "",
                     series.whole() ? "" : ", or in wider bounds: not every part is estimated");
}

DataUncertainty data_uncertainty(const ReferenceSeries& series) {
  constexpr std::array rounding = {"printed digit", "rounding", "last digit"};
  const bool rounded = std::any_of(rounding.begin(), rounding.end(), [&](const char* words) {
    return series.uncertainty_basis.find(words) != std::string::npos;
  });
  return {series.uncertainty / std::numbers::sqrt3,
          fmt::format("the half width that the reference states, {:.3g} {} ({}), over √3: {}",
                      series.uncertainty, series.unit, series.uncertainty_basis,
                      rounded ? "the greatest that rounding can do, bounds of a uniform distribution"
                              : "taken as bounds of a uniform distribution, as no coverage is stated")};
}

}  // namespace plumb
