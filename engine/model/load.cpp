#include "engine/model/load.h"

#include <algorithm>

namespace plumb {
namespace {

Load weight(const CableSpec& cable, const Vec3& gravity) {
  const double element = cable.length / cable.elements;
  return {gravity, {}, cable.density * cable.area * (element * cable.elements) * gravity.norm()};
}

Load end_force(const CableSpec& cable, const Vec3& force) {
  return {{0, 0, 0}, {{cable.elements, {force.x(), force.y(), force.z()}}}, force.norm()};
}

}  // namespace

std::vector<Load> loads_of(const Case& spec) {
  std::vector<Load> loads;
  const auto add = [&](auto load, const Vec3& value) {
    if (!value.isZero(0)) loads.push_back(load(spec.cable, value));
  };
  add(weight, spec.loads.gravity);
  add(end_force, spec.loads.end_force);
  return loads;
}

LoadSum::LoadSum(const std::vector<Load>& loads) {
  for (const Load& load : loads) {
    per_mass_ += load.per_mass;
    size_ += load.size;
    for (const NodeForce& on : load.on_nodes) {
      const auto at = std::lower_bound(on_nodes_.begin(), on_nodes_.end(), on.node,
                                       [](const NodeForce& other, int node) { return other.node < node; });
      if (at == on_nodes_.end() || at->node != on.node) {
        on_nodes_.insert(at, on);
        continue;
      }
      for (int k = 0; k < 6; ++k) at->force[k] += on.force[k];
    }
  }
}

LoadSum LoadSum::in_units(const OwnUnits& units) const {
  LoadSum result(*this);
  result.per_mass_ /= units.force() / units.mass;
  result.size_ /= units.force();
  for (NodeForce& on : result.on_nodes_)
    for (int k = 0; k < 6; ++k) on.force[k] /= k < 3 ? units.force() : units.moment();
  return result;
}

}  // namespace plumb
