#pragma once

#include "engine/integrate/method.h"

namespace plumb {

/// The energy may grow by no more than this many times the energies at hand before a run counts as unstable.
/// Beyond what loads without a potential have put in, a cable keeps its energy or loses some, so any growth
/// is an error; with half as much again as there was, speeds and strains are off by a fifth or more and
/// growing. One and a half times the first energy is also the mark by which runs of the stiff spring pendulum
/// (Kuhl and Crisfield 1999) are told to be unstable.
inline constexpr double energy_growth_limit = 0.5;

/// Looks at the state after each step and says whether it can still be believed.
class Monitor {
 public:
  /// Of a run of that duration, s, from a start in coordinates of the ground.
  /// `energy_bounded`: false for a load that grows, whose work the energy holds.
  /// The energies at hand: first kinetic and strain energy, what the loads can release, their size × length,
  /// and the kinetic energy at the greatest speed of supports; to these comes what others have done.
  Monitor(const Cable& cable, const State& start, double duration, bool energy_bounded = true);

  /// `completed` if the state is finite, no slope has collapsed and the energy is within its bound, if it has
  /// one.
  /// `done`: what has no potential has done so far.
  StepResult check(const State& state, const Work& done = {}) const;

  double energies_at_hand() const { return at_hand_; }  ///< J
  /// RunTimes::own.
  double own_time() const;

 private:
  const Cable& cable_;
  double duration_;  // s
  bool energy_bounded_;
  double first_energy_;  // J
  double at_hand_;       // J
};

}  // namespace plumb
