#include "render/plot/axis_ticks.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumb {
namespace axis_ticks_test {

TickRoom room(double length) {
  return {length, 120, 10, [](std::string_view label) { return 18.0 * static_cast<double>(label.size()); }};
}

// Digits of a label, whose minus sign is not ASCII.
double number(const std::string& label) {
  const std::string minus = "\u2212";
  return label.starts_with(minus) ? -std::stod(label.substr(minus.size())) : std::stod(label);
}

// A range whose ends are random in size, sign and distance.
AxisRange any_range() {
  const double middle = *rc::gen::inRange(-1000, 1001) / 500.0 * std::pow(10.0, *rc::gen::inRange(-12, 13));
  const double half = (1 + *rc::gen::inRange(0, 1000)) / 500.0 * std::pow(10.0, *rc::gen::inRange(-12, 13));
  return fitted_range(middle - half, middle + half, 0.05);
}

TEST(AxisTicks, AreInsideTheRangeAndMultiplesOfAOneTwoFiveStep) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const AxisTicks ticks = axis_ticks(range.lo, range.hi, room(*rc::gen::inRange(300, 2000)));
    const double order = std::pow(10.0, std::floor(std::log10(ticks.step) + 1e-9));
    const double digit = ticks.step / order;
    RC_ASSERT(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9);
    const double slack = 1e-8 * ticks.step;
    for (const double tick : ticks.major) {
      RC_ASSERT(tick >= range.lo - slack && tick <= range.hi + slack);
      // A tick's own rounding, seen in steps.
      const double k = tick / ticks.step;
      RC_ASSERT(std::abs(k - std::round(k)) <= 1e-9 * std::max(1.0, std::abs(k)));
    }
    for (const double tick : ticks.minor) RC_ASSERT(tick >= range.lo - slack && tick <= range.hi + slack);
  }));
}

TEST(AxisTicks, AreAtLeastTwoWithAscendingValues) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const AxisTicks ticks = axis_ticks(range.lo, range.hi, room(*rc::gen::inRange(100, 2000)));
    RC_ASSERT(ticks.major.size() >= 2U);
    RC_ASSERT(ticks.labels.size() == ticks.major.size());
    for (std::size_t i = 1; i < ticks.major.size(); ++i) RC_ASSERT(ticks.major[i] > ticks.major[i - 1]);
  }));
}

TEST(AxisTicks, LabelsAreDistinctAndDoNotOverlap) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const TickRoom space = room(*rc::gen::inRange(100, 2000));
    const AxisTicks ticks = axis_ticks(range.lo, range.hi, space);
    std::set<std::string> seen;
    double free_from = -1e300;
    for (std::size_t i = 0; i < ticks.major.size(); ++i) {
      if (ticks.labels[i].empty()) continue;
      RC_ASSERT(seen.insert(ticks.labels[i]).second);
      const double at = (ticks.major[i] - range.lo) / (range.hi - range.lo) * space.length;
      const double half = space.extent(ticks.labels[i]) / 2;
      RC_ASSERT(at - half >= free_from - 1e-6 * space.length);
      free_from = at + half + space.gap;
    }
  }));
}

TEST(AxisTicks, LabelsTimesThePowerOfTenAreTheTicks) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const AxisTicks ticks = axis_ticks(range.lo, range.hi, room(1000));
    for (std::size_t i = 0; i < ticks.major.size(); ++i) {
      if (ticks.labels[i].empty()) continue;
      const double shown = number(ticks.labels[i]) * std::pow(10.0, ticks.exponent);
      RC_ASSERT(std::abs(shown - ticks.major[i]) <= 1e-6 * ticks.step + 1e-12 * std::abs(ticks.major[i]));
    }
  }));
}

