#include "render/plot/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {

namespace {

// Rounding moves the quotient of an end and a step by some units in the last place; a tick at the very end
// stays.
constexpr double end_slack = 1e-9;

struct Step {
  int digit;  // 1, 2 or 5
  int power;

  double value() const { return power < 0 ? digit / std::pow(10.0, -power) : digit * std::pow(10.0, power); }
  Step coarser() const {
    if (digit == 1) return {2, power};
    return digit == 2 ? Step{5, power} : Step{1, power + 1};
  }
  Step finer() const {
    if (digit == 5) return {2, power};
    return digit == 2 ? Step{1, power} : Step{5, power - 1};
  }
  // How many parts minor ticks make of it.
  int parts() const { return digit == 2 ? 4 : 5; }
};

Step finest_at_least(double wished) {
  Step step{1, static_cast<int>(std::floor(std::log10(wished)))};
  while (step.value() < wished * (1 - end_slack)) step = step.coarser();
  return step;
}

// Multiples of a step inside the range, as whole numbers so that none is off by accumulated rounding.
std::vector<double> multiples(double lo, double hi, double step) {
  std::vector<double> result;
  const double first = std::ceil(lo / step - end_slack);
  const double last = std::floor(hi / step + end_slack);
  for (double k = first; k <= last; k += 1) result.push_back(k);
  return result;
}

std::string label(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = text.find_first_not_of("0.") == text.npos;
  return value < 0 && !zero ? "\u2212" + text : text;
}

AxisTicks ticks_with(Step step, double lo, double hi) {
  AxisTicks ticks;
  ticks.step = step.value();
  const auto at = [](double k, Step s) {
    return s.power < 0 ? k * s.digit / std::pow(10.0, -s.power) : k * s.digit * std::pow(10.0, s.power);
  };
  for (const double k : multiples(lo, hi, ticks.step)) ticks.major.push_back(at(k, step));
  for (const double k : multiples(lo, hi, ticks.step / step.parts()))
    if (std::fmod(k, step.parts()) != 0) ticks.minor.push_back(at(k, step) / step.parts());

  double largest = 0;
  for (const double tick : ticks.major) largest = std::max(largest, std::abs(tick));
  const int order = largest > 0 ? static_cast<int>(std::floor(std::log10(largest) + end_slack)) : 0;
  if (order < -2 || order >= 5) ticks.exponent = order;
  const int decimals = std::max(0, ticks.exponent - step.power);
  for (const double k : multiples(lo, hi, ticks.step))
    ticks.labels.push_back(label(k * step.digit * std::pow(10.0, step.power - ticks.exponent), decimals));
  return ticks;
}

// Whether two labels have room beside each other.
bool apart(const AxisTicks& ticks, std::size_t i, std::size_t j, double scale, const TickRoom& room) {
  const double needed = (room.extent(ticks.labels[i]) + room.extent(ticks.labels[j])) / 2 + room.gap;
  return (ticks.major[j] - ticks.major[i]) * scale >= needed;
}

bool overlaps(const AxisTicks& ticks, double scale, const TickRoom& room) {
  for (std::size_t i = 1; i < ticks.major.size(); ++i)
    if (!apart(ticks, i - 1, i, scale, room)) return true;
  return false;
}

void clear_overlapping(AxisTicks& ticks, double scale, const TickRoom& room) {
  std::size_t shown = 0;
  for (std::size_t i = 1; i < ticks.major.size(); ++i) {
    if (apart(ticks, shown, i, scale, room))
      shown = i;
    else
      ticks.labels[i].clear();
  }
}

}  // namespace

AxisTicks axis_ticks(double lo, double hi, const TickRoom& room) {
  // From 0.7 of the wished spacing on, as steps grow by 2 or 2.5 and too few ticks are worse than some more.
  Step step = finest_at_least((hi - lo) * 0.7 * room.spacing / room.length);
  const double scale = room.length / (hi - lo);
  AxisTicks ticks = ticks_with(step, lo, hi);
  while (ticks.major.size() < 2) {
    step = step.finer();
    ticks = ticks_with(step, lo, hi);
  }
  while (overlaps(ticks, scale, room)) {
    step = step.coarser();
    AxisTicks fewer = ticks_with(step, lo, hi);
    if (fewer.major.size() < 2) break;
    ticks = std::move(fewer);
  }
  clear_overlapping(ticks, scale, room);
  return ticks;
}

double round_step(double wished) {
  return finest_at_least(wished).value();
}

AxisRange fitted_range(double lo, double hi, double margin) {
  if (!(lo <= hi)) return {0, 1};
  // Far from where powers of ten and differences leave the range of numbers.
  constexpr double largest = 1e300;
  constexpr double smallest = 1e-290;
  lo = std::clamp(lo, -largest, largest);
  hi = std::clamp(hi, -largest, largest);
  const double size = std::max(std::abs(lo), std::abs(hi));
  // Below this, the digits of a tick label would be noise.
  if (hi - lo <= std::max(1e-9 * size, smallest)) {
    const double half = size > smallest ? 0.1 * size : 1;
    const double middle = lo / 2 + hi / 2;
    return {middle - half, middle + half};
  }
  return {lo - margin * (hi - lo), hi + margin * (hi - lo)};
}

}  // namespace plumb
