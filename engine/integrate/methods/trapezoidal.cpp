#include "engine/integrate/methods/structural_method.h"
#include "engine/integrate/methods/structural_schemes.h"

namespace plumb {

/// The trapezoidal rule: Newmark's method (1959) with β = ¼ and γ = ½,
///   M aₙ₊₁ = f(qₙ₊₁),  qₙ₊₁ = qₙ + h vₙ + ¼h² (aₙ + aₙ₊₁),  vₙ₊₁ = vₙ + ½h (aₙ + aₙ₊₁).
/// It keeps the energy of every linear oscillation, and of no nonlinear one.
StructuralScheme trapezoidal_scheme() {
  return newmark(0.25, 0.5);
}

MethodEntry trapezoidal_entry() {
  MethodInfo info = structural_info();
  info.name = "trapezoidal";
  info.summary = "trapezoidal rule: Newmark with β = 1/4, γ = 1/2";
  info.source = "Newmark 1959";
  info.use = "short runs with small steps; it can gain energy without bound on stiff cables";
  return {info,
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<StructuralMethod>(trapezoidal_scheme(), spec, dynamics, start);
          }};
}

}  // namespace plumb
