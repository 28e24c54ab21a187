#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// A mistake as it is to be made in a case.
struct PlannedBlunder {
  Blunder kind = Blunder::no_bending;
  std::string name;                         ///< "no bending", "other sign of the gravity"
  std::vector<std::string> overrides = {};  ///< beside what has no key
  std::string why_not = {};                 ///< why it does not apply to the case; empty: it does
};

/// All of the kinds that are asked for, in their order; one of each load for its sign.
std::vector<PlannedBlunder> planned_blunders(const Case& spec, const std::vector<Blunder>& kinds);

}  // namespace plumb
