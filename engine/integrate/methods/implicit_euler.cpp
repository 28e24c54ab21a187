#include "engine/integrate/methods/structural_method.h"

namespace plumb {
namespace {

/// Euler's implicit method (Hairer and Wanner 1996, section IV.3), solved to the end in every step:
///   M a = f(qₙ₊₁),  vₙ₊₁ = vₙ + h a,  qₙ₊₁ = qₙ + h vₙ₊₁.
/// An oscillation is damped by 1/√(1 + ω²h²) a step.
constexpr auto implicit_euler_scheme = [](const MethodSpec&) -> StructuralScheme {
  return {
      .position_old = 0, .position_new = 1, .velocity_old = 0, .velocity_new = 1, .order = 1, .error = 0.5};
};

}  // namespace

MethodEntry implicit_euler_entry() {
  MethodInfo info = structural_info(implicit_euler_scheme);
  info.name = "implicit-euler";
  info.summary = "Euler's implicit method";
  info.source = "Hairer and Wanner 1996, section IV.3";
  info.order = "1";
  info.rtol = 1e-2;
  info.use = "to reach a state of rest; damps strongly";
  return structural_entry(info, implicit_euler_scheme);
}

}  // namespace plumb
