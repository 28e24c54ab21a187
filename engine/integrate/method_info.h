#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// A key of [method] that belongs to one method.
struct MethodParameter {
  std::string name;
  std::string meaning;  ///< one phrase, with the unit
  double minimum = 0;   ///< inclusive
  double maximum = 0;   ///< inclusive
  double fallback = 0;
  bool whole = false;  ///< whole numbers only
};

/// Methods that are alike in how they work, and so in when they serve.
enum class MethodFamily {
  explicit_one_step,  ///< Runge-Kutta, Nyström, Verlet: no equations to solve
  structural,         ///< one implicit stage with the tangent: Newmark and its kin
  implicit_stages,    ///< several implicit stages a step, of high order
  multistep,          ///< uses earlier steps: Adams, backward differentiation
  constrained,        ///< carries the supports as constraints with multipliers
  quasi_static,       ///< no motion: equilibrium under a growing load
};

/// "explicit", "structural", "implicit stages", "multistep", "constrained", "static".
std::string_view word(MethodFamily);

/// What a method is and takes: the same words serve the case reader, `plumb doctor` and the report.
struct MethodInfo {
  std::string name;       ///< as in the case file
  std::string summary;    ///< one line
  std::string source;     ///< paper or library
  std::string order;      ///< of accuracy in time: "2", "1 to 5"
  std::string conserves;  ///< of what a free, undamped cable keeps: "momentum", "energy and momentum"
  std::string use;        ///< when to choose it, one phrase
  MethodFamily family = MethodFamily::explicit_one_step;
  bool implicit = false;
  bool dynamic = true;  ///< integrates motion; one that does not has no place among those that do
  /// Which of [method] step and rtol/atol it takes. A method that takes both is given one: a step is kept, a
  /// tolerance makes the method choose its steps.
  bool takes_step = false;
  bool takes_tolerances = false;
  std::vector<MethodParameter> parameters;
  /// Of an implicit Runge-Kutta method: down to it the order is reduced where steps are long against the
  /// fastest vibration (Hairer and Wanner 1996, section IV.15). 0: of another kind.
  int stage_order = 0;
};

/// rtol where the case gives none.
inline constexpr double default_rtol = 1e-8;

/// The method with all its own parameters at their defaults, without step or tolerances.
MethodSpec plain_method(const MethodInfo& info);

/// Every method there is, in the order they are to be shown.
std::span<const MethodInfo> method_infos();

/// The method of that name, or nullptr.
const MethodInfo* find_method(std::string_view name);

}  // namespace plumb
