#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/model/block_lu.h"
#include "engine/model/chain.h"
#include "engine/model/element.h"
#include "engine/model/integration_points.h"

namespace plumb {

class Cable;

/// A discrete gradient D(q₀, q₁) of the strain energy U of a cable (Gonzalez 1996): D · (q₁ − q₀) = U(q₁) −
/// U(q₀) exactly, D(q, q) = ∂U/∂q, and no net force or moment. At each integration point the energy is a
/// function of a = r'·r', b = r''·r'' and d = r'·r'', whose differences are exact with the mean of r' and
/// r'': it is split into sums and products, for which mean and difference quotient are taken algebraically,
/// so that nothing is divided by a difference that may vanish. Of a
/// chain it is that of its links.
class DiscreteGradient {
 public:
  explicit DiscreteGradient(const Cable& cable);

  /// f := −D(q₀, q₁) of all elements. Returns an element whose slope has collapsed at either state, for which
  /// f is incomplete; nothing if all is well.
  std::optional<int> force(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, Eigen::VectorXd& f) const;

  /// Adds factor · ∂D/∂q₁, which is not symmetric, to A.
  void add_tangent(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, double factor,
                   GeneralBlockTridiagonal<double>& A) const;

 private:
  using Vector12 = Eigen::Matrix<double, 12, 1>;
  using Matrix12 = Eigen::Matrix<double, 12, 12>;

  /// Adds what an element contributes; returns false where a slope has collapsed. `K`: may be null.
  bool add_element(const double* q0, const double* q1, Vector12& D, Matrix12* K) const;

  int elements_;
  double axial_stiffness_, bending_stiffness_;
  bool green_;
  std::optional<Chain> chain_;
  std::vector<IntegrationPoint> axial_, bending_;
};

}  // namespace plumb
