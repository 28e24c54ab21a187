#pragma once

#include <span>
#include <string>

#include "engine/integrate/trajectory.h"
#include "render/image/color.h"

namespace plumb {

/// How an outcome looks in maps. Colours are after Okabe and Ito (2008), told apart with any of the common
/// colour blindnesses; the letters say the same without colour, the usual outcome having none.
struct OutcomeStyle {
  Outcome outcome;
  std::string letter;
  Color color;
  std::string meaning;  ///< one phrase
};

/// Of every outcome that a judged run can have, the best first.
std::span<const OutcomeStyle> outcome_styles();

/// The place of an outcome among them; -1: not there.
int outcome_place(Outcome outcome);

}  // namespace plumb
