#include "engine/integrate/monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/model/cable.h"

namespace plumb {
namespace {

/// The elements of a node are those before and after it; the one after is named, the last node has only the
/// other.
int element_of(const Cable& cable, Eigen::Index coordinate) {
  return std::min(static_cast<int>(coordinate / 6), cable.elements() - 1);
}

/// The one with the fastest node: what grows without bound is what moves most.
int fastest_element(const Cable& cable, const Eigen::VectorXd& v) {
  Eigen::Index fastest = 0;
  for (Eigen::Index node = 0; node < v.size(); node += 6)
    if (v.segment<3>(node).squaredNorm() > v.segment<3>(fastest).squaredNorm()) fastest = node;
  return element_of(cable, fastest);
}

struct CollapsedSlope {
  int element;
  double length;
};

/// The first slope at or below its floor, of those at the nodes and in the middle of the elements, or along
/// the links of a chain.
std::optional<CollapsedSlope> collapsed_slope(const Cable& cable, const Eigen::VectorXd& q) {
  const double l = cable.element().length();
  if (cable.chain()) {
    for (int e = 0; e < cable.elements(); ++e) {
      const Vec3 d = q.segment<3>(6 * e + 6) - q.segment<3>(6 * e);
      if (!cable.chain()->link().is_whole(d)) return CollapsedSlope{e, d.norm() / l};
    }
    return std::nullopt;
  }
  for (int e = 0; e < cable.elements(); ++e) {
    const auto r0 = q.segment<3>(6 * e), g0 = q.segment<3>(6 * e + 3);
    const auto r1 = q.segment<3>(6 * e + 6), g1 = q.segment<3>(6 * e + 9);
    const Vec3 middle = 1.5 / l * (r1 - r0) - 0.25 * (g0 + g1);
    const double least = std::min({g0.squaredNorm(), middle.squaredNorm(), g1.squaredNorm()});
    if (!(least > slope_floor * slope_floor)) return CollapsedSlope{e, std::sqrt(least)};
  }
  return std::nullopt;
}

}  // namespace

Monitor::Monitor(const Cable& cable, const State& start, double duration, bool energy_bounded)
    : cable_(cable), duration_(duration), energy_bounded_(energy_bounded) {
  const Energies first = cable.energies(start.q, start.v);
  first_energy_ = first.total();
  // A cable that is at rest without load has no energy at hand; round-off must not count as growth.
  const double round_off = 1e-12 * cable.element().axial_stiffness() * cable.length();
  at_hand_ = first.kinetic + first.axial + first.bending + cable.loads().size() * cable.length() + round_off;
  const double speed = cable.motion().greatest_speed(duration);
  at_hand_ += 0.5 * cable.total_mass() * speed * speed;
}

double Monitor::own_time() const {
  const double at_hand = at_hand_ + cable_.variable_loads().size(duration_) * cable_.length();
  return 2 * std::numbers::pi * cable_.length() * std::sqrt(cable_.total_mass() / (2 * at_hand));
}

StepResult Monitor::check(const State& state, const Work& done) const {
  for (const Eigen::VectorXd* x : {&state.q, &state.v}) {
    if (x->allFinite()) continue;
    Eigen::Index at = 0;
    while (std::isfinite((*x)[at])) ++at;
    return {Outcome::diverged, "the state is not finite", element_of(cable_, at)};
  }
  if (const auto collapsed = collapsed_slope(cable_, state.q))
    return {Outcome::singular,
            fmt::format("the slope has collapsed: |r'| = {:.3g} is not above {:g}", collapsed->length,
                        slope_floor),
            collapsed->element};
  // What damping takes can only make it less.
  const double energy = cable_.energies(state.q, state.v).total() - done.supplied;
  if (!std::isfinite(energy)) return {Outcome::diverged, "the energy is not finite", -1};
  const double at_hand = at_hand_ + std::abs(done.supplied);
  if (energy_bounded_ && energy - first_energy_ > energy_growth_limit * at_hand)
    return {Outcome::unstable,
            fmt::format("the energy grew by {:.3g} times what was at hand, the bound is {:g} times",
                        (energy - first_energy_) / at_hand, energy_growth_limit),
            fastest_element(cable_, state.v)};
  return {};
}

}  // namespace plumb
