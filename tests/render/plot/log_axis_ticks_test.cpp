#include "render/plot/log_axis_ticks.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumb {
namespace log_axis_ticks_test {

TickRoom room(double length) {
  return {length, 120, 10, [](std::string_view label) {
            // The braces of a power are not drawn.
            return 18.0 * static_cast<double>(label.size() - (label.find('{') == label.npos ? 0 : 3));
          }};
}

// The value that a label says, whose minus sign is not ASCII and whose power is a superscript.
double number(std::string label, int exponent) {
  for (std::size_t at = label.find("\u2212"); at != label.npos; at = label.find("\u2212"))
    label.replace(at, std::string("\u2212").size(), "-");
  if (label.starts_with("10^{")) return std::pow(10.0, std::stod(label.substr(4)));
  return std::stod(label) * std::pow(10.0, exponent);
}

// A range of one thousandth of a decade to forty decades.
AxisRange any_range() {
  const double lo = (1 + *rc::gen::inRange(0, 9000) / 1000.0) * std::pow(10.0, *rc::gen::inRange(-30, 20));
  const double decades = *rc::gen::inRange(1, 1000) * std::pow(10.0, *rc::gen::inRange(-3, 1)) / 25;
  return {lo, lo * std::pow(10.0, decades)};
}

bool inside(const AxisRange& range, double value) {
  return value >= range.lo * (1 - 1e-7) && value <= range.hi * (1 + 1e-7);
}

// How far a value is from the nearest whole power of ten, in decades.
double off_power(double value) {
  const double power = std::log10(value);
  return std::abs(power - std::round(power));
}

TEST(LogAxisTicks, AreInsideTheRangeAscendingAndRound) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const AxisTicks ticks = log_axis_ticks(range.lo, range.hi, room(*rc::gen::inRange(100, 2000)));
    RC_ASSERT(ticks.labels.size() == ticks.major.size());
    for (const auto* values : {&ticks.major, &ticks.minor}) {
      for (const double value : *values) RC_ASSERT(inside(range, value));
      for (std::size_t i = 1; i < values->size(); ++i) RC_ASSERT((*values)[i] > (*values)[i - 1]);
    }
    if (range.hi / range.lo < 3) return;  // those of a linear axis, which has its own test
    for (const double value : ticks.major) {
      const double digit = value / std::pow(10.0, std::floor(std::log10(value) + 1e-9));
      RC_ASSERT(ticks.step > 0 || std::abs(digit - std::round(digit)) < 1e-9);
    }
  }));
}

TEST(LogAxisTicks, ThatAreDecadesHaveOneStrideAndMissNone) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const AxisTicks ticks = log_axis_ticks(range.lo, range.hi, room(*rc::gen::inRange(100, 2000)));
    if (range.hi / range.lo < 100.001) return;
    RC_ASSERT(ticks.major.size() >= 2U);
    for (const double value : ticks.major) RC_ASSERT(off_power(value) < 1e-9);
    const double stride = std::round(std::log10(ticks.major[1] / ticks.major[0]));
    for (std::size_t i = 1; i < ticks.major.size(); ++i)
      RC_ASSERT(std::round(std::log10(ticks.major[i] / ticks.major[i - 1])) == stride);
    RC_ASSERT(!inside(range, ticks.major.front() * std::pow(10.0, -stride)));
    RC_ASSERT(!inside(range, ticks.major.back() * std::pow(10.0, stride)));
    // Skipped decades are minor ticks; else the minor ones are the parts of a decade, or none.
    for (const double value : ticks.minor) RC_ASSERT((off_power(value) < 1e-9) == (stride > 1));
  }));
}

TEST(LogAxisTicks, AreLabelledAtLeastTwiceWhereThereIsRoom) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const AxisTicks ticks = log_axis_ticks(range.lo, range.hi, room(*rc::gen::inRange(900, 2000)));
    const auto labelled = std::count_if(ticks.labels.begin(), ticks.labels.end(),
                                        [](const std::string& label) { return !label.empty(); });
    RC_ASSERT(ticks.major.size() >= 2U);
    RC_ASSERT(labelled >= 2);
  }));
}

