#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/base/time_function.h"
#include "engine/model/block_lu.h"
#include "engine/model/element_place.h"
#include "engine/model/own_units.h"

namespace plumb {

/// The loads of a case that are not constant forces: those that change with time, and those that depend on
/// how the cable lies where they act, which in general have no potential and a tangent that is not symmetric.
///
/// With t the direction of the cable where a load acts, t₀ that at the start: one that follows is the value
/// turned by the shortest rotation from t₀ to t. A moment m acts through the slope, δW = m · (t × δr'/|r'|),
/// so that its part along t does no work.
class VariableLoads {
 public:
  explicit VariableLoads(const Case& spec);

  VariableLoads in_units(const OwnUnits& units) const;

  bool empty() const { return loads_.empty(); }
  /// Whether any depends on how the cable lies.
  bool has_tangent() const;
  /// Of their forces, at the greatest of each within that duration (s), N; times a length, energy that they
  /// may give. That of a moment is its force over the whole length.
  double size(double duration) const;

  /// f := f + share times the loads at t (s) and q. Where a slope has collapsed nothing is added.
  void add_force(double t, double share, const Eigen::VectorXd& q, Eigen::VectorXd& f) const;
  /// A := A − factor · share · ∂f/∂q.
  void add_stiffness(double t, double share, const Eigen::VectorXd& q, double factor,
                     GeneralBlockTridiagonal<double>& A) const;

 private:
  struct Variable {
    LoadKind kind;
    Vec3 value;
    bool follows;
    TimeFunction factor;  // of a time in s
    int first, last;      // elements it acts on, the last one included
    std::vector<ElementPlace> places;
  };

  double length_;    // of the cable, m
  double time_ = 1;  // in which t counts, s
  Vec3 start_;       // t₀
  std::vector<Variable> loads_;
};

/// True of a load that is a constant force, as `loads_of` has it.
bool is_constant(const LoadSpec& load, const std::map<std::string, double>& parameters);

}  // namespace plumb
