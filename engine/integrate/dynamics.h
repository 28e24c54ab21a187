#pragma once

#include <initializer_list>
#include <optional>

#include "engine/integrate/trajectory.h"
#include "engine/kernels/kernels.h"
#include "engine/model/block_lu.h"
#include "engine/model/huge_array.h"
#include "engine/model/support_motion.h"

namespace plumb {

class Cable;
struct State;

/// When forces are asked for, and at which rates: v + plus + reach x, x being that of a stage. They count
/// where not all forces have a potential.
struct Instant {
  double t = 0;               ///< s
  const double* v = nullptr;  ///< m/s and 1/s; nullptr: at rest
  Scaled plus = {};           ///< m/s and 1/s; its numbers may be nullptr
  double reach = 0;           ///< s
  double load = 1;            ///< how much there is of all loads
  bool still = false;         ///< supports are where they are then, but at rest: of an equilibrium
};

/// Times of a run that tolerances are held against.
struct RunTimes {
  /// T, s: 2πL/V, with V the speed that all the energy at hand would give to all of the cable. Rates count by
  /// L/T and 1/T.
  double own = 1;
  double duration = 1;  ///< s
};

/// A spring between a node and the ground.
struct NodeSpring {
  int node;
  Eigen::Vector3d along;  ///< of the square root of its stiffness: |along|² in N/m
};

/// What a method asks of a cable during one run, with the count of what it asked, in coordinates relative to
/// the supports. Not shared between threads.
class Dynamics {
 public:
  explicit Dynamics(const Cable& cable, const RunTimes& times = {});

  const RunTimes& times() const { return times_; }

  const Cable& cable() const { return cable_; }
  int size() const;

  /// f := forces on the cable (external and elastic), with those that the supports take up set to 0.
  void force(const Eigen::VectorXd& q, Eigen::VectorXd& f, const Instant& at = {});

  /// The same with the forces on what the supports hold, in which theirs are not.
  void free_force(const Eigen::VectorXd& q, Eigen::VectorXd& f, const Instant& at);

  /// a := dv/dt, consistent with the supports.
  void acceleration(const Eigen::VectorXd& q, Eigen::VectorXd& a) { acceleration(Sum(q), a, {}); }
  void acceleration(const State& state, Eigen::VectorXd& a);

  /// The same at coordinates that are a sum, with other sums before and after it: see StageSums. An a that is
  /// one of their terms must have its size already.
  void acceleration(const Sum& q, Eigen::VectorXd& a, const Instant& at,
                    std::initializer_list<Sum> before = {}, std::initializer_list<Sum> after = {});

  /// Factors S = mass_factor · M + stiffness_factor · K + rate_factor · C with supports, K = −∂f/∂q and C =
  /// −∂f/∂v. Returns the node at which S is singular; nothing if all is well.
  [[nodiscard]] std::optional<int> factor(const Eigen::VectorXd& q, double mass_factor,
                                          double stiffness_factor, const Instant& at = {},
                                          double rate_factor = 0);

  /// A := mass_factor · M + stiffness_factor · K + rate_factor · C, without supports.
  void general_system(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor,
                      const Instant& at, double rate_factor, GeneralBlockTridiagonal<double>& A);

  /// Factors K(q) with supports and a spring to the ground beside it. Returns what `factor` does.
  [[nodiscard]] std::optional<int> factor(const Eigen::VectorXd& q, const NodeSpring& spring);

  /// Negative eigenvalues of the S that was factored last: 0 only where it is positive definite, nothing
  /// where they cannot be counted. Those of an S that is not symmetric are not counted.
  std::optional<int> negative_eigenvalues() const;

  /// x := S⁻¹ x; x must be free of what the supports hold.
  void solve(Eigen::VectorXd& x) const;

  /// y := y + factor · C b, with C at t (s) and q.
  void add_rate_product(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& b, double factor,
                        Eigen::VectorXd& y);

  /// One correction of Newton's iteration for a stage, whose rates are those of `at`: x := from + the
  /// residual there, solved with the factors at hand, or, with `stiffness_factor` other than 0, with those of
  /// mass · M + stiffness_factor · K
  /// + force · reach of the rates · C at the stage's point. x is given its size; the stage must not be made
  /// of it. After a correction that was unsound or singular the next one must renew the matrix. `turns`: an
  /// old matrix is turned with the nodes, which it must have been since it was made.
  StageCorrection correct(const StageTerms& stage, double stiffness_factor, Eigen::VectorXd& x,
                          const Instant& at = {}, bool turns = false);

  /// An element whose slope collapsed in `force` or `acceleration` since the last call; forgets it.
  std::optional<int> take_collapsed();

  Counters counters;

 private:
  /// The same for any model and any matrix, one thing after the other.
  StageCorrection correct_stepwise(const StageTerms& stage, double stiffness_factor, Eigen::VectorXd& x,
                                   const Instant& at, bool turns);
  /// rates_ := those of an instant, at x.
  void set_rates(const Instant& at, const Scaled& x = {});
  /// q and v in the frame of the supports, with the displacement of the last end.
  struct Placed {
    const Eigen::VectorXd& q;
    const Eigen::VectorXd& v;
  };
  /// Those of q and rates_. Good until the next call.
  Placed placed(const Eigen::VectorXd& q, double t, bool still);
  /// f := f + the loads beyond a share of 1 and what has no potential, at what `placed` gave.
  void add_other_forces(const Placed& there, const Instant& at, Eigen::VectorXd& f) const;
  /// By row exchanges, where S is not positive definite.
  std::optional<int> factor_indefinite(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor);
  void assemble(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor);
  double* factors();

  const Cable& cable_;
  RunTimes times_;
  bool by_kernels_;  // all of a stage is done by the kernels
  Eigen::VectorXd scratch_, point_, inertia_, rates_;
  MovedSupports moved_;  // where `placed` was asked for last
  Eigen::VectorXd placed_q_, placed_v_;
  HugeArray factors_;                       // none before the first are made
  std::vector<double> turns_;               // of the nodes since then, where they are asked for
  std::optional<BlockTridiagonal> system_;  // S itself, where it is wanted in full
  BlockLu<double> lu_;                      // instead, where S is not positive definite
  bool definite_ = true, symmetric_ = true;
  std::optional<int> collapsed_;
};

}  // namespace plumb
