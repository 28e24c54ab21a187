#include "engine/integrate/methods/loaded_cable.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

/// Change of a slope in a correction beyond which no way leads back.
constexpr double most_overshoot = 10;
/// A correction this many lengths of the cable long is one by the round-off of a singular matrix.
constexpr double singular_correction = 1e10;

/// Greatest component of a load across the axis, as a share of its greatest one.
double share_across(const Eigen::VectorXd& load, const Vec3& axis) {
  double across = 0;
  for (Eigen::Index at = 0; at < load.size(); at += 3)
    across = std::max(across, axis.cross(load.segment<3>(at)).norm());
  return across > 0 ? across / load.lpNorm<Eigen::Infinity>() : 0;
}

}  // namespace

double greatest_turn(const Eigen::VectorXd& dq, double element_length) {
  double greatest = 0;
  for (Eigen::Index at = 0; at < dq.size(); at += 6) {
    greatest = std::max(greatest, dq.segment<3>(at + 3).norm());
    if (at > 0)
      greatest = std::max(greatest, (dq.segment<3>(at) - dq.segment<3>(at - 6)).norm() / element_length);
  }
  return greatest;
}

LoadedCable::LoadedCable(Dynamics& dynamics, const Eigen::VectorXd& start, double tolerance)
    : dynamics_(dynamics),
      start_(start),
      load_(dynamics.cable().external_force()),
      bias_(Eigen::VectorXd::Zero(start.size())),
      tolerance_(tolerance) {
  const Cable& the_cable = cable();
  the_cable.supports().apply(load_);
  const double EA = the_cable.element().axial_stiffness(), EI = the_cable.element().bending_stiffness();
  const double l = the_cable.element().length();
  residual_floor_ = 16 * std::numeric_limits<double>::epsilon() * the_cable.elements() * (EA + EI / (l * l));
  const Vec3& axis = the_cable.supports().direction();
  Eigen::VectorXd bent = start_;
  for (Eigen::Index i = 0; i < bent.size(); i += 3) {
    const Vec3 along = axis.dot(bent.segment<3>(i)) * axis;
    bent.segment<3>(i) -= along;
  }
  constexpr double straight = 1e-14;  // of the length, by round-off
  const bool is_bent = greatest_displacement(bent) > straight * the_cable.length();
  if (is_bent) {
    BlockTridiagonal K(the_cable.nodes());
    the_cable.system(start_ - bent, 0, 1, K);
    K.multiply(bent, bias_);
    the_cable.supports().apply(bias_);
  }
  // The stiffness against a turn that less makes is lost in round-off; to which side the cable goes is not.
  constexpr double as_good_as_none = 1e-7, round_off = 1e-14;
  const double across = share_across(load_, axis);
  const bool more = !the_cable.variable_loads().empty() || !the_cable.motion().none();
  is_symmetric_ = !is_bent && !more && across <= as_good_as_none;
  has_a_side_ = is_bent || more || across > round_off;
}

std::optional<int> LoadedCable::residual(const Eigen::VectorXd& q, double share, Eigen::VectorXd& result) {
  dynamics_.force(q, result, at(share));
  result += bias_;
  return dynamics_.take_collapsed();
}

std::optional<int> LoadedCable::factor(const Eigen::VectorXd& q, double share) {
  constexpr double least_bend = 1e-5;
  turn_.resize(0);
  if (!is_symmetric_) return dynamics_.factor(q, 0, 1, at(share));
  const Vec3& axis = cable().supports().direction();
  turn_.resize(q.size());
  for (Eigen::Index at = 0; at < q.size(); at += 3) turn_.segment<3>(at) = axis.cross(q.segment<3>(at));
  const double size = norm(turn_);
  if (size < least_bend) {
    turn_.resize(0);
    return dynamics_.factor(q, 0, 1, at(share));
  }
  turn_ /= size;
  int farthest = 0;
  for (int node = 0; node < cable().nodes(); ++node)
    if (turn_.segment<3>(6 * node).norm() > turn_.segment<3>(6 * farthest).norm()) farthest = node;
  const double stiffness = cable().element().axial_stiffness() / cable().element().length();
  return dynamics_.factor(
      q, NodeSpring{farthest, std::sqrt(stiffness) * turn_.segment<3>(6 * farthest).normalized()});
}

