#pragma once

#include <cmath>

namespace plumb {

/// The steps of a run with a fixed step h: the n-th ends at n h, not at a sum of h, and only the one that
/// ends the run may be shorter. A sliver of a step left by round-off is not taken: the step before it reaches
/// the stop. h itself is the same to the last bit, which differences of times are not, as methods keep what
/// they have factored for it.
class FixedSteps {
 public:
  struct Step {
    double h;    ///< s
    double end;  ///< s
  };

  /// h: s, > 0.
  explicit FixedSteps(double h) : h_(h) {}

  /// The step that comes next, from `now`, with the end of the run at `stop` (s).
  Step next(double now, double stop) const {
    constexpr double sliver = 1e-9;
    const double end = h_ * static_cast<double>(taken_ + 1);
    if (end <= stop - sliver * h_) return {h_, end};
    return {std::abs(end - stop) > sliver * h_ ? stop - now : h_, stop};
  }

  /// That step was taken.
  void take() { ++taken_; }

 private:
  double h_;
  long taken_ = 0;
};

}  // namespace plumb
