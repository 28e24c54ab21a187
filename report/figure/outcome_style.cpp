#include "report/figure/outcome_style.h"

#include <vector>

namespace plumb {

std::span<const OutcomeStyle> outcome_styles() {
  static const std::vector<OutcomeStyle> all{
      {Outcome::accurate, "", Color::hex(0x009E73), "within the tolerance of the reference"},
      {Outcome::inaccurate, "i", Color::hex(0x9AD0F0), "stable, but beyond the tolerance"},
      {Outcome::completed, "?", Color::hex(0xFFFFFF), "completed, with no reference to judge it by"},
      {Outcome::unstable, "U", Color::hex(0xD55E00), "the energy grew beyond its bound"},
      {Outcome::diverged, "D", Color::hex(0x3A3A3A), "not finite any more"},
      {Outcome::no_convergence, "N", Color::hex(0xF0C24B), "the equations of a step were not solved"},
      {Outcome::singular, "S", Color::hex(0xCC79A7), "a slope collapsed, or a matrix was singular"},
      {Outcome::unstable_equilibrium, "E", Color::hex(0x8C564B), "an equilibrium that the cable would leave"},
      {Outcome::out_of_time, "T", Color::hex(0xC4C8CE), "longer than the time allowed"},
  };
  return all;
}

int outcome_place(Outcome outcome) {
  int place = 0;
  for (const OutcomeStyle& style : outcome_styles()) {
    if (style.outcome == outcome) return place;
    ++place;
  }
  return -1;
}

}  // namespace plumb
