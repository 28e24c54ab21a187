#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/case/case.h"
#include "engine/integrate/dynamics.h"
#include "engine/integrate/method_info.h"
#include "engine/integrate/state.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// How one step went.
struct StepResult {
  Outcome outcome = Outcome::completed;
  std::string reason;  ///< what happened, for an outcome other than completed
  int element = -1;    ///< where, if known

  bool ok() const { return outcome == Outcome::completed; }
};

/// A time integrator at work on one run: it starts at a state and takes one step after another.
class Method {
 public:
  virtual ~Method() = default;

  /// Takes one step, fixed or of a size of its own choice, but not beyond `stop` (s). After a failure the
  /// state is that before the step.
  virtual StepResult step(double stop) = 0;

  /// The state after the last step.
  virtual const State& state() const = 0;

  /// The state at t (s) within the last step, by the interpolation that suits the method.
  virtual void interpolate(double t, State& at) const = 0;

  /// Whether the state that `interpolate` gave last may be shown; where not, why.
  virtual StepResult interpolated() const { return {}; }

  /// Negative eigenvalues of the stiffness at t (s), that of the state or of the one that was interpolated
  /// last, -1 where they cannot be counted; nothing of a method that looks for no equilibria.
  virtual std::optional<int> negative_eigenvalues(double /*t*/) const { return std::nullopt; }

  /// What is to be said of a run that came to its end, where that is not `completed`.
  virtual StepResult conclusion() const { return {}; }

  /// Adds what the method alone knows of the whole run, however it ended.
  virtual void add_to(Trajectory& /*trajectory*/) const {}

  /// True where a step should end on every output time because interpolation would cost accuracy.
  virtual bool stops_at_outputs() const { return false; }

  /// Sets `lambda` to the multipliers of the constraints (SupportConstraints) at t (s), within the last step
  /// or at the state; to nothing for a method without them.
  virtual void constraint_forces(double /*t*/, Eigen::VectorXd& lambda) const { lambda.resize(0); }

  /// What has no potential has done in the last step, as the method itself counts it; nothing: as its states
  /// say.
  virtual std::optional<Work> work() const { return std::nullopt; }

  /// Steps tried and repeated shorter.
  virtual long rejected_steps() const { return 0; }
};

/// Makes a method. `dynamics` must outlive it; `spec` holds all its parameters, checked.
using MakeMethod = std::unique_ptr<Method> (*)(const MethodSpec& spec, Dynamics& dynamics,
                                               const State& start);

/// The MakeMethod of a class.
template <class M>
std::unique_ptr<Method> made(const MethodSpec& spec, Dynamics& dynamics, const State& start) {
  return std::make_unique<M>(spec, dynamics, start);
}

/// A method's description and how to make it. Each method defines one of these in its own file.
struct MethodEntry {
  MethodInfo info;
  MakeMethod make;
  MakeMethod make_rigid = nullptr;  ///< for a rigid rod (CableModel::rigid), where the method takes one
};

/// Whether a method can integrate what acts on a cable, as takes(info, spec).
bool takes(const MethodInfo& info, const Cable& cable);

/// Makes the method that `spec` names, for a rigid rod where the cable is one. Throws std::invalid_argument
/// for an unknown name, and for a method that does not take the cable.
std::unique_ptr<Method> make_method(const MethodSpec& spec, Dynamics& dynamics, const State& start);

}  // namespace plumb
