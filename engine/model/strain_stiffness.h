#pragma once

#include <Eigen/Core>

#include "engine/kernels/kernels.h"

namespace plumb {

class Cable;

/// XᵀK X of the elastic forces, from the changes of strain and curvature at the integration points. The
/// matrix K has entries that cancel in all that is smooth, the more so the finer the mesh; this does not.
class StrainStiffness {
 public:
  /// About the state q. `cable` must outlive it.
  StrainStiffness(const Cable& cable, const Eigen::VectorXd& q);

  /// Xᵀ K X, a column of X each; J for those in m and 1.
  Eigen::MatrixXd of(const Eigen::MatrixXd& X) const;
  /// ∫ EA |δr'|² ds: what it would be if all change of the slopes stretched the cable; J.
  double scale_of(const Eigen::VectorXd& x) const;

 private:
  const Cable& cable_;
  Eigen::VectorXd q_;
};

}  // namespace plumb
