#include <algorithm>
#include <stdexcept>
#include <vector>

#include "engine/integrate/method.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/cable.h"

namespace plumb {

// Each method's own file defines its entry, NAME_entry(). A new one adds its line here, in the order in which
// they are to be shown, and is then known to the case reader, the studies, `plumb doctor` and the report.
// clang-format off
#define PLUMB_METHODS(method)      \
  method(velocity_verlet)          \
  method(rk4)                      \
  method(runge_kutta_nystrom)      \
  method(arkode_erk)               \
  method(linearly_implicit_euler)  \
  method(implicit_euler)           \
  method(trapezoidal)              \
  method(hht)                      \
  method(generalized_alpha)        \
  method(implicit_midpoint)        \
  method(energy_momentum)          \
  method(arkode_dirk)              \
  method(gauss)                    \
  method(bdf)                      \
  method(cvode_adams)              \
  method(cvode_bdf)                \
  method(ida)                      \
  method(statics)                  \
  method(modes)
// clang-format on

#define PLUMB_DECLARE(name) MethodEntry name##_entry();
PLUMB_METHODS(PLUMB_DECLARE)

namespace {

const std::vector<MethodEntry>& entries() {
#define PLUMB_LIST(name) name##_entry(),
  static const std::vector<MethodEntry> all{PLUMB_METHODS(PLUMB_LIST)};
  return all;
}

const MethodInfo& known(std::string_view name) {
  return *find_method(name);
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
    case MethodFamily::modal:
      return "modal";
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

const MethodInfo& usual_explicit() {
  return known("velocity-verlet");
}
const MethodInfo& classical_explicit() {
  return known("rk4");
}
const MethodInfo& accurate_explicit() {
  return known("runge-kutta-nystrom");
}
const MethodInfo& accurate_explicit(const Case& spec) {
  return takes(accurate_explicit(), spec) ? accurate_explicit() : embedded_explicit();
}
const MethodInfo& embedded_explicit() {
  return known("arkode-erk");
}
const MethodInfo& usual_implicit() {
  return known("generalized-alpha");
}
const MethodInfo& first_order_implicit() {
  return known("implicit-euler");
}
const MethodInfo& accurate_implicit() {
  return known("gauss");
}
const MethodInfo& energy_keeping() {
  return known("energy-momentum");
}

void leave_out_others(const Case& spec, std::vector<std::string>& names) {
  std::erase_if(names, [&](const std::string& name) { return !takes(known(name), spec); });
}

std::vector<std::string> few_unlike_methods() {
  return {embedded_explicit().name, classical_explicit().name, usual_implicit().name,
          known("cvode-bdf").name};
}

const MethodInfo& rigid_rod_method() {
  const auto takes_one = [](const MethodEntry& entry) { return entry.make_rigid != nullptr; };
  return std::find_if(entries().begin(), entries().end(), takes_one)->info;
}

bool takes(const MethodInfo& info, const Cable& cable) {
  return (info.takes_damping || cable.damping().none()) && (info.takes_rotation || !cable.motion().turns());
}

std::unique_ptr<Method> make_method(const MethodSpec& spec, Dynamics& dynamics, const State& start) {
  const auto entry = std::find_if(entries().begin(), entries().end(),
                                  [&](const MethodEntry& any) { return any.info.name == spec.name; });
  if (entry == entries().end()) throw std::invalid_argument("no method is named " + spec.name);
  if (!takes(entry->info, dynamics.cable()))
    throw std::invalid_argument(spec.name + " takes no forces that depend on rates");
  if (!dynamics.cable().is_rigid()) return entry->make(spec, dynamics, start);
  if (entry->make_rigid == nullptr) throw std::invalid_argument(spec.name + " takes no rigid rod");
  return entry->make_rigid(spec, dynamics, start);
}

}  // namespace plumb
