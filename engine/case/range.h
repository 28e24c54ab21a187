#pragma once

#include <limits>
#include <string>

namespace plumb {

/// The finite numbers that a key takes, with their unit.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;   ///< `low` itself is not allowed
  bool high_open = false;  ///< `high` itself is not allowed
  bool whole = false;      ///< whole numbers only
  std::string unit = {};   ///< "m"; empty where there is none

  static Range any(std::string unit) { return {.unit = std::move(unit)}; }
  static Range positive(std::string unit) { return {.low = 0, .low_open = true, .unit = std::move(unit)}; }
  /// Above 0 and below 1, as a relative tolerance is.
  static Range below_one() { return {.low = 0, .high = 1, .low_open = true, .high_open = true}; }
  static Range at_least(double low, std::string unit) { return {.low = low, .unit = std::move(unit)}; }
  static Range between(double low, double high, std::string unit) {
    return {.low = low, .high = high, .unit = std::move(unit)};
  }
  static Range whole_between(double low, double high) {
    return {.low = low, .high = high, .whole = true, .unit = {}};
  }

  /// Of a seed of random numbers.
  static Range seed() { return whole_between(0, 1e15); }

  bool contains(double x) const;
  /// "a number greater than 0 (m)", "a whole number from 1 to 5": what follows "must be".
  std::string allowed() const;
};

}  // namespace plumb