TEST(AxisTicks, MissNoMultipleOfTheStepAndDivideItEvenly) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const AxisTicks ticks = axis_ticks(range.lo, range.hi, room(*rc::gen::inRange(300, 2000)));
    const double slack = 1e-6 * ticks.step;
    RC_ASSERT(ticks.major.front() - ticks.step < range.lo + slack);
    RC_ASSERT(ticks.major.back() + ticks.step > range.hi - slack);
    for (std::size_t k = 1; k < ticks.major.size(); ++k)
      RC_ASSERT(std::abs(ticks.major[k] - ticks.major[k - 1] - ticks.step) <= slack);
    // Major and minor ones together have one step, a fourth or a fifth of the other.
    std::vector<double> all = ticks.major;
    all.insert(all.end(), ticks.minor.begin(), ticks.minor.end());
    std::sort(all.begin(), all.end());
    const double part = all[1] - all[0];
    RC_ASSERT(std::abs(ticks.step / part - 4) < 1e-3 || std::abs(ticks.step / part - 5) < 1e-3);
    for (std::size_t k = 1; k < all.size(); ++k)
      RC_ASSERT(std::abs(all[k] - all[k - 1] - part) <= 1e-3 * part);
    RC_ASSERT(all.front() - part < range.lo + slack);
    RC_ASSERT(all.back() + part > range.hi - slack);
  }));
}

// An axis of time begins at 0, whatever its length: microseconds or days.
TEST(AxisTicks, OfTimeBeginAtZeroAndAreAllLabelledWhereThereIsRoom) {
  EXPECT_TRUE(rc::check([] {
    const double end = *rc::gen::inRange(100, 1000) * std::pow(10.0, *rc::gen::inRange(-9, 5));
    const TickRoom space = room(*rc::gen::inRange(700, 2000));
    const AxisTicks ticks = axis_ticks(0, end, space);
    RC_ASSERT(ticks.major.front() == 0);
    RC_ASSERT(ticks.labels.front().find_first_not_of("0.") == std::string::npos);
    RC_ASSERT(ticks.major.size() >= 3U);
    for (const std::string& label : ticks.labels) RC_ASSERT(!label.empty());
    RC_ASSERT(ticks.major.back() <= end * (1 + 1e-8));
  }));
}

TEST(AxisTicks, SmallNumbersHaveTheirPowerOfTenTakenOut) {
  const AxisTicks ticks = axis_ticks(-2.1e-5, 2.1e-5, room(800));
  EXPECT_EQ(ticks.exponent, -5);
  EXPECT_EQ(ticks.labels, (std::vector<std::string>{"\u22122", "\u22121", "0", "1", "2"}));
}

TEST(AxisTicks, LabelsCarryJustTheDecimalsThatTheStepNeeds) {
  const AxisTicks ticks = axis_ticks(0, 2, room(1000));
  EXPECT_EQ(ticks.exponent, 0);
  EXPECT_EQ(ticks.labels.front(), "0.0");
  EXPECT_EQ(ticks.labels.back(), "2.0");
  EXPECT_EQ(axis_ticks(0, 50, room(1000)).labels.back(), "50");
}

TEST(FittedRange, HoldsItsValuesAndIsNeverEmpty) {
  EXPECT_TRUE(rc::check([](double a, double b) {
    RC_PRE(std::abs(a) < 1e300 && std::abs(b) < 1e300);
    const AxisRange range = fitted_range(std::min(a, b), std::max(a, b), 0.05);
    RC_ASSERT(range.lo < range.hi);
    RC_ASSERT(range.lo <= std::min(a, b) && range.hi >= std::max(a, b));
  }));
  for (const double value : {0.0, 1e-310, -3.5, 7e299}) {
    const AxisRange range = fitted_range(value, value, 0.05);
    EXPECT_LT(range.lo, value);
    EXPECT_GT(range.hi, value);
    EXPECT_GE(axis_ticks(range.lo, range.hi, room(1000)).major.size(), 2U) << value;
  }
}

TEST(FittedRange, IsFromZeroToOneWithoutData) {
  const AxisRange range = fitted_range(1, -1, 0.05);
  EXPECT_EQ(range.lo, 0);
  EXPECT_EQ(range.hi, 1);
}

TEST(RoundStep, IsTheNextOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_step(0.013), 0.02);
  EXPECT_DOUBLE_EQ(round_step(0.2), 0.2);
  EXPECT_DOUBLE_EQ(round_step(2.1), 5);
  EXPECT_DOUBLE_EQ(round_step(501), 1000);
}

}  // namespace axis_ticks_test
}  // namespace plumb