TEST(LogAxisTicks, LabelsAreDistinctDoNotOverlapAndSayTheirValue) {
  EXPECT_TRUE(rc::check([] {
    const AxisRange range = any_range();
    const TickRoom space = room(*rc::gen::inRange(100, 2000));
    const AxisTicks ticks = log_axis_ticks(range.lo, range.hi, space);
    std::set<std::string> seen;
    double free_from = -1e300;
    for (std::size_t i = 0; i < ticks.major.size(); ++i) {
      if (ticks.labels[i].empty()) continue;
      RC_ASSERT(seen.insert(ticks.labels[i]).second);
      const double at = std::log(ticks.major[i] / range.lo) / std::log(range.hi / range.lo) * space.length;
      const double half = space.extent(ticks.labels[i]) / 2;
      RC_ASSERT(at - half >= free_from - 1e-6 * space.length);
      free_from = at + half + space.gap;
      RC_ASSERT(std::abs(number(ticks.labels[i], ticks.exponent) / ticks.major[i] - 1) < 1e-6);
    }
  }));
}

TEST(LogAxisTicks, ShortPowersArePlainAndLongOnesAreNot) {
  EXPECT_EQ(log_axis_ticks(0.05, 20, room(1000)).labels, (std::vector<std::string>{"0.1", "1", "10"}));
  EXPECT_EQ(log_axis_ticks(2e-4, 0.5, room(1000)).labels,
            (std::vector<std::string>{"10^{\u22123}", "10^{\u22122}", "10^{\u22121}"}));
}

TEST(LogAxisTicks, DecadesHaveEightPartsWhereThereIsRoomForThem) {
  EXPECT_EQ(log_axis_ticks(1, 1000, room(1000)).minor.size(), 3U * 8U);
  EXPECT_EQ(log_axis_ticks(1, 1e10, room(1000)).minor.size(), 10U * 8U);
  EXPECT_EQ(log_axis_ticks(1, 1e12, room(1000)).minor.size(), 12U * 2U) << "2 and 5";
  const AxisTicks many = log_axis_ticks(1, 1e30, room(1000));
  EXPECT_EQ(many.major, (std::vector<double>{1, 1e3, 1e6, 1e9, 1e12, 1e15, 1e18, 1e21, 1e24, 1e27, 1e30}));
  EXPECT_EQ(many.minor.size(), 20U) << "the decades between";
}

TEST(LogAxisTicks, WithinOneDecadeAreOneTwoFive) {
  const AxisTicks ticks = log_axis_ticks(0.8e-5, 6e-5, room(1000));
  EXPECT_EQ(ticks.exponent, -5);
  EXPECT_EQ(ticks.labels, (std::vector<std::string>{"1", "2", "5"}));
  EXPECT_EQ(log_axis_ticks(0.3, 3, room(1000)).labels, (std::vector<std::string>{"0.5", "1", "2"}));
}

TEST(LogAxisTicks, OfANarrowRangeAreThoseOfALinearAxis) {
  const AxisTicks ticks = log_axis_ticks(2.1, 2.9, room(1000));
  EXPECT_GE(ticks.major.size(), 4U);
  EXPECT_GT(ticks.step, 0);
}

TEST(FittedLogRange, HoldsItsValuesAndIsNeverEmpty) {
  EXPECT_TRUE(rc::check([](double a, double b) {
    a = std::abs(a), b = std::abs(b);
    RC_PRE(a > 1e-299 && a < 1e299 && b > 1e-299 && b < 1e299);
    const AxisRange range = fitted_log_range(std::min(a, b), std::max(a, b), 0.05);
    RC_ASSERT(range.lo > 0);
    RC_ASSERT(range.lo < range.hi);
    RC_ASSERT(range.lo <= std::min(a, b) && range.hi >= std::max(a, b));
  }));
  for (const double value : {1e-12, 1.0, 3e200}) {
    const AxisRange range = fitted_log_range(value, value, 0.05);
    EXPECT_LT(range.lo, value);
    EXPECT_GT(range.hi, value);
    EXPECT_GE(log_axis_ticks(range.lo, range.hi, room(1000)).major.size(), 2U) << value;
  }
}

TEST(FittedLogRange, IsOneDecadeWithoutData) {
  const AxisRange range = fitted_log_range(1, -1, 0.05);
  EXPECT_EQ(range.lo, 1);
  EXPECT_EQ(range.hi, 10);
}

}  // namespace log_axis_ticks_test
}  // namespace plumb
