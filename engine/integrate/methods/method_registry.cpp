#include <stdexcept>
#include <vector>

#include "engine/integrate/method.h"

namespace plumb {

// A new method adds its entry here and is then known to the case reader, `plumb doctor` and the report.
MethodEntry velocity_verlet_entry();
MethodEntry rk4_entry();
MethodEntry runge_kutta_nystrom_entry();
MethodEntry arkode_erk_entry();
MethodEntry linearly_implicit_euler_entry();
MethodEntry implicit_euler_entry();
MethodEntry trapezoidal_entry();
MethodEntry hht_entry();
MethodEntry generalized_alpha_entry();
MethodEntry implicit_midpoint_entry();
MethodEntry energy_momentum_entry();
MethodEntry bdf_entry();
MethodEntry cvode_bdf_entry();
MethodEntry cvode_adams_entry();
MethodEntry arkode_dirk_entry();
MethodEntry gauss_entry();
MethodEntry ida_entry();
MethodEntry statics_entry();

namespace {

const std::vector<MethodEntry>& entries() {
  static const std::vector<MethodEntry> all{
      velocity_verlet_entry(),
      rk4_entry(),
      runge_kutta_nystrom_entry(),
      arkode_erk_entry(),
      linearly_implicit_euler_entry(),
      implicit_euler_entry(),
      trapezoidal_entry(),
      hht_entry(),
      generalized_alpha_entry(),
      implicit_midpoint_entry(),
      energy_momentum_entry(),
      arkode_dirk_entry(),
      gauss_entry(),
      bdf_entry(),
      cvode_adams_entry(),
      cvode_bdf_entry(),
      ida_entry(),
      statics_entry(),
  };
  return all;
}

}  // namespace

std::span<const MethodInfo> method_infos() {
  static const std::vector<MethodInfo> infos = [] {
    std::vector<MethodInfo> result;
    for (const MethodEntry& entry : entries()) result.push_back(entry.info);
    return result;
  }();
  return infos;
}

std::string_view word(MethodFamily family) {
  switch (family) {
    case MethodFamily::explicit_one_step:
      return "explicit";
    case MethodFamily::structural:
      return "structural";
    case MethodFamily::implicit_stages:
      return "implicit stages";
    case MethodFamily::multistep:
      return "multistep";
    case MethodFamily::constrained:
      return "constrained";
    case MethodFamily::quasi_static:
      return "static";
  }
  return "";
}

MethodSpec plain_method(const MethodInfo& info) {
  MethodSpec spec;
  spec.name = info.name;
  for (const MethodParameter& parameter : info.parameters)
    spec.parameters[parameter.name] = parameter.fallback;
  return spec;
}

const MethodInfo* find_method(std::string_view name) {
  for (const MethodInfo& info : method_infos())
    if (info.name == name) return &info;
  return nullptr;
}

std::unique_ptr<Method> make_method(const MethodSpec& spec, Dynamics& dynamics, const State& start) {
  for (const MethodEntry& entry : entries())
    if (entry.info.name == spec.name) return entry.make(spec, dynamics, start);
  throw std::invalid_argument("no method is named " + spec.name);
}

}  // namespace plumb
