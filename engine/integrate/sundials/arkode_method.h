#pragma once

#include <optional>

#include "engine/integrate/fixed_steps.h"
#include "engine/integrate/sundials/library_method.h"

namespace plumb::sundials {

/// What ARKODE's one-step methods share (Reynolds et al. 2023). They take either a fixed step, so that the
/// n-th step ends at n h and only the one that ends the run may be shorter, or tolerances; controlled steps
/// end on the output times, as the library's interpolation is of lower order than its pairs.
class ArkodeMethod : public LibraryMethod {
 public:
  ArkodeMethod(const MethodSpec& spec, Dynamics& dynamics, const State& start);

  bool stops_at_outputs() const final { return !steps_; }

 protected:
  bool has_fixed_step() const { return steps_.has_value(); }

  /// Asks the library for the next step to be of size h (s), whatever its error.
  virtual void fix_step(double h) = 0;
  /// Asks the library for a step of its own choice that ends at `stop` (s) at the latest.
  virtual void stop_at(double stop) = 0;
  /// Takes a step in the direction of `stop`; sets `reached` and returns the library's flag.
  virtual int take_step(double stop, double& reached) = 0;

 private:
  int evolve(double stop, double& reached) final;

  std::optional<FixedSteps> steps_;
};

}  // namespace plumb::sundials
