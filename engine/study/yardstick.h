#pragma once

#include <array>
#include <string>
#include <vector>

namespace plumb {

/// Which piece of work the yardstick is: times of unlike versions cannot be held against one another.
inline constexpr int yardstick_version = 1;

/// How long a fixed piece of work takes here, by which times that were taken elsewhere are scaled.
struct Yardstick {
  double seconds = -1;          ///< of the processor, the least of `repeats`
  std::vector<double> repeats;  ///< s, in the order taken
  std::string work;             ///< what was done, in words
  long steps = 0;               ///< of one repeat
  std::array<double, 3> tip{};  ///< where the tip comes to, m: the same to the bit on every machine
};

/// Does it several times, which takes about a second: a pendulum of 32 elements, soft as the published one
/// is, by a fixed number of steps of classical_explicit(). It needs one thread, little memory and no file.
Yardstick yardstick();

}  // namespace plumb
