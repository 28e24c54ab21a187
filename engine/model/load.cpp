#include "engine/model/load.h"

#include <algorithm>

#include "engine/model/variable_loads.h"

namespace plumb {
namespace {

Load weight(const CableSpec& cable, const Vec3& gravity) {
  const double element = cable.length / cable.elements;
  return {gravity, {}, cable.density * cable.area * (element * cable.elements) * gravity.norm()};
}

Load end_force(const CableSpec& cable, const Vec3& force) {
  return {{0, 0, 0}, {{cable.elements, {force.x(), force.y(), force.z()}}}, force.norm()};
}

Load uniform(const CableSpec& cable, const Vec3& force) {
  return {force / (cable.density * cable.area), {}, cable.length * force.norm()};
}

Load point_force(const CableSpec& cable, double s, const Vec3& force) {
  const auto [element, place] = place_on_cable(cable, s);
  Load load{{0, 0, 0}, {{element, {}}, {element + 1, {}}}, force.norm()};
  for (std::size_t i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k)
      load.on_nodes[i / 2].force[3 * (i % 2) + static_cast<std::size_t>(k)] = place.position[i] * force[k];
  return load;
}

}  // namespace

std::vector<Load> loads_of(const Case& spec) {
  std::vector<Load> loads;
  const auto add = [&](auto load, const Vec3& value) {
    if (!value.isZero(0)) loads.push_back(load(spec.cable, value));
  };
  add(weight, spec.loads.gravity);
  add(end_force, spec.loads.end_force);
  const auto add_at = [&](double s, const Vec3& value) {
    if (!value.isZero(0)) loads.push_back(point_force(spec.cable, s, value));
  };
  for (const MassSpec& mass : spec.masses) add_at(mass.at, mass.mass * spec.loads.gravity);
  for (const LoadSpec& load : spec.loads.applied) {
    if (!is_constant(load, spec.parameters)) continue;
    const Vec3 value = TimeFunction(load.factor, spec.parameters)(0) * load.value;
    if (load.kind == LoadKind::distributed)
      add(uniform, value);
    else
      add_at(load.at, value);
  }
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
