#pragma once

#include <optional>

#include "engine/integrate/trajectory.h"
#include "engine/model/block_lu.h"
#include "engine/model/cable.h"

namespace plumb {

/// What a method asks of a cable during one run, with the count of what it asked. Not shared between threads.
class Dynamics {
 public:
  explicit Dynamics(const Cable& cable);

  const Cable& cable() const { return cable_; }
  int size() const { return cable_.size(); }

  /// f := forces on the cable (external and elastic), with those that the supports take up set to 0.
  void force(const Eigen::VectorXd& q, Eigen::VectorXd& f);

  /// a := dv/dt, consistent with the supports.
  void acceleration(const Eigen::VectorXd& q, Eigen::VectorXd& a);

  /// Factors S = mass_factor · M + stiffness_factor · K(q) with supports, K = −∂f/∂q. Returns the node at
  /// which S is singular; nothing if all is well.
  [[nodiscard]] std::optional<int> factor(const Eigen::VectorXd& q, double mass_factor,
                                          double stiffness_factor);

  /// x := S⁻¹ x; x must be free of what the supports hold.
  void solve(Eigen::VectorXd& x) const;

  /// An element whose slope collapsed in a force evaluation since the last call; forgets it.
  std::optional<int> take_collapsed();

  Counters counters;

 private:
  void assemble(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor);

  const Cable& cable_;
  Eigen::VectorXd scratch_;
  BlockTridiagonal system_;  // and its factors, in place
  BlockLu<double> lu_;       // instead, where S is not positive definite
  bool definite_ = true;
  std::optional<int> collapsed_;
};

}  // namespace plumb
