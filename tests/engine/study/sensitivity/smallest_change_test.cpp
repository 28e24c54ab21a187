#include "engine/study/sensitivity/smallest_change.h"

#include <gtest/gtest.h>

namespace plumb {
namespace smallest_change_test {

Trial completed(std::vector<Found> found) {
  return {Outcome::completed, "", std::move(found)};
}

/// A search for one criterion that notices where `notices` says so.
SearchedSide search(const std::function<bool(double)>& notices, double largest = 99) {
  return smallest_changes({true}, largest, [&](double change) {
    return completed({{change, notices(change)}});
  });
}

TEST(SmallestChange, IsFoundToFivePercentWhereverItIs) {
  for (const double threshold : {3e-8, 1e-4, 0.009, 0.01, 0.013, 0.3, 0.999, 7.5, 98.0}) {
    const SearchedSide side = search([&](double change) { return change >= threshold; });
    const double found = side.noticed.at(0).change;
    EXPECT_GE(found, threshold);
    EXPECT_LE(found, 1.05 * threshold) << "after " << side.runs << " runs";
    EXPECT_LE(side.runs, 24) << threshold;
  }
}

TEST(SmallestChange, BeyondTheLargestThatIsTriedIsNone) {
  const SearchedSide side = search([](double change) { return change > 2.5; }, 2);
  EXPECT_EQ(side.noticed.at(0).change, -1);
  EXPECT_EQ(side.searched, 2) << "the largest itself is tried";
  EXPECT_EQ(side.ended, "");
}

TEST(SmallestChange, BelowRoundOffIsNotSought) {
  const SearchedSide side = search([](double) { return true; });
  EXPECT_LE(side.noticed.at(0).change, 1e-9);
  EXPECT_LE(side.runs, 12);
}

TEST(SmallestChange, OfWhatIsNoticedHereAndThereIsWhereItFirstIs) {
  const SearchedSide side =
      search([](double change) { return (change > 0.13 && change < 0.35) || change > 6; });
  EXPECT_GE(side.noticed.at(0).change, 0.13);
  EXPECT_LE(side.noticed.at(0).change, 0.13 * 1.05);
}

TEST(SmallestChange, OfSeveralCriteriaSharesTheirRuns) {
  const std::vector<double> thresholds{0.3, 0.31, 0.32};
  const auto trial = [&](double change) {
    std::vector<Found> found;
    for (const double threshold : thresholds) found.push_back({change, change >= threshold});
    return completed(found);
  };
  const SearchedSide all = smallest_changes({true, false, true}, 99, trial);
  const int one_by_one = smallest_changes({true, false, false}, 99, trial).runs +
                         smallest_changes({false, false, true}, 99, trial).runs;
  EXPECT_LE(all.runs, 3 * one_by_one / 4) << one_by_one << " one by one";
  EXPECT_NEAR(all.noticed.at(0).change, 0.3, 0.015);
  EXPECT_EQ(all.noticed.at(1).change, -1) << "that was not asked for";
  EXPECT_NEAR(all.noticed.at(2).change, 0.32, 0.016);
}

TEST(SmallestChange, WhereARunFailsIsSaidToBeThat) {
  const SearchedSide side = smallest_changes({true, true}, 99, [](double change) {
    if (change > 0.5) return Trial{Outcome::unstable, "it grew", {}};
    return completed({{0, false}, {change, change > 0.1}});
  });
  EXPECT_NEAR(side.noticed.at(0).change, 0.5, 0.026);
  EXPECT_TRUE(side.noticed.at(0).by_failure);
  EXPECT_NEAR(side.noticed.at(1).change, 0.1, 0.006);
  EXPECT_FALSE(side.noticed.at(1).by_failure);
}

TEST(SmallestChange, IsNotSoughtBeyondWhatCanBeTold) {
  for (const Outcome outcome : {Outcome::out_of_time, Outcome::not_run}) {
    const SearchedSide side = smallest_changes({true}, 99, [&](double change) {
      return change > 0.6 ? Trial{outcome, "too much", {}} : completed({{0, false}});
    });
    EXPECT_EQ(side.noticed.at(0).change, -1) << "it is not noticed, but not known";
    EXPECT_EQ(side.searched, 0.5);
    EXPECT_EQ(side.ended, "too much");
  }
}

}  // namespace smallest_change_test
}  // namespace plumb
