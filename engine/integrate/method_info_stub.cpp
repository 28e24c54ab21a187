#include <algorithm>

#include "engine/integrate/method_info.h"

// Temporary: stands in until the methods themselves say what they take.
namespace plumb {

std::span<const MethodInfo> method_infos() {
  static const std::vector<MethodInfo> infos{
      {.name = "linearly-implicit-euler",
       .summary = "one linear solve a step",
       .source = "Recuero and Negrut 2016",
       .order = "1",
       .implicit = true,
       .takes_step = true,
       .parameters = {}},
      {.name = "rk4",
       .summary = "the classical Runge-Kutta method",
       .source = "Kutta 1901",
       .order = "4",
       .takes_step = true,
       .parameters = {}},
      {.name = "generalized-alpha",
       .summary = "implicit, with numerical damping of high frequencies",
       .source = "Chung and Hulbert 1993",
       .order = "2",
       .implicit = true,
       .takes_step = true,
       .parameters = {{"spectral_radius", "at infinite frequency", 0, 1, 0.8, false},
                      {"newton_tolerance", "relative size of the last correction", 1e-15, 1e-3, 1e-11, false},
                      {"newton_iterations", "most iterations a step", 1, 100, 20, true}}},
      {.name = "cvode-bdf",
       .summary = "backward differentiation formulas",
       .source = "SUNDIALS CVODE",
       .order = "1 to 5",
       .implicit = true,
       .takes_tolerances = true,
       .parameters = {{"max_order", "highest order", 1, 5, 5, true}}},
      {.name = "arkode-erk",
       .summary = "explicit Runge-Kutta pairs",
       .source = "SUNDIALS ARKODE",
       .order = "2 to 8",
       .takes_tolerances = true,
       .parameters = {{"order", "order of the pair", 2, 8, 8, true}}},
  };
  return infos;
}

const MethodInfo* find_method(std::string_view name) {
  const auto infos = method_infos();
  const auto found =
      std::find_if(infos.begin(), infos.end(), [&](const MethodInfo& info) { return info.name == name; });
  return found != infos.end() ? &*found : nullptr;
}

}  // namespace plumb
