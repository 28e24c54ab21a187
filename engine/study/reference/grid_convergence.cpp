#include "engine/study/reference/grid_convergence.h"

#include <cmath>

namespace plumb {

GridConvergence grid_convergence(double change21, double change32, double ratio21, double ratio32,
                                 double safety_factor) {
  if (!(change21 > 0 && std::isfinite(change32) && ratio21 > 1 && ratio32 > 1)) return {};
  const double changes = std::log(change32 / change21);
  // Where the changes would be for an order of 0; the absolute value in the formula would hide it.
  if (!(changes > std::log(std::log(ratio32) / std::log(ratio21)))) return {};
  constexpr int most_iterations = 1000;
  constexpr double tolerance = 1e-13;
  double p = 1;
  bool settled = false;
  for (int k = 0; k < most_iterations && !settled; ++k) {
    if (!(p > 0)) return {};
    const double q = std::log(std::expm1(p * std::log(ratio21)) / std::expm1(p * std::log(ratio32)));
    const double next = std::abs(changes + q) / std::log(ratio21);
    settled = std::abs(next - p) <= tolerance * p;
    p = next;
  }
  if (!settled || !std::isfinite(p)) return {};
  GridConvergence result;
  result.order = p;
  result.error = change21 / std::expm1(p * std::log(ratio21));
  result.index = safety_factor * result.error;
  return result;
}

}  // namespace plumb
