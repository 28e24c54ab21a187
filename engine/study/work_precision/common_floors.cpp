#include "engine/study/work_precision/common_floors.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace plumb {
namespace {

constexpr double same_level = 1.5;

/// The level at which a curve ends flat: the geometric mean of its last three errors.
std::optional<double> level(const std::vector<double>& errors) {
  constexpr std::ptrdiff_t runs = 3;
  std::vector<double> usable;
  std::copy_if(errors.begin(), errors.end(), std::back_inserter(usable),
               [](double e) { return e > 0 && std::isfinite(e); });
  if (std::ssize(usable) < runs) return {};
  const auto last = usable.end() - runs;
  const auto [low, high] = std::minmax_element(last, usable.end());
  if (!(*high <= same_level * *low)) return {};
  return std::exp((std::log(last[0]) + std::log(last[1]) + std::log(last[2])) / 3);
}

}  // namespace

std::vector<CommonFloor> common_floors(const std::vector<CurveErrors>& curves) {
  constexpr std::size_t fewest_methods = 3;
  std::vector<std::pair<double, std::size_t>> levels;
  for (std::size_t k = 0; k < curves.size(); ++k)
    if (const auto at = level(curves[k].errors)) levels.emplace_back(*at, k);
  std::sort(levels.begin(), levels.end());
  std::vector<CommonFloor> floors;
  for (std::size_t first = 0; first < levels.size();) {
    std::size_t end = first;
    std::set<std::string> methods;
    CommonFloor floor;
    double logarithms = 0;
    for (; end < levels.size() && levels[end].first <= same_level * levels[first].first; ++end) {
      methods.insert(curves[levels[end].second].method);
      floor.curves.push_back(levels[end].second);
      logarithms += std::log(levels[end].first);
    }
    if (methods.size() >= fewest_methods) {
      floor.error = std::exp(logarithms / static_cast<double>(end - first));
      std::sort(floor.curves.begin(), floor.curves.end());
      floors.push_back(std::move(floor));
      first = end;
    } else {
      ++first;
    }
  }
  return floors;
}

}  // namespace plumb
