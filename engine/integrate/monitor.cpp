#include "engine/integrate/monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

/// The elements of a node are those before and after it; the one after is named, the last node has only the
/// other.
int element_of(const Cable& cable, Eigen::Index coordinate) {
  return std::min(static_cast<int>(coordinate / 6), cable.elements() - 1);
}

}  // namespace

Monitor::Monitor(const Cable& cable, const State& start) : cable_(cable) {
  const Energies first = cable.energies(start.q, start.v);
  first_energy_ = first.total();
  // A cable that is at rest without gravity has no energy at hand; round-off must not count as growth.
  const double round_off = 1e-12 * cable.element().axial_stiffness() * cable.length();
  at_hand_ = first.kinetic + first.axial + first.bending + cable.weight() * cable.length() + round_off;
}

StepResult Monitor::check(const State& state) const {
  for (const Eigen::VectorXd* x : {&state.q, &state.v}) {
    if (x->allFinite()) continue;
    Eigen::Index at = 0;
    while (std::isfinite((*x)[at])) ++at;
    return {Outcome::diverged, "the state is not finite", element_of(cable_, at)};
  }
  for (int node = 0; node < cable_.nodes(); ++node) {
    const double slope = state.q.segment<3>(6 * node + 3).norm();
    if (slope > slope_floor) continue;
    return {Outcome::singular,
            fmt::format("the slope has collapsed: |r'| = {:.3g} is not above {:g}", slope, slope_floor),
            element_of(cable_, 6 * node)};
  }
  const double energy = cable_.energies(state.q, state.v).total();
  if (!std::isfinite(energy)) return {Outcome::diverged, "the energy is not finite", -1};
  if (energy - first_energy_ > energy_growth_limit * at_hand_)
    return {Outcome::unstable,
            fmt::format("the energy grew by {:.3g} J, more than {:g} times the {:.3g} J at hand",
                        energy - first_energy_, energy_growth_limit, at_hand_),
            -1};
  return {};
}

}  // namespace plumb
