#pragma once

#include "engine/kernels/lanes.h"

// The matrix and the factors of a long chain are in no cache when their turn comes. They are asked for some
// nodes ahead, or waiting for them would take as long as much else. Past the end of an array there may be
// nothing.
namespace plumb::kernels {
namespace {

inline constexpr int numbers_a_line = 8;

/// Asks for some numbers.
template <int count>
PLUMB_INLINE void ask_for(const double* numbers) {
  for (int k = 0; k < count; k += numbers_a_line) __builtin_prefetch(numbers + k);
}

/// Asks for one of `shares` shares of some numbers that are to be written.
template <int count, int shares>
PLUMB_INLINE void ask_for_share(const double* numbers, int share) {
  constexpr int lines = (count + numbers_a_line - 1) / numbers_a_line;
  for (int k = share; k < lines; k += shares) __builtin_prefetch(numbers + numbers_a_line * k, 1, 2);
}

}  // namespace
}  // namespace plumb::kernels
