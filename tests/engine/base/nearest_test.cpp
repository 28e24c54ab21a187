#include "engine/base/nearest.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace plumb {
namespace nearest_test {

TEST(Nearest, DistanceCountsInsertedDroppedChangedAndSwappedLetters) {
  EXPECT_EQ(edit_distance("length", "length"), 0U);
  EXPECT_EQ(edit_distance("lenght", "length"), 1U);
  EXPECT_EQ(edit_distance("lngth", "length"), 1U);
  EXPECT_EQ(edit_distance("lengthh", "length"), 1U);
  EXPECT_EQ(edit_distance("lemgth", "length"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
}

RC_GTEST_PROP(Nearest, DistanceIsTheSameBothWays, (const std::string& a, const std::string& b)) {
  RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
}

RC_GTEST_PROP(Nearest, DistanceIsNoMoreThanTheLongerLength, (const std::string& a, const std::string& b)) {
  RC_ASSERT(edit_distance(a, b) <= std::max(a.size(), b.size()));
}

TEST(Nearest, SuggestsOnlyWordsThatShareHalfTheirLetters) {
  const std::vector<std::string> known{"end", "output_interval"};
  EXPECT_EQ(suggestion("ned", known), "; did you mean \"end\"?");
  EXPECT_EQ(suggestion("banana", known), "; known: end, output_interval");
  EXPECT_EQ(suggestion("banana", {}), "");
}

}  // namespace nearest_test
}  // namespace plumb
