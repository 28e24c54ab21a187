#include "engine/integrate/methods/structural_method.h"
#include "engine/integrate/methods/structural_schemes.h"

namespace plumb {

/// The implicit midpoint rule (Hairer, Lubich and Wanner 2006, section II.1), the Gauss method of one stage:
///   M a = f(½ (qₙ + qₙ₊₁)),  qₙ₊₁ = qₙ + h vₙ + ½h² a,  vₙ₊₁ = vₙ + h a.
/// It is symplectic and keeps the energy of every linear oscillation.
StructuralScheme implicit_midpoint_scheme() {
  return {.position_old = 0,
          .position_new = 0.5,
          .velocity_old = 0,
          .velocity_new = 1,
          .point = 0.5,
          .time = 0.5,
          .error = 1.0 / 12};
}

MethodEntry implicit_midpoint_entry() {
  MethodInfo info = structural_info();
  info.name = "implicit-midpoint";
  info.summary = "implicit midpoint rule: the Gauss method of one stage";
  info.source = "Hairer, Lubich and Wanner 2006, section II.1";
  info.conserves = "momentum, angular momentum; symplectic at a fixed step";
  info.use = "long runs with small steps whose energy must not drift";
  return {info,
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<StructuralMethod>(implicit_midpoint_scheme(), spec, dynamics, start);
          }};
}

}  // namespace plumb
