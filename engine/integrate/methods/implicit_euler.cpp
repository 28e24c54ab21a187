#include "engine/integrate/methods/structural_method.h"
#include "engine/integrate/methods/structural_schemes.h"

namespace plumb {

/// Euler's implicit method (Hairer and Wanner 1996, section IV.3), solved to the end in every step:
///   M a = f(qₙ₊₁),  vₙ₊₁ = vₙ + h a,  qₙ₊₁ = qₙ + h vₙ₊₁.
/// An oscillation is damped by 1/√(1 + ω²h²) a step.
StructuralScheme implicit_euler_scheme() {
  return {
      .position_old = 0, .position_new = 1, .velocity_old = 0, .velocity_new = 1, .order = 1, .error = 0.5};
}

MethodEntry implicit_euler_entry() {
  MethodInfo info = structural_info();
  info.name = "implicit-euler";
  info.summary = "Euler's implicit method";
  info.source = "Hairer and Wanner 1996, section IV.3";
  info.order = "1";
  info.use = "to reach a state of rest; damps strongly";
  return {info,
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<StructuralMethod>(implicit_euler_scheme(), spec, dynamics, start);
          }};
}

}  // namespace plumb
