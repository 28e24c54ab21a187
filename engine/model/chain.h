#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/kernels/kernels.h"
#include "engine/model/block_tridiagonal.h"
#include "engine/model/link.h"

namespace plumb {

/// The links of a chain and its lumped masses, on coordinates that hold r and r' of each node in turn. No
/// link pulls at a slope, and slopes weigh next to nothing: they are no unknowns of a chain.
class Chain {
 public:
  /// `constants`: EA, ρA, l and the strain of a link, with `lumped` set.
  explicit Chain(const ElementConstants& constants);

  const Link& link() const { return link_; }

  /// f := f − ∂U/∂q. Returns a link that is not whole, for which f is incomplete; nothing if all is well.
  std::optional<int> subtract_gradient(const Eigen::VectorXd& q, Eigen::VectorXd& f) const;
  /// A := mass_factor · M + stiffness_factor · ∂²U/∂q².
  void system(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor,
              BlockTridiagonal& A) const;

  double strain_energy(const Eigen::VectorXd& q) const;   ///< J
  double kinetic_energy(const Eigen::VectorXd& v) const;  ///< of the positions' rates, J

  /// Gives the nodes the mean slope of the links beside them, of any nodal field.
  void set_slopes(Eigen::VectorXd& nodal) const;

 private:
  Vec3 chord(const Eigen::VectorXd& nodal, Eigen::Index link) const;

  double length_, half_mass_, slope_mass_;
  Link link_;
};

}  // namespace plumb
