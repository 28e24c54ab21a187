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
  /// The words that a case file uses in the place of the numbers 0, 1, … of a choice; none of a number.
  std::vector<std::string> words = {};
};

/// Methods that are alike in how they work, and so in when they serve.
enum class MethodFamily {
  explicit_one_step,  ///< Runge-Kutta, Nyström, Verlet: no equations to solve
  structural,         ///< one implicit stage with the tangent: Newmark and its kin
  implicit_stages,    ///< several implicit stages a step, of high order
  multistep,          ///< uses earlier steps: Adams, backward differentiation
  constrained,        ///< carries the supports as constraints with multipliers
  quasi_static,       ///< no motion: equilibrium under a growing load
  modal,              ///< no motion: small vibrations about an equilibrium
};

/// "explicit", "structural", "implicit stages", "multistep", "constrained", "static", "modal".
std::string_view word(MethodFamily);

/// A parameter of which studies draw one curve a value; the others keep their defaults.
struct VariedParameter {
  std::string name;   ///< empty: there is none
  std::string label;  ///< of a value: "order {:g}"
  std::vector<double> values;
};

/// What a run takes, measured and rounded up. Of a method that is not known, as much as the most that one
/// does.
struct MethodCost {
  double bytes = 6600;         ///< a node
  double nanoseconds = 10000;  ///< an element and step
};

/// Newton's matrix of a method with one implicit stage, S = mass M + stiffness h² K, without h.
struct NewtonMatrix {
  double mass = 1;       ///< pure number
  double stiffness = 1;  ///< pure number
  double point = 1;      ///< of the state within the step at which K is that of the solution, in (0, 1]
};

/// What a method is and takes: the same words serve the case reader, `plumb doctor` and the report, and
/// studies know no more of it than this.
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
  /// Has one output, at 0, and needs no [time]; loads that change are those at its end.
  bool timeless = false;
  bool spins = false;  ///< of those that integrate no motion: takes the angular velocity of the start
  /// Which of [method] step and rtol/atol it takes. A method that takes both is given one: a step is kept, a
  /// tolerance makes the method choose its steps.
  bool takes_step = false;
  bool takes_tolerances = false;
  double rtol = 1e-8;  ///< where the case gives none: what it can meet without much work
  std::vector<MethodParameter> parameters;
  /// Of an implicit Runge-Kutta method: down to it the order is reduced where steps are long against the
  /// fastest vibration (Hairer and Wanner 1996, section IV.15). 0: of another kind.
  int stage_order = 0;
  bool keeps_energy = false;   ///< that of every motion, whatever the step
  bool takes_damping = true;   ///< forces may depend on rates
  bool takes_rotation = true;  ///< an end may be turned, which adds forces that depend on rates
  /// With what it damps the vibrations that its steps are too long for: "a spectral_radius below 1".
  std::string damps_with;
  VariedParameter varied;
  MethodCost cost;
  /// What `amplification` (linear_stability.h) is at z > 0 with a fixed step; nullptr: not known.
  double (*amplification)(const MethodSpec&, double z) = nullptr;
  /// nullptr: it has no such matrix.
  NewtonMatrix (*newton_matrix)(const MethodSpec&) = nullptr;
};

/// The method with all its own parameters at their defaults, without step or tolerances.
MethodSpec plain_method(const MethodInfo& info);

/// Every method there is, in the order they are to be shown.
std::span<const MethodInfo> method_infos();

/// Whether a method can integrate the case: one that is made for forces without rates takes no damping.
inline bool takes(const MethodInfo& info, const Case& spec) {
  return (info.takes_damping || spec.damping == DampingSpec{}) &&
         (info.takes_rotation || !spec.supports.first_rotation);
}

/// The method of that name, or nullptr.
const MethodInfo* find_method(std::string_view name);

}  // namespace plumb
