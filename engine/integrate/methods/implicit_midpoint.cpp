#include "engine/integrate/methods/structural_method.h"

namespace plumb {
namespace {

/// The implicit midpoint rule (Hairer, Lubich and Wanner 2006, section II.1), the Gauss method of one stage:
///   M a = f(½ (qₙ + qₙ₊₁)),  qₙ₊₁ = qₙ + h vₙ + ½h² a,  vₙ₊₁ = vₙ + h a.
/// It is symplectic and keeps the energy of every linear oscillation.
constexpr auto implicit_midpoint_scheme = [](const MethodSpec&) -> StructuralScheme {
  return midpoint_scheme;
};

}  // namespace

MethodEntry implicit_midpoint_entry() {
  MethodInfo info = structural_info(implicit_midpoint_scheme);
  info.name = "implicit-midpoint";
  info.summary = "implicit midpoint rule: the Gauss method of one stage";
  info.source = "Hairer, Lubich and Wanner 2006, section II.1";
  info.conserves = "momentum, angular momentum; symplectic at a fixed step";
  info.use = "long runs with small steps whose energy must not drift";
  return structural_entry(info, implicit_midpoint_scheme);
}

}  // namespace plumb
