#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/method_info.h"

namespace plumb {

/// A method with its parameters, to be run over steps or over tolerances.
struct MethodSetting {
  std::string label;  ///< "generalized-alpha, ρ∞ = 0.5"
  const MethodInfo* info = nullptr;
  MethodSpec method;    ///< without step and tolerances
  bool by_step = true;  ///< otherwise by rtol = atol

  MethodSpec with(double setting) const;
};

/// The variants of these methods that a work-precision study draws, in its order and with its labels.
std::vector<MethodSetting> method_variants(const std::vector<std::string>& methods);

}  // namespace plumb
