#pragma once

#include "engine/case/case_words.h"

namespace plumb {

template <>
inline constexpr std::array words_of<Distribution>{
    Word<Distribution>{Distribution::normal, "normal"},
    Word<Distribution>{Distribution::uniform, "uniform"},
};

inline std::array<Distribution, 2> enum_values(Distribution) {
  return {Distribution::normal, Distribution::uniform};
}

}  // namespace plumb
