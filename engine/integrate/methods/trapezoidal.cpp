#include "engine/integrate/methods/structural_method.h"

namespace plumb {
namespace {

/// The trapezoidal rule: Newmark's method (1959) with β = ¼ and γ = ½,
///   M aₙ₊₁ = f(qₙ₊₁),  qₙ₊₁ = qₙ + h vₙ + ¼h² (aₙ + aₙ₊₁),  vₙ₊₁ = vₙ + ½h (aₙ + aₙ₊₁).
/// It keeps the energy of every linear oscillation, and of no nonlinear one.
constexpr auto trapezoidal_scheme = [](const MethodSpec&) -> StructuralScheme { return newmark(0.25, 0.5); };

}  // namespace

MethodEntry trapezoidal_entry() {
  MethodInfo info = structural_info(trapezoidal_scheme);
  info.name = "trapezoidal";
  info.summary = "trapezoidal rule: Newmark with β = 1/4, γ = 1/2";
  info.source = "Newmark 1959";
  info.use = "short runs with small steps; it can gain energy without bound on stiff cables";
  return structural_entry(info, trapezoidal_scheme);
}

}  // namespace plumb
