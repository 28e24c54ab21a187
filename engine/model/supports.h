#pragma once

#include <Eigen/Core>

#include "engine/case/case.h"
#include "engine/kernels/kernels.h"

namespace plumb {

class BlockTridiagonal;
template <class Scalar>
struct GeneralBlockTridiagonal;

/// What a support holds of its end. That is all that anything needs to know of it.
struct Hold {
  bool position = false;   ///< r
  bool direction = false;  ///< of r' the part across the straight cable, so that the end can still stretch

  bool none() const { return !position && !direction; }
};
Hold hold_of(Support);

/// What the supports hold, as a projection P on the admissible rates of the nodal coordinates (6 a node: r,
/// r'). The slopes of a chain, which are no unknowns, are held at every node. Supports do not move: a held
/// coordinate keeps its value.
class SupportProjection : public HeldEnds {
 public:
  /// `direction`: unit vector of the straight cable; only used where a direction is held.
  SupportProjection(const SupportsSpec& supports, const Vec3& direction, int nodes,
                    CableModel model = CableModel::cable);

  /// x := P x, for rates, accelerations or forces.
  void apply(Eigen::VectorXd& x) const;

  /// A := P A P + s (I − P) with some s > 0 of the size of A there: held coordinates get the equation x = 0.
  void apply(BlockTridiagonal& A) const;
  void apply(GeneralBlockTridiagonal<double>& A) const;

  // Of a cable; the slopes of a chain are held by `apply` alone.
  void hold_first(double* column) const override;
  void hold_last(double* column_before, double* column) const override;
  void hold(bool last, double* numbers) const override;

  const SupportsSpec& spec() const { return spec_; }
  const Hold& first() const { return first_; }
  const Hold& last() const { return last_; }
  const Vec3& direction() const { return direction_; }

 private:
  SupportsSpec spec_;
  Hold first_, last_;
  Vec3 direction_;
  int nodes_;
  bool slopes_held_;
};

}  // namespace plumb
