#pragma once

#include <vector>

#include "engine/case/case.h"
#include "engine/kernels/kernels.h"
#include "engine/model/own_units.h"

namespace plumb {

/// A constant load on the cable, as forces on its nodal coordinates. A constant force has the potential −f·q
/// and has no part in the tangent, so that a list of these is added up once for all of a run.
struct Load {
  Vec3 per_mass{0, 0, 0};           ///< force on each unit of mass, N/kg
  std::vector<NodeForce> on_nodes;  ///< beside that, in any order
  double size = 0;                  ///< of all its forces, N; times a length, energy that it can release
};

/// The constant loads of a case on a mesh of equal elements, one for each that is there: its weight, that of
/// each mass on it, and forces that do not change (VariableLoads has the others).
std::vector<Load> loads_of(const Case& spec);

/// Constant loads added up.
class LoadSum {
 public:
  explicit LoadSum(const std::vector<Load>& loads);

  LoadSum in_units(const OwnUnits& units) const;

  const Vec3& per_mass() const { return per_mass_; }
  NodeForces on_nodes() const { return {on_nodes_.data(), static_cast<int>(on_nodes_.size())}; }
  double size() const { return size_; }  ///< N

 private:
  Vec3 per_mass_{0, 0, 0};
  std::vector<NodeForce> on_nodes_;
  double size_ = 0;
};

}  // namespace plumb
