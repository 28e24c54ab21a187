#include "engine/model/support_constraints.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace plumb {

SupportConstraints::SupportConstraints(const SupportsSpec& supports, const Vec3& direction, int nodes) {
  const auto hold = [&](Support support, int node) {
    if (support == Support::free) return;
    for (int k = 0; k < 3; ++k) rows_.push_back({6 * node, Vec3::Unit(k)});
    if (support != Support::clamped) return;
    const Vec3 across = direction.unitOrthogonal();
    rows_.push_back({6 * node + 3, across});
    rows_.push_back({6 * node + 3, direction.cross(across)});
  };
  hold(supports.first, 0);
  hold(supports.last, nodes - 1);
}

double greatest_reaction(const SupportsSpec& supports, const std::vector<Eigen::VectorXd>& multipliers) {
  double greatest = 0;
  for (const Eigen::VectorXd& lambda : multipliers) {
    Eigen::Index at = 0;
    for (const Support support : {supports.first, supports.last}) {
      if (support == Support::free) continue;
      greatest = std::max(greatest, lambda.segment<3>(at).norm());
      at += support == Support::clamped ? 5 : 3;
    }
  }
  return greatest;
}

}  // namespace plumb
