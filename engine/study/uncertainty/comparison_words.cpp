#include "engine/study/uncertainty/comparison_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plumb {

std::string comparison_finding(double error, double expanded, const std::string& unit, bool published,
                               bool whole) {
  const double size = std::abs(error);
  if (!std::isfinite(size) || !std::isfinite(expanded)) return "nothing can be said: it is not a number";
  if (size <= expanded) return "not distinguishable at this uncertainty";
  return fmt::format("{} error between {:.3g} and {:.3g} {}{}", published ? "model" : "numerical",
                     size - expanded, size + expanded, unit,
                     whole ? "" : ", or in wider bounds: not every part is estimated");
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
