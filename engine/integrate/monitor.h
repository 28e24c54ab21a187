#pragma once

#include "engine/integrate/method.h"

namespace plumb {

/// The energy may grow by no more than this many times the energies at hand before a run counts as unstable.
/// A cable without drive keeps its energy, so any growth is an error; one as large as all there was leaves
/// nothing to trust.
inline constexpr double energy_growth_limit = 1;

/// Looks at the state after each step and says whether it can still be believed.
class Monitor {
 public:
  /// The energies at hand: first kinetic and strain energy, and what gravity and the end force
  /// can release, (weight + force) × length.
  Monitor(const Cable& cable, const State& start);

  /// `completed` if the state is finite, no slope has collapsed and the energy is within its bound.
  StepResult check(const State& state) const;

  double energies_at_hand() const { return at_hand_; }  ///< J

 private:
  const Cable& cable_;
  double first_energy_;  // J
  double at_hand_;       // J
};

}  // namespace plumb
