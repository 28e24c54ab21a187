#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/case/case.h"
#include "engine/kernels/kernels.h"
#include "engine/model/block_tridiagonal.h"
#include "engine/model/chain.h"
#include "engine/model/damping.h"
#include "engine/model/element.h"
#include "engine/model/energies.h"
#include "engine/model/load.h"
#include "engine/model/mass.h"
#include "engine/model/own_units.h"
#include "engine/model/support_motion.h"
#include "engine/model/supports.h"
#include "engine/model/variable_loads.h"

namespace plumb {

/// Position, slope and curvature vectors at a point of the cable.
struct CablePoint {
  Vec3 position;  ///< r, m
  Vec3 slope;     ///< r', 1
  Vec3 bend;      ///< r'', 1/m
};

/// The discrete cable: equal elements one after the other, or the links of a chain (CableModel), with
/// supports and loads. Its coordinates q hold r (m) and r' (1) of each node in
/// turn, 6(N + 1) numbers; v holds their rates. M dv/dt = f(q), dq/dt = v. Where supports move, methods know
/// coordinates relative to them alone (MovedSupports), in which nothing that is held changes. A Cable never
/// changes and may be shared between threads.
class Cable {
 public:
  explicit Cable(const Case& spec);

  /// The same cable with its numbers in those units instead of m, s and kg.
  Cable in_units(const OwnUnits& units) const;

  int elements() const { return elements_; }
  int nodes() const { return elements_ + 1; }
  int size() const { return 6 * nodes(); }
  double length() const { return element_.length() * elements_; }
  double total_mass() const { return constants_.mass_per_length * length(); }  ///< kg

  /// The links, where the cable is modelled as a chain; else nothing.
  const std::optional<Chain>& chain() const { return chain_; }
  /// True of a rigid rod, whose nodes stay on a straight line.
  bool is_rigid() const { return rigid_; }

  const Element& element() const { return element_; }
  /// The same element for the kernels.
  const ElementConstants& constants() const { return constants_; }
  const MassMatrix& mass() const { return mass_; }
  const SupportProjection& supports() const { return supports_; }

  /// Straight and evenly stretched, but for the imperfection of the case.
  Eigen::VectorXd start_q(const StartSpec& start) const;
  /// The rates at the start, those of the rotation and of the axial speed together; what the supports hold
  /// has their rates.
  Eigen::VectorXd start_v(const StartSpec& start) const;

  const LoadSum& loads() const { return loads_; }
  /// The loads together, on its coordinates, N and N m.
  const Eigen::VectorXd& external_force() const { return external_force_; }

  /// The angular velocity about the first end with which it starts, or with which the frame turns that it
  /// rests in, rad/s.
  const Vec3& spin() const { return spin_; }

  const VariableLoads& variable_loads() const { return variable_loads_; }
  const Damping& damping() const { return damping_; }
  const SupportMotion& motion() const { return motion_; }
  /// True where all forces have a potential: there are neither variable loads nor damping, and supports do
  /// not move.
  bool conservative() const { return variable_loads_.empty() && damping_.none() && motion_.none(); }
  /// True where ∂f/∂q is symmetric, and ∂f/∂v a multiple of the mass matrix.
  bool has_symmetric_tangent() const {
    return !variable_loads_.has_tangent() && !damping_.of_material() && !motion_.turns();
  }

  // Where supports move, all forces are those in their frame, and so are q and v, the last end's displacement
  // included.

  /// f := f + what has no potential: `share` times the variable loads at t (s), damping, and inertia in the
  /// frame of the supports.
  void add_other_forces(double t, double share, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                        Eigen::VectorXd& f, const MovedSupports& moved = {}) const;
  /// f := f + ∂f/∂v b of these.
  void add_rate_forces(const Eigen::VectorXd& q, const Eigen::VectorXd& b, Eigen::VectorXd& f,
                       const MovedSupports& moved) const;
  /// A := A − stiffness_factor ∂f/∂q − rate_factor ∂f/∂v of these, but for damping by mass.
  void add_other_system(double t, double share, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                        double stiffness_factor, double rate_factor, GeneralBlockTridiagonal<double>& A,
                        const MovedSupports& moved = {}) const;
  /// What variable loads and damping do over a change dq of the coordinates, J, where no support turns; or in
  /// a second with rates as dq, W. `ground_v`: rates of the ground.
  Work other_work(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& ground_v,
                  const Eigen::VectorXd& dq) const;
  /// What these and the motion of supports do in a second, W, at relative q and v; that of supports without
  /// the rate of `carried_momentum`, so that neither accelerations nor forces within the cable are in it
  /// unless the ends move against each other.
  Work power(double t, Eigen::VectorXd q, Eigen::VectorXd v) const;
  /// Momentum along the rates that a body would have which the supports carry along, J; of relative q and v.
  double carried_momentum(double t, Eigen::VectorXd q, Eigen::VectorXd v) const;

  /// f := external minus elastic force; what has no potential and the forces of the supports are not in it.
  /// Returns an element whose slope has collapsed (r'·r' ≤ slope_floor² at an integration point; of a link, λ
  /// ≤ slope_floor), for which f is incomplete; nothing if all is well.
  std::optional<int> force(const Eigen::VectorXd& q, Eigen::VectorXd& f) const;

  /// a := dv/dt, at t (s) and v where not all forces have a potential, else v may be nullptr; consistent with
  /// the supports, and the sums. `scratch` is given the size of q where it is needed. Returns what `force`
  /// does.
  std::optional<int> acceleration(const StageSums& sums, Eigen::VectorXd& a, Eigen::VectorXd& scratch,
                                  double t = 0, const Eigen::VectorXd* v = nullptr) const;

  /// A := mass_factor · M + stiffness_factor · K(q) with K = −∂f/∂q, without supports.
  void system(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor,
              BlockTridiagonal& A) const;

  Energies energies(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const;

  /// For outputs: gives the slopes of a chain and their rates what the links beside them have. The slopes of
  /// a cable stay as they are.
  void set_output_slopes(Eigen::VectorXd& q, Eigen::VectorXd& v) const;

  /// The cable at the fraction s in [0, 1] of its length; a chain is straight between its nodes.
  CablePoint at(const Eigen::VectorXd& q, double s) const;
  /// Interpolates any nodal field (such as v) at s, the way positions are.
  Vec3 interpolate(const Eigen::VectorXd& nodal, double s) const;

 private:
  struct Place {
    int element;
    double x;  // in [0, 1]
  };
  Place place(double s) const;
  /// f := f + the damping of the material, and by mass at rates of the ground.
  void add_damping(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const Eigen::VectorXd& ground_v,
                   Eigen::VectorXd& f) const;
  /// f := f + share times the variable loads at t, in the frame of the supports.
  void add_variable_loads(double t, double share, const MovedSupports& moved, const Eigen::VectorXd& q,
                          Eigen::VectorXd& f) const;

  int elements_;
  bool rigid_;
  Vec3 spin_;
  LoadSum loads_;
  VariableLoads variable_loads_;
  SupportMotion motion_;
  Element element_;
  ElementConstants constants_;
  std::optional<Chain> chain_;
  SupportProjection supports_;
  MassMatrix mass_;
  Damping damping_;
  Eigen::VectorXd external_force_;
};

}  // namespace plumb