void LoadedCable::take_out_turn(Eigen::VectorXd& x) const {
  if (turn_.size() > 0) x -= dot(turn_, x) * turn_;
}

void LoadedCable::solve(Eigen::VectorXd& x) const {
  dynamics_.solve(x);
  take_out_turn(x);
}

double LoadedCable::share_of_round_off(const Eigen::VectorXd& q, const Eigen::VectorXd& force) const {
  Eigen::VectorXd moved = force, left;
  solve(moved);
  BlockTridiagonal K(cable().nodes());
  cable().system(q, 0, 1, K);
  cable().supports().apply(K);
  K.multiply(moved, left);
  left = force - left;
  solve(left);
  const double size = norm(moved);
  return size > 0 ? norm(left) / size : 0;
}

StepResult LoadedCable::settle(Eigen::VectorXd& q, double share, int iterations) {
  const double l = cable().element().length();
  CorrectionSize correction;
  if (const auto element = residual(q, share, residual_)) return collapsed(*element);
  double last = 0;
  for (int i = 0; i < iterations; ++i) {
    if (const auto node = factor(q)) return singular(*node);
    if (i > 0 && has_converged(correction.metres, last, residual_, share, tolerance_)) return {};
    last = i > 0 ? correction.metres : std::numeric_limits<double>::infinity();
    change_ = residual_;
    solve(change_);
    ++dynamics_.counters.newton_iterations;
    correction = correction_size(change_, 1, l);
    if (!(correction.metres <= singular_correction * cable().length())) return singular(correction.element);
    if (greatest_turn(change_, l) > most_overshoot) break;
    q += change_;
    if (const auto element = residual(q, share, residual_)) return collapsed(*element);
  }
  return not_converged(correction, tolerance_, cable().length());
}

bool LoadedCable::has_converged(double correction, double last, const Eigen::VectorXd& residual, double share,
                                double tolerance) const {
  constexpr double share_of_load = 1e-6;
  const double left = greatest(residual);
  if (correction > tolerance) return correction >= 0.5 * last && left <= residual_floor_;
  return left <= residual_floor_ + share_of_load * std::abs(share) * cable().loads().size();
}

double LoadedCable::greatest(const Eigen::VectorXd& residual) const {
  const double l = cable().element().length();
  double greatest = 0;
  for (Eigen::Index at = 0; at < residual.size(); at += 6)
    greatest = std::max({greatest, residual.segment<3>(at).norm(), residual.segment<3>(at + 3).norm() / l});
  return greatest;
}

double LoadedCable::potential(const Eigen::VectorXd& q, double share) const {
  const Energies energies = cable().energies(q, Eigen::VectorXd::Zero(q.size()));
  // Of the way from the start, which is short beside the distance from the origin.
  return energies.axial + energies.bending - (share * load_ + bias_).dot(q - start_);
}

double LoadedCable::dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  const double L = cable().length();
  double displacements = 0, slopes = 0;
  for (Eigen::Index at = 0; at < a.size(); at += 6) {
    displacements += a.segment<3>(at).dot(b.segment<3>(at));
    slopes += a.segment<3>(at + 3).dot(b.segment<3>(at + 3));
  }
  return (displacements / (L * L) + slopes) / cable().nodes();
}

double LoadedCable::displacement(const Eigen::VectorXd& q) const {
  return greatest_displacement(q - start_);
}

bool LoadedCable::is_reversed(const Eigen::VectorXd& before, const Eigen::VectorXd& q) {
  for (Eigen::Index at = 6; at < q.size(); at += 6) {
    const Vec3 was = before.segment<3>(at) - before.segment<3>(at - 6);
    if (was.dot(q.segment<3>(at) - q.segment<3>(at - 6)) <= 0) return true;
  }
  return false;
}

StepResult LoadedCable::singular(int node) const {
  return {Outcome::singular,
          "the stiffness is singular: nothing but inertia would hold the cable, as across a straight and "
          "unstretched one without bending stiffness or of one that can turn about its support",
          std::min(node, cable().elements() - 1)};
}

StepResult LoadedCable::collapsed(int element) {
  return {Outcome::singular, "the slope collapsed within Newton's iteration", element};
}

}  // namespace plumb
