#include "render/plot/given_ticks.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace given_ticks_test {

TickRoom room(double length) {
  return {length, 120, 10, [](std::string_view label) { return 18.0 * static_cast<double>(label.size()); }};
}

// Categories at 0, 1, 2… with names of any length, on an axis that shows some of them, either way up.
TEST(GivenTicks, OfCategoriesAreAllThatAreInsideWithLabelsThatDoNotOverlap) {
  EXPECT_TRUE(rc::check([] {
    const int count = *rc::gen::inRange(1, 40);
    std::vector<double> values;
    std::vector<std::string> names;
    for (int k = 0; k < count; ++k) {
      values.push_back(k);
      names.emplace_back(static_cast<std::size_t>(*rc::gen::inRange(1, 20)), 'n');
    }
    const double lo = *rc::gen::inRange(-200, 100 * count) / 100.0;
    const double hi = lo + *rc::gen::inRange(1, 100 * count + 200) / 100.0;
    const TickRoom space = room(*rc::gen::inRange(100, 2000));
    const bool upwards = *rc::gen::arbitrary<bool>();
    const AxisMap axis{{lo, hi}, upwards ? space.length : 0, upwards ? 0 : space.length, Scale::linear};
    const AxisTicks ticks = given_ticks(axis, values, names, space);
    std::vector<double> expected;
    for (const double value : values)
      if (value >= lo && value <= hi) expected.push_back(value);
    RC_ASSERT(ticks.major == expected);
    RC_ASSERT(ticks.labels.size() == expected.size());
    double free_from = -1e300;
    for (std::size_t k = 0; k < ticks.major.size(); ++k) {
      if (ticks.labels[k].empty()) continue;
      RC_ASSERT(ticks.labels[k] == names[static_cast<std::size_t>(ticks.major[k])]);
      const double at = std::abs(axis(ticks.major[k]) - axis.start);
      const double half = space.extent(ticks.labels[k]) / 2;
      RC_ASSERT(at - half >= free_from - 1e-6 * space.length);
      free_from = at + half + space.gap;
    }
    if (!expected.empty()) RC_ASSERT(!ticks.labels.front().empty());
  }));
}

TEST(GivenTicks, WithoutNamesSayTheirValues) {
  const AxisMap axis{{1, 100}, 0, 1000, Scale::logarithmic};
  EXPECT_EQ(given_ticks(axis, {0.5, 1, 4, 16, 64, 128}, {}, room(1000)).labels,
            (std::vector<std::string>{"1", "4", "16", "64"}));
}

}  // namespace given_ticks_test
}  // namespace plumb
