#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace plumb {

/// Random numbers that are the same with every standard library, unlike those of its distributions.
class RandomDraw {
 public:
  /// What the numbers are for: each of these has its own.
  enum class Of : std::uint32_t { model = 1, method = 2, scene = 3, loads = 4 };

  RandomDraw(Of of, long seed, long number) {
    const auto low = [](long x) { return static_cast<std::uint32_t>(x); };
    const auto high = [](long x) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(x) >> 32U); };
    std::seed_seq sequence{static_cast<std::uint32_t>(of), low(seed), high(seed), low(number), high(number)};
    generator_.seed(sequence);
  }

  /// In [0, 1).
  double share() { return static_cast<double>(generator_() >> 11U) * 0x1p-53; }
  double uniform(double low, double high) { return low + share() * (high - low); }
  double of_equal_ratio(double low, double high) { return low * std::pow(high / low, share()); }
  bool coin() { return share() < 0.5; }
  template <class List>
  auto& one_of(const List& list) {
    return list[std::min(list.size() - 1,
                         static_cast<std::size_t>(share() * static_cast<double>(list.size())))];
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace plumb
