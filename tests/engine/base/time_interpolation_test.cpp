#include "engine/base/time_interpolation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace time_interpolation_test {

double cubic(double t) {
  return 1 - 2 * t + 3 * t * t - 0.5 * t * t * t;
}

double quartic(double t) {
  return t * t * t * t;
}

std::vector<double> values_of(double (*f)(double), const std::vector<double>& times) {
  std::vector<double> values;
  for (const double t : times) values.push_back(f(t));
  return values;
}

const std::vector<double> uneven{0, 0.1, 0.25, 0.3, 0.7, 1.0};

TEST(TimeInterpolation, ACubicIsExactAtUnevenTimesAndSoIsItsRate) {
  const std::vector<double> values = values_of(cubic, uneven);
  const TimeInterpolation interpolation(uneven, values);
  for (double t = 0; t <= 1; t += 0.05) {
    EXPECT_NEAR(interpolation.value(t), cubic(t), 1e-14) << t;
    EXPECT_NEAR(interpolation.rate(t), -2 + 6 * t - 1.5 * t * t, 1e-12) << t;
  }
}

TEST(TimeInterpolation, AQuarticIsNotExactAndItsErrorFallsWithTheFourthPower) {
  const auto error = [](int intervals) {
    std::vector<double> times;
    for (int k = 0; k <= intervals; ++k) times.push_back(1.0 * k / intervals);
    const std::vector<double> values = values_of(quartic, times);
    const TimeInterpolation interpolation(times, values);
    double worst = 0;
    for (int k = 0; k < intervals; ++k) {
      const double t = (k + 0.5) / intervals;
      worst = std::max(worst, std::abs(interpolation.value(t) - quartic(t)));
    }
    return worst;
  };
  const double coarse = error(8), fine = error(16);
  EXPECT_GT(coarse, 1e-6);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.05) << coarse << " " << fine;
}

TEST(TimeInterpolation, AtItsOwnTimesItIsTheNumberItself) {
  const std::vector<double> values{0.1, 7, -3, 1e300, 2, 0.3};
  const TimeInterpolation interpolation(uneven, values);
  for (std::size_t k = 0; k < uneven.size(); ++k) EXPECT_EQ(interpolation.value(uneven[k]), values[k]);
}

TEST(TimeInterpolation, FewerThanFourTimesGiveALowerDegreeAndAreSaidSo) {
  const std::vector<double> two{0, 1}, three{0, 1, 2}, line{1, 3}, parabola{0, 1, 4}, one{5};
  EXPECT_DOUBLE_EQ(TimeInterpolation(two, line).value(0.25), 1.5);
  EXPECT_DOUBLE_EQ(TimeInterpolation(two, line).rate(0.25), 2);
  EXPECT_DOUBLE_EQ(TimeInterpolation(three, parabola).value(1.5), 2.25);
  EXPECT_EQ(TimeInterpolation(one, one).value(5), 5);
  EXPECT_EQ(TimeInterpolation(one, one).rate(5), 0);
  EXPECT_EQ(interpolation_in_words(2), "linearly");
  EXPECT_EQ(interpolation_in_words(3), "quadratically");
  EXPECT_EQ(interpolation_in_words(4), "cubically");
}

}  // namespace time_interpolation_test
}  // namespace plumb
