#include "render/plot/log_axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace plumb {

namespace {

// Logarithms are rounded: a tick at the very end stays.
constexpr double log_end_slack = 1e-9;

// Of the wished spacing, what decades need to be marked one by one, and what the parts of a decade need.
constexpr double decade_room = 0.6;
constexpr double all_parts_room = 0.8;
constexpr double some_parts_room = 0.4;

// A whole number times a power of ten, exact to the last place for either sign of the power.
double times_ten_to(double factor, int power) {
  return power < 0 ? factor / std::pow(10.0, -power) : factor * std::pow(10.0, power);
}

class LogAxis {
 public:
  LogAxis(double lo, double hi, const TickRoom& room)
      : lo_(std::log10(lo)), hi_(std::log10(hi)), room_(room) {}

  bool holds(double value) const {
    const double at = std::log10(value);
    return at >= lo_ - log_end_slack * (hi_ - lo_) && at <= hi_ + log_end_slack * (hi_ - lo_);
  }
  double pixels_a_decade() const { return room_.length / (hi_ - lo_); }

  // The multiples of `stride` among the powers of ten inside.
  std::vector<int> powers(int stride) const {
    std::vector<int> result;
    const auto first = static_cast<int>(std::floor(lo_)) - 1, last = static_cast<int>(std::ceil(hi_)) + 1;
    for (int power = first; power <= last; ++power)
      if (power % stride == 0 && holds(times_ten_to(1, power))) result.push_back(power);
    return result;
  }

  // Values inside that are the given multiples of powers of ten, ascending.
  std::vector<double> multiples(std::span<const int> factors) const {
    std::vector<double> result;
    const auto first = static_cast<int>(std::floor(lo_)) - 1, last = static_cast<int>(std::ceil(hi_)) + 1;
    for (int power = first; power <= last; ++power)
      for (const int factor : factors)
        if (const double value = times_ten_to(factor, power); holds(value)) result.push_back(value);
    return result;
  }

  bool apart(const AxisTicks& ticks, std::size_t i, std::size_t j) const {
    const double needed = (room_.extent(ticks.labels[i]) + room_.extent(ticks.labels[j])) / 2 + room_.gap;
    return std::log10(ticks.major[j] / ticks.major[i]) * pixels_a_decade() >= needed;
  }

  bool overlaps(const AxisTicks& ticks) const {
    for (std::size_t i = 1; i < ticks.major.size(); ++i)
      if (!apart(ticks, i - 1, i)) return true;
    return false;
  }

  void clear_overlapping(AxisTicks& ticks) const {
    std::size_t shown = 0;
    for (std::size_t i = 1; i < ticks.major.size(); ++i) {
      if (apart(ticks, shown, i))
        shown = i;
      else
        ticks.labels[i].clear();
    }
  }

 private:
  double lo_;  // decades
  double hi_;
  const TickRoom& room_;
};

std::string power_label(int power) {
  return fmt::format("10^{{{}{}}}", power < 0 ? "\u2212" : "", std::abs(power));
}

AxisTicks marked(const std::vector<int>& powers) {
  AxisTicks ticks;
  const bool plain = powers.front() >= -2 && powers.back() <= 3;
  for (const int power : powers) {
    ticks.major.push_back(times_ten_to(1, power));
    ticks.labels.push_back(plain ? fmt::format("{:.{}f}", ticks.major.back(), std::max(0, -power))
                                 : power_label(power));
  }
  return ticks;
}

AxisTicks decade_ticks(const LogAxis& axis, const TickRoom& room) {
  const double decade = axis.pixels_a_decade();
  int stride = 1;
  AxisTicks ticks = marked(axis.powers(stride));
  const auto crowded = [&] { return stride * decade < decade_room * room.spacing || axis.overlaps(ticks); };
  for (int next = 2; crowded(); next = next < 5 ? next + (next == 3 ? 2 : 1) : next * 2) {
    const std::vector<int> fewer = axis.powers(next);
    if (fewer.size() < 2) break;
    stride = next;
    ticks = marked(fewer);
  }
  if (stride > 1) {
    for (const int power : axis.powers(1))
      if (power % stride != 0) ticks.minor.push_back(times_ten_to(1, power));
  } else if (decade >= all_parts_room * room.spacing) {
    ticks.minor = axis.multiples(std::array{2, 3, 4, 5, 6, 7, 8, 9});
  } else if (decade >= some_parts_room * room.spacing) {
    ticks.minor = axis.multiples(std::array{2, 5});
  }
  return ticks;
}

// Ticks at 1, 2 and 5 times a power of ten; the parts of the decades between them are minor.
AxisTicks part_ticks(const LogAxis& axis) {
  AxisTicks ticks;
  ticks.major = axis.multiples(std::array{1, 2, 5});
  ticks.minor = axis.multiples(std::array{3, 4, 6, 7, 8, 9});
  const int order = static_cast<int>(std::floor(std::log10(ticks.major.back()) + log_end_slack));
  if (order < -2 || order >= 5) ticks.exponent = order;
  for (const double value : ticks.major) {
    const int own = static_cast<int>(std::floor(std::log10(value) + log_end_slack)) - ticks.exponent;
    ticks.labels.push_back(fmt::format("{:.{}f}", times_ten_to(value, -ticks.exponent), std::max(0, -own)));
  }
  return ticks;
}

}  // namespace

AxisTicks log_axis_ticks(double lo, double hi, const TickRoom& room) {
  const LogAxis axis(lo, hi, room);
  AxisTicks ticks;
  if (axis.powers(1).size() >= 2) {
    ticks = decade_ticks(axis, room);
  } else if (axis.multiples(std::array{1, 2, 5}).size() >= 2) {
    ticks = part_ticks(axis);
  } else {
    // Equal steps are closer at the upper end: at least 0.4 of the mean where the ends differ by a factor 5.
    TickRoom wider = room;
    wider.spacing = room.spacing * 1.5;
    ticks = axis_ticks(lo, hi, wider);
  }
  axis.clear_overlapping(ticks);
  return ticks;
}

AxisRange fitted_log_range(double lo, double hi, double margin) {
  if (!(lo <= hi)) return {1, 10};
  lo = std::clamp(lo, least_log_end, greatest_log_end);
  hi = std::clamp(hi, least_log_end, greatest_log_end);
  const double decades = std::log10(hi / lo);
  const double free = decades > 1e-8 ? margin * decades : std::log10(2.0);
  AxisRange range{std::max(least_log_end, lo / std::pow(10.0, free)),
                  std::min(greatest_log_end, hi * std::pow(10.0, free))};
  return range;
}

}  // namespace plumb
