#include "engine/integrate/methods/structural_method.h"

namespace plumb {
namespace {

/// The generalized-α method of Chung and Hulbert (1993), with the nonlinear forces at the generalized
/// midpoint (Kuhl and Crisfield 1999):
///   M ((1 − αm) aₙ₊₁ + αm aₙ) = f((1 − αf) qₙ₊₁ + αf qₙ),
///   qₙ₊₁ = qₙ + h vₙ + h² ((½ − β) aₙ + β aₙ₊₁),   vₙ₊₁ = vₙ + h ((1 − γ) aₙ + γ aₙ₊₁),
/// or, with mean_forces, (1 − αf) f(qₙ₊₁) + αf f(qₙ) in the place of that force, which is the same for linear
/// ones, with αm, αf, β and γ from the spectral radius ρ∞ at infinite frequency. ρ∞ = 1 is the midpoint rule,
/// which keeps every linear oscillation, 0 removes the highest in a step.
constexpr auto generalized_alpha_scheme = [](const MethodSpec& spec) -> StructuralScheme {
  const double rho = spec.parameters.at("spectral_radius");
  const double alpha_m = (2 * rho - 1) / (rho + 1), alpha_f = rho / (rho + 1);
  const double gamma = 0.5 - alpha_m + alpha_f;
  const double beta = 0.25 * (1 - alpha_m + alpha_f) * (1 - alpha_m + alpha_f);
  StructuralScheme s = newmark(beta, gamma);
  s.mass_old = alpha_m;
  s.mass_new = 1 - alpha_m;
  if (spec.parameters.at("mean_forces") != 0) {
    s.force_old = alpha_f;
    s.force_new = 1 - alpha_f;
  } else {
    s.point = 1 - alpha_f;
  }
  return s;
};

}  // namespace

MethodEntry generalized_alpha_entry() {
  MethodInfo info = structural_info(generalized_alpha_scheme);
  info.name = "generalized-alpha";
  info.summary = "structural integrator with a chosen damping of high frequencies";
  info.source = "Chung and Hulbert 1993; Kuhl and Crisfield 1999";
  info.use = "stiff or fine cables, with a chosen damping";
  info.parameters.insert(
      info.parameters.begin(),
      {.name = "spectral_radius",
       .meaning = "amplification ρ∞ a step at infinite frequency; 1 conserves, 0 annihilates",
       .minimum = 0,
       .maximum = 1,
       .fallback = 0.8});
  info.parameters.insert(
      info.parameters.begin() + 1,
      {.name = "mean_forces",
       .meaning = "1 weighs the forces at both ends of a step, 0 takes that at the state between",
       .minimum = 0,
       .maximum = 1,
       .fallback = 0,
       .whole = true});
  info.damps_with = "a spectral_radius below 1";
  info.varied = {"spectral_radius", "ρ∞ = {:g}", {1, 0.8, 0.5}};
  return structural_entry(info, generalized_alpha_scheme);
}

}  // namespace plumb
