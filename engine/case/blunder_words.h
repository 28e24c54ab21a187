#pragma once

#include "engine/case/case_words.h"

namespace plumb {

template <>
inline constexpr std::array words_of<Blunder>{
    Word<Blunder>{Blunder::no_bending, "no-bending"},
    Word<Blunder>{Blunder::chain, "chain"},
    Word<Blunder>{Blunder::strain_model, "strain-model"},
    Word<Blunder>{Blunder::half_mesh, "half-mesh"},
    Word<Blunder>{Blunder::double_mesh, "double-mesh"},
    Word<Blunder>{Blunder::lumped_mass, "lumped-mass"},
    Word<Blunder>{Blunder::zero_slope_rates, "zero-slope-rates"},
    Word<Blunder>{Blunder::first_order, "first-order"},
    Word<Blunder>{Blunder::rounded_gravity, "rounded-gravity"},
    Word<Blunder>{Blunder::density_unit, "density-unit"},
    Word<Blunder>{Blunder::other_sign, "other-sign"},
    Word<Blunder>{Blunder::late_output, "late-output"},
};

inline std::string_view word(Blunder blunder) {
  for (const auto& entry : words_of<Blunder>)
    if (entry.value == blunder) return entry.word;
  return {};
}

inline std::vector<Blunder> enum_values(Blunder) {
  std::vector<Blunder> all;
  for (const auto& entry : words_of<Blunder>) all.push_back(entry.value);
  return all;
}

}  // namespace plumb
