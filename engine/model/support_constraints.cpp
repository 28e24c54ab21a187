#include "engine/model/support_constraints.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/model/supports.h"

namespace plumb {

SupportConstraints::SupportConstraints(const SupportsSpec& supports, const Vec3& direction, int nodes) {
  const auto constrain = [&](const Hold& hold, int node) {
    if (hold.position)
      for (int k = 0; k < 3; ++k) rows_.push_back({6 * node, Vec3::Unit(k)});
    if (!hold.direction) return;
    const Vec3 across = direction.unitOrthogonal();
    rows_.push_back({6 * node + 3, across});
    rows_.push_back({6 * node + 3, direction.cross(across)});
  };
  constrain(hold_of(supports.first), 0);
  constrain(hold_of(supports.last), nodes - 1);
}

double greatest_reaction(const SupportsSpec& supports, const std::vector<Eigen::VectorXd>& multipliers) {
  double greatest = 0;
  for (const Eigen::VectorXd& lambda : multipliers) {
    Eigen::Index at = 0;
    for (const Hold& hold : {hold_of(supports.first), hold_of(supports.last)}) {
      if (hold.position) {
        greatest = std::max(greatest, lambda.segment<3>(at).norm());
        at += 3;
      }
      if (hold.direction) at += 2;
    }
  }
  return greatest;
}

}  // namespace plumb
