#include "engine/model/cable.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/model/buckling.h"
#include "engine/model/cross_matrix.h"
#include "engine/model/hermite.h"

namespace plumb {

Cable::Cable(const Case& spec)
    : elements_(spec.cable.elements),
      rigid_(spec.cable.model == CableModel::rigid),
      spin_(spec.start.angular_velocity),
      loads_(loads_of(spec)),
      variable_loads_(spec),
      motion_(spec),
      element_(spec.cable.youngs_modulus * spec.cable.area,
               spec.cable.youngs_modulus * spec.cable.second_moment, spec.cable.length / spec.cable.elements,
               spec.cable.strain),
      constants_{element_.axial_stiffness(),
                 element_.bending_stiffness(),
                 element_.length(),
                 spec.cable.density * spec.cable.area,
                 {loads_.per_mass().x(), loads_.per_mass().y(), loads_.per_mass().z()},
                 spec.cable.strain == StrainModel::green_geometric,
                 spec.cable.quadrature == QuadratureRule::full,
                 spec.cable.lumped || spec.cable.model == CableModel::chain,
                 spec.cable.model == CableModel::chain},
      chain_(spec.cable.model == CableModel::chain ? std::optional<Chain>(constants_) : std::nullopt),
      supports_(spec.supports, spec.start.direction, spec.cable.elements + 1, spec.cable.model),
      mass_(constants_, elements_, supports_, point_masses(spec)),
      damping_(spec.damping, constants_, elements_) {
  // A uniform force on all mass is a field that the element can represent, so ∫ ρA sᵢ g dx = M g exactly.
  Eigen::VectorXd uniform = Eigen::VectorXd::Zero(size());
  for (int node = 0; node < nodes(); ++node) uniform.segment<3>(6 * node) = loads_.per_mass();
  external_force_.resize(size());
  best_kernels().mass_multiply(constants_, elements_, uniform.data(), external_force_.data());
  loads_.on_nodes().add_to(external_force_.data());
}

Cable Cable::in_units(const OwnUnits& units) const {
  Cable result(*this);
  result.spin_ *= units.time;
  ElementConstants& c = result.constants_;
  c.axial_stiffness /= units.force();
  c.bending_stiffness /= units.moment() * units.length;
  c.length /= units.length;
  c.mass_per_length /= units.mass / units.length;
  const double per_mass = units.force() / units.mass;
  for (double& component : c.per_mass) component /= per_mass;
  result.element_ = Element(c.axial_stiffness, c.bending_stiffness, c.length, element_.strain_model());
  result.loads_ = loads_.in_units(units);
  result.variable_loads_ = variable_loads_.in_units(units);
  result.motion_ = motion_.in_units(units);
  if (chain_) result.chain_.emplace(c);
  result.mass_ = MassMatrix(c, elements_, supports_, plumb::in_units(mass_.points(), units));
  result.damping_ = damping_.in_units(units, c);
  scale_nodal(1 / units.force(), 1 / units.moment(), result.external_force_);
  return result;
}

Eigen::VectorXd Cable::start_q(const StartSpec& start) const {
  Eigen::VectorXd q(size());
  for (int node = 0; node < nodes(); ++node) {
    q.segment<3>(6 * node) = start.stretch * (element_.length() * node * start.direction);
    q.segment<3>(6 * node + 3) = start.stretch * start.direction;
  }
  if (start.imperfection != 0)
    if (const auto buckling = first_buckling(*this, q)) q += start.imperfection * buckling->shape;
  return q;
}

Eigen::VectorXd Cable::start_v(const StartSpec& start) const {
  const Vec3 turn = start.stretch * start.angular_velocity.cross(start.direction);
  Eigen::VectorXd v(size());
  for (int node = 0; node < nodes(); ++node) {
    v.segment<3>(6 * node) = element_.length() * node * turn;
    v.segment<3>(6 * node + 3) = start.slope_rates == SlopeRates::rigid ? turn : Vec3::Zero();
    // u(s) = sin(πs/2) and its derivative along the cable.
    const double phase = 0.5 * std::numbers::pi * node / elements_;
    v.segment<3>(6 * node) += start.axial_speed * std::sin(phase) * start.direction;
    v.segment<3>(6 * node + 3) +=
        start.axial_speed * (0.5 * std::numbers::pi / length()) * std::cos(phase) * start.direction;
  }
  supports_.apply(v);
  if (motion_.none()) return v;
  // What is held goes with its support from the first instant on.
  Eigen::VectorXd held = Eigen::VectorXd::Zero(size()), q = start_q(start);
  motion_.at(0).to_ground(q, held);
  v += held;
  supports_.apply(held);
  return v - held;
}

std::optional<int> Cable::force(const Eigen::VectorXd& q, Eigen::VectorXd& f) const {
  f.resize(q.size());
  if (chain_) {
    f = external_force_;
    return chain_->subtract_gradient(q, f);
  }
  const int collapsed = best_kernels().force(constants_, elements_, q.data(), f.data());
  loads_.on_nodes().add_to(f.data());
  return collapsed < 0 ? std::nullopt : std::optional(collapsed);
}

std::optional<int> Cable::acceleration(const StageSums& sums, Eigen::VectorXd& a, Eigen::VectorXd& scratch,
                                       double t, const Eigen::VectorXd* v) const {
  a.resize(size());
  const Kernels& kernels = best_kernels();
  if (const MassFactors* factors = mass_.factors(); factors != nullptr && !chain_ && conservative()) {
    const int collapsed =
        kernels.acceleration(constants_, elements_, *factors, loads_.on_nodes(), sums, a.data());
    return collapsed < 0 ? std::nullopt : std::optional(collapsed);
  }
  scratch.resize(size());
  kernels.add_up(nodes(), sums.before);
  Sum q = sums.q;
  kernels.add_up(nodes(), q.into(scratch));
  if (sums.q.result != nullptr) std::copy(scratch.begin(), scratch.end(), sums.q.result);
  std::optional<int> collapsed;
  if (motion_.none()) {
    collapsed = force(scratch, a);
    if (!conservative()) add_other_forces(t, 1, scratch, *v, a);
  } else {
    const MovedSupports moved = motion_.at(t);
    Eigen::VectorXd rates = *v;
    moved.add_last(scratch);
    moved.add_last_rate(rates);
    collapsed = force(scratch, a);
    add_other_forces(t, 1, scratch, rates, a, moved);
  }
  // What acts on held coordinates has no effect on the others, and none on itself.
  mass_.solve(a, scratch);
  kernels.add_up(nodes(), sums.after);
  return collapsed;
}

void Cable::add_variable_loads(double t, double share, const MovedSupports& moved, const Eigen::VectorXd& q,
                               Eigen::VectorXd& f) const {
  if (variable_loads_.empty()) return;
  if (!motion_.turns()) return variable_loads_.add_force(t, share, q, f);
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(size()), ground_q = q;
  turn_vectors(moved.turn, ground_q);
  variable_loads_.add_force(t, share, ground_q, loads);
  turn_vectors(moved.turn.transpose(), loads);
  f += loads;
}

void Cable::add_other_forces(double t, double share, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                             Eigen::VectorXd& f, const MovedSupports& moved) const {
  add_variable_loads(t, share, moved, q, f);
  if (motion_.none()) return add_damping(q, v, v, f);
  if (motion_.turns()) {
    Eigen::VectorXd constant = share * external_force_;
    f -= constant;
    turn_vectors(moved.turn.transpose(), constant);
    f += constant;
  }
  add_damping(q, v, moved.ground_rates(q, v), f);
  Eigen::VectorXd inertia;
  mass_.multiply(moved.accelerations(q, v), inertia);
  f -= inertia;
}

void Cable::add_damping(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const Eigen::VectorXd& ground_v,
                        Eigen::VectorXd& f) const {
  damping_.add_force(q, v, f);
  if (damping_.by_mass() == 0) return;
  Eigen::VectorXd momentum;
  mass_.multiply(ground_v, momentum);
  f -= damping_.by_mass() * momentum;
}

void Cable::add_rate_forces(const Eigen::VectorXd& q, const Eigen::VectorXd& b, Eigen::VectorXd& f,
                            const MovedSupports& moved) const {
  // The forces of damping are linear in the rates.
  add_damping(q, b, b, f);
  if (!motion_.turns()) return;
  MovedSupports turning;
  turning.spin = moved.spin;
  Eigen::VectorXd inertia;
  mass_.multiply(turning.accelerations(Eigen::VectorXd::Zero(size()), b), inertia);
  f -= inertia;
}

void Cable::add_other_system(double t, double share, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                             double stiffness_factor, double rate_factor, GeneralBlockTridiagonal<double>& A,
                             const MovedSupports& moved) const {
  damping_.add_system(q, v, stiffness_factor, rate_factor, A);
  if (!motion_.turns()) return variable_loads_.add_stiffness(t, share, q, stiffness_factor, A);
  Eigen::VectorXd ground_q = q;
  turn_vectors(moved.turn, ground_q);
  GeneralBlockTridiagonal<double> of_loads(nodes());
  variable_loads_.add_stiffness(t, share, ground_q, stiffness_factor, of_loads);
  add_turned(of_loads, moved.turn.transpose(), moved.turn, A);
  using Matrix3 = Eigen::Matrix3d;
  BlockTridiagonal mass(nodes());
  system(q, 1, 0, mass);
  const Matrix3 spin = cross_matrix(moved.spin), spin_rate = cross_matrix(moved.spin_rate);
  add_turned(
      GeneralBlockTridiagonal<double>(mass), Matrix3::Identity(),
      stiffness_factor * (spin_rate + spin * spin + damping_.by_mass() * spin) + 2 * rate_factor * spin, A);
}

Work Cable::other_work(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& ground_v,
                       const Eigen::VectorXd& dq) const {
  Eigen::VectorXd of_loads = Eigen::VectorXd::Zero(size()), of_damping = of_loads;
  variable_loads_.add_force(t, 1, q, of_loads);
  add_damping(q, ground_v, ground_v, of_damping);
  return {of_loads.dot(dq), -of_damping.dot(dq)};
}

Work Cable::power(double t, Eigen::VectorXd q, Eigen::VectorXd v) const {
  if (motion_.none()) return other_work(t, q, v, v);
  const MovedSupports moved = motion_.at(t);
  moved.add_last(q);
  moved.add_last_rate(v);
  const Eigen::VectorXd ground_v = moved.ground_rates(q, v), carried = moved.carried_rates(q);
  Eigen::VectorXd of_loads = Eigen::VectorXd::Zero(size()), of_damping = of_loads, momentum, scratch;
  add_variable_loads(t, 1, moved, q, of_loads);
  add_damping(q, v, ground_v, of_damping);
  mass_.multiply(ground_v, momentum);
  Work result{of_loads.dot(ground_v), -of_damping.dot(ground_v)};
  // Forces within the cable do nothing on a body, so that what supports do on the carried one is d/dt of its
  // rates · momentum, less the change of these rates · momentum and what the loads do on it.
  Eigen::VectorXd constant = external_force_;
  turn_vectors(moved.turn.transpose(), constant);
  result.supplied -= moved.carried_accelerations(q, v).dot(momentum) +
                     carried.dot(constant + of_loads - damping_.by_mass() * momentum);
  if (moved.last_rate.isZero(0)) return result;
  // What the last end is moved against that takes its reaction.
  Eigen::VectorXd f, inertia;
  force(q, f);
  add_other_forces(t, 1, q, v, f, moved);
  Eigen::VectorXd a = f;
  mass_.solve(a, scratch);
  mass_.multiply(a, inertia);
  const Vec3 reaction = (inertia - f).segment<3>(size() - 6);
  result.supplied += reaction.dot(moved.last_rate);
  return result;
}

double Cable::carried_momentum(double t, Eigen::VectorXd q, Eigen::VectorXd v) const {
  const MovedSupports moved = motion_.at(t);
  moved.add_last(q);
  moved.add_last_rate(v);
  Eigen::VectorXd momentum;
  mass_.multiply(moved.ground_rates(q, v), momentum);
  return moved.carried_rates(q).dot(momentum);
}

void Cable::system(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor,
                   BlockTridiagonal& A) const {
  if (chain_)
    chain_->system(q, mass_factor, stiffness_factor, A);
  else
    best_kernels().system(constants_, mass_factor, stiffness_factor, elements_, q.data(), A.data());
  mass_.add_points(mass_factor, A);
}

Energies Cable::energies(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
  Energies result;
  if (chain_) {
    result.kinetic = chain_->kinetic_energy(v) + mass_.kinetic_energy_of_points(v);
    result.axial = chain_->strain_energy(q);
  } else {
    result.kinetic = mass_.kinetic_energy(v);
    best_kernels().energy(constants_, elements_, q.data(), &result.axial, &result.bending);
  }
  result.potential = -external_force_.dot(q);
  return result;
}

void Cable::set_output_slopes(Eigen::VectorXd& q, Eigen::VectorXd& v) const {
  if (!chain_) return;
  chain_->set_slopes(q);
  chain_->set_slopes(v);
}

Cable::Place Cable::place(double s) const {
  const double along = s * elements_;
  const int element = std::clamp(static_cast<int>(along), 0, elements_ - 1);
  return {element, along - element};
}

CablePoint Cable::at(const Eigen::VectorXd& q, double s) const {
  const auto [element, x] = place(s);
  const double l = element_.length();
  if (chain_) {
    const Vec3 r0 = q.segment<3>(6 * element), r1 = q.segment<3>(6 * element + 6);
    return {(1 - x) * r0 + x * r1, (r1 - r0) / l, Vec3::Zero()};
  }
  const auto combine = [&, e = element](const std::array<double, 4>& shape) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 4; ++i) sum += shape[static_cast<std::size_t>(i)] * q.segment<3>(6 * e + 3 * i);
    return sum;
  };
  return {combine(Hermite::values(x, l)), combine(Hermite::slopes(x, l)), combine(Hermite::curvatures(x, l))};
}

Vec3 Cable::interpolate(const Eigen::VectorXd& nodal, double s) const {
  return at(nodal, s).position;
}

}  // namespace plumb
