#include "engine/integrate/methods/structural_schemes.h"

namespace plumb {

std::optional<StructuralScheme> structural_scheme(const MethodSpec& spec) {
  if (spec.name == "implicit-euler") return implicit_euler_scheme();
  if (spec.name == "trapezoidal") return trapezoidal_scheme();
  if (spec.name == "hht") return hht_scheme(spec.parameters.at("alpha"));
  if (spec.name == "generalized-alpha")
    return generalized_alpha_scheme(spec.parameters.at("spectral_radius"),
                                    spec.parameters.at("mean_forces") != 0);
  if (spec.name == "implicit-midpoint" || spec.name == "energy-momentum") return implicit_midpoint_scheme();
  return std::nullopt;
}

}  // namespace plumb
