#include "engine/model/own_units.h"

#include <cmath>

namespace plumb {

OwnUnits OwnUnits::of(double length, double time, double mass) {
  const auto below = [](double x) { return std::exp2(std::ilogb(x)); };
  return {below(length), below(time), below(mass)};
}

void scale_nodal(double positions, double slopes, Eigen::VectorXd& nodal) {
  for (Eigen::Index at = 0; at < nodal.size(); at += 6) {
    nodal.segment<3>(at) *= positions;
    nodal.segment<3>(at + 3) *= slopes;
  }
}

}  // namespace plumb
