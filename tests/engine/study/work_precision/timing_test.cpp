#include "engine/study/work_precision/timing.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "engine/study/slowdown.h"

namespace plumb {
namespace timing_test {

TEST(Timing, ALongRunIsTimedOnce) {
  EXPECT_FALSE(is_timed({}, 1));
  EXPECT_TRUE(is_timed({0.1}, 50));
  EXPECT_FALSE(is_timed({0.09}, 50));
}

TEST(Timing, AShorterOneIsRepeatedUntilItsTwoLeastTimesAgree) {
  EXPECT_FALSE(is_timed({0.05, 0.06}, 5));
  EXPECT_TRUE(is_timed({0.05, 0.06, 0.0509}, 5)) << "2 % apart, though not one after the other";
  EXPECT_FALSE(is_timed({0.05, 0.06, 0.0511}, 5));
  EXPECT_TRUE(is_timed({0.06, 0.06}, 5));
}

TEST(Timing, NoneIsRepeatedMoreOftenThanAskedForAndVeryShortOnesFourTimesAsOften) {
  EXPECT_TRUE(is_timed({0.05, 0.06, 0.07}, 3));
  EXPECT_FALSE(is_timed({0.005, 0.006, 0.007}, 3));
  EXPECT_TRUE(is_timed({0.05}, 1));
  EXPECT_FALSE(is_timed({0.005}, 1));
  EXPECT_TRUE(is_timed({0.005, 0.006, 0.007, 0.008}, 1));
}

TEST(Timing, WhatSlowsOneAnotherIsTimedAlone) {
  EXPECT_EQ(company_of_timed(1.01), Company::together);
  EXPECT_EQ(company_of_timed(1.5), Company::alone);
  EXPECT_EQ(slowdown_in_words(1.5),
            "one run at a time: a run is 50.0 % slower with another one on each other core");
}

TEST(Timing, CoresThatSlowOneAnotherAreFound) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "there is but one core";
  EXPECT_EQ(slowdown_in_company([] { return 0.01; }), 1);
  // As where two threads share the units of one core.
  std::atomic<int> at_work = 0;
  const double slowdown = slowdown_in_company([&] {
    const int beside = ++at_work;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double seconds = beside > 1 || at_work > 1 ? 0.015 : 0.01;
    --at_work;
    return seconds;
  });
  EXPECT_NEAR(slowdown, 1.5, 1e-9);
}

}  // namespace timing_test
}  // namespace plumb
