#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace plumb {

/// Foresees from what a run took so far what it will have taken at a later time. As its cost may change on
/// the way, the rest counts at the cheapest pace that any stretch of it had so far, or half the mean pace
/// where that is more. Nothing is foreseen before there are a few stretches or while they become cheaper, and
/// a rest is too long only if it takes twice the time that is left.
class CostForecast {
 public:
  /// Whether a run that took so much, and is foreseen to take so much in all, should end, s.
  static bool is_too_long(double seconds, double foreseen, double limit) {
    constexpr double far_beyond = 2;
    return foreseen - seconds > far_beyond * (limit - seconds);
  }

  /// `limit`: that a run may take that begins at 0, s, > 0.
  explicit CostForecast(double limit) : limit_(limit) {}

  /// When to look next, s.
  double due() const { return began_ + std::max(limit_ / stretches_in_limit, shortest_stretch); }

  /// The run has come to `t`, in any unit of time, in so many seconds. What it will have taken at `end`, s,
  /// where that is too long.
  std::optional<double> too_long(double t, double seconds, double end) {
    if (seconds < due() || !(t > from_)) return {};
    const double pace = (seconds - began_) / (t - from_);
    const double earlier = std::exchange(last_paces_[stretches_++ % last_paces_.size()], pace);
    cheapest_ = std::min(cheapest_, pace);
    from_ = t;
    began_ = seconds;
    if (stretches_ <= last_paces_.size() || pace < steady * earlier) return {};
    const double whole = seconds + (end - t) * std::max(cheapest_, least_of_mean * seconds / t);
    return is_too_long(seconds, whole, limit_) ? std::optional(whole) : std::nullopt;
  }

 private:
  static constexpr int stretches_in_limit = 50;
  static constexpr double steady = 0.97;  // of a pace, that is not cheaper yet
  static constexpr double least_of_mean = 0.5;
  static constexpr double shortest_stretch = 1e-3;  // s, that a clock of the processor still tells well

  double limit_;
  double from_ = 0;                                            // where the stretch under way began
  double began_ = 0;                                           // and when, s
  double cheapest_ = std::numeric_limits<double>::infinity();  // s a unit of time
  std::array<double, 4> last_paces_{};                         // the same
  std::size_t stretches_ = 0;
};

}  // namespace plumb
