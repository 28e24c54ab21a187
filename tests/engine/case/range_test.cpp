#include "engine/case/range.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumb {
namespace range_test {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Range, HoldsItsClosedBoundsAndNotItsOpenOnes) {
  EXPECT_FALSE(Range::positive("m").contains(0));
  EXPECT_TRUE(Range::positive("m").contains(5e-324));
  EXPECT_TRUE(Range::at_least(0, "m").contains(0));
  EXPECT_FALSE(Range::at_least(0, "m").contains(-5e-324));
  EXPECT_TRUE(Range::between(0, 1, "").contains(1));
  EXPECT_FALSE(Range::between(0, 1, "").contains(1.0000000000000002));
  const Range open{.low = 0, .high = 1, .low_open = true, .high_open = true};
  EXPECT_FALSE(open.contains(0));
  EXPECT_FALSE(open.contains(1));
  EXPECT_TRUE(open.contains(0.5));
}

TEST(Range, HoldsFiniteNumbersOnly) {
  for (double x : {inf, -inf, nan}) EXPECT_FALSE(Range::any("m").contains(x)) << x;
}

TEST(Range, OfWholeNumbersHoldsNoOthers) {
  EXPECT_TRUE(Range::whole_between(1, 5).contains(5));
  EXPECT_FALSE(Range::whole_between(1, 5).contains(4.5));
}

TEST(Range, SaysInWordsWhatItHolds) {
  EXPECT_EQ(Range::any("m/s²").allowed(), "a number (m/s²)");
  EXPECT_EQ(Range::positive("m").allowed(), "a number greater than 0 (m)");
  EXPECT_EQ(Range::at_least(0, "m").allowed(), "a number of at least 0 (m)");
  EXPECT_EQ(Range::between(0, 0.5, "").allowed(), "a number from 0 to 0.5");
  EXPECT_EQ(Range::whole_between(1, 1'000'000).allowed(), "a whole number from 1 to 1000000");
  EXPECT_EQ((Range{.low = 0, .high = 1, .low_open = true, .high_open = true}).allowed(),
            "a number greater than 0 and less than 1");
}

}  // namespace range_test
}  // namespace plumb
