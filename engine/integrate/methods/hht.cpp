#include "engine/integrate/methods/structural_method.h"

namespace plumb {
namespace {

/// The α method of Hilber, Hughes and Taylor (1977), with the forces of both ends of the step averaged:
///   M aₙ₊₁ = (1 + α) f(qₙ₊₁) − α f(qₙ),   β = ¼ (1 − α)²,  γ = ½ − α.
/// α = 0 is the trapezoidal rule, α = −1/3 damps most.
constexpr auto hht_scheme = [](const MethodSpec& spec) -> StructuralScheme {
  const double alpha = spec.parameters.at("alpha");
  const double beta = 0.25 * (1 - alpha) * (1 - alpha), gamma = 0.5 - alpha;
  StructuralScheme s = newmark(beta, gamma);
  s.force_old = -alpha;
  s.force_new = 1 + alpha;
  return s;
};

}  // namespace

MethodEntry hht_entry() {
  MethodInfo info = structural_info(hht_scheme);
  info.name = "hht";
  info.summary = "α method of Hilber, Hughes and Taylor";
  info.source = "Hilber, Hughes and Taylor 1977";
  info.use = "to compare with codes that use it; generalized-alpha damps less for the same cut";
  info.parameters.insert(info.parameters.begin(),
                         {.name = "alpha",
                          .meaning = "weight of the old forces; 0 is the trapezoidal rule",
                          .minimum = -1.0 / 3,
                          .maximum = 0,
                          .fallback = -0.1});
  info.damps_with = "an alpha below 0";
  info.varied = {"alpha", "α = {:g}", {-0.3, -0.05}};
  return structural_entry(info, hht_scheme);
}

}  // namespace plumb
