#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/integrate/equilibria.h"
#include "engine/integrate/vibrations.h"
#include "engine/model/energies.h"

namespace plumb {

/// How an integration ended.
enum class Outcome {
  not_run,
  completed,       ///< to its end, and not held against anything
  accurate,        ///< completed, and within the tolerance of its reference
  inaccurate,      ///< completed with its energy bounded, and beyond that tolerance
  unstable,        ///< the energy grew beyond the stated bound
  diverged,        ///< the state is not finite
  no_convergence,  ///< Newton's iteration or the library's solver gave up
  singular,        ///< the slope of an element collapsed, or the matrix is singular
  /// an equilibrium was found that the cable would leave: its stiffness is not positive definite
  unstable_equilibrium,
  out_of_time,  ///< the time that was allowed for the run is over
};

/// Every outcome, in the order above.
std::span<const Outcome> outcomes();
inline std::span<const Outcome> enum_values(Outcome) {
  return outcomes();
}
/// The outcome of that word. Throws std::runtime_error for another one.
Outcome outcome_named(const std::string& name);

/// "not-run", "completed", "accurate", "inaccurate", "unstable", "diverged", "no-convergence", "singular",
/// "unstable-equilibrium", "out-of-time".
std::string_view word(Outcome);

/// What an integration cost. -1: not counted, or not run.
struct Counters {
  long steps = -1;
  long rejected_steps = -1;  ///< tried and repeated shorter by an error-controlled method
  long force_evaluations = -1;
  long tangent_evaluations = -1;
  long factorizations = -1;  ///< of the block banded matrix
  long newton_iterations = -1;
};

/// What an integration gave, up to where it ended.
struct Trajectory {
  Outcome outcome = Outcome::not_run;
  /// For an outcome other than completed: method, time, step, element, what happened and what would help.
  std::string message;
  int elements = 0;
  double element_length = 0;  ///< l, m
  double end_time = 0;        ///< time reached, s

  /// One entry an output, all of the same length; times strictly increasing from 0.
  std::vector<double> times;       ///< s
  std::vector<Eigen::VectorXd> q;  ///< per node r (m) and r' (1), 6(N + 1) numbers
  std::vector<Eigen::VectorXd> v;  ///< their rates, m/s and 1/s
  std::vector<Energies> energies;
  /// λ, the forces of the joints on the cable, N, and N m for held slopes (SupportConstraints); one an
  /// output, or none where the method does not carry the supports as constraints.
  std::vector<Eigen::VectorXd> multipliers;
  /// Greatest |G (q − q₀)| over the outputs of such a method: m, a held slope counting as one of the cable's
  /// length. -1 for others.
  double constraint_drift = -1;
  /// The shortest step that was taken after a longer one had been rejected, s. -1: none was.
  double shortest_cut = -1;
  /// The earliest output at which the cable has kept to its straight line and would leave it at the least
  /// disturbance, s. -1: there is none.
  double unstable_since = -1;
  int interpolated_outputs = 0;  ///< outputs between two steps, interpolated rather than stepped to
  Equilibria equilibria;         ///< of statics
  Vibrations vibrations;         ///< of modes

  Counters counters;
  double solve_seconds = -1;      ///< the time loop alone
  double processor_seconds = -1;  ///< the same, of the processor
  /// What the time loop would have taken up to the next time that mattered, s of the processor, where it was
  /// ended for that. -1: it was not.
  double foreseen_seconds = -1;

  /// What must be known of the motion beside its outcome: "unstable start: …"; empty: nothing.
  std::string remark() const;
  /// Greatest |E(t) − E(0)| over the outputs, J.
  double energy_drift() const;
  /// What the drift is held against: the first kinetic energy, or the greatest for a start from rest, J.
  double kinetic_scale() const;
  /// What of a drift rounding alone may make, J: of each step some units in the last place of all energies,
  /// which add up as those of a random walk do.
  double energy_round_off() const;
  /// energy_drift / kinetic_scale; 0 where nothing moved, -1 where it cannot be told (no outputs, not
  /// finite).
  double relative_energy_drift() const;
};

}  // namespace plumb
