#include "engine/case/column_quantity.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace plumb {
namespace column_quantity_test {

using Of = ColumnQuantity::Of;
constexpr double pi = std::numbers::pi;

struct Samples {
  std::vector<double> times, values;
  ColumnNumber number(Of of, double until, bool known_between = true) const {
    return column_number(of, times, values, until, known_between);
  }
};

Samples sampled(double interval, int count, const auto& motion) {
  Samples samples;
  for (int k = 0; k < count; ++k) {
    samples.times.push_back(k * interval);
    samples.values.push_back(motion(k * interval));
  }
  return samples;
}

TEST(ColumnQuantity, IsTakenApartAtItsWordsAndHasTheUnitOfTheColumnOrOfTime) {
  const std::vector<ProbeSpec> probes{{"pull", 0, Quantity::axial_force}};
  const ProbeColumns columns(probes);
  const std::vector<std::tuple<std::string, Of, std::string>> all{
      {"pull", Of::last, "N"},
      {"greatest pull", Of::greatest, "N"},
      {"least pull", Of::least, "N"},
      {"time of greatest pull", Of::time_of_greatest, "s"},
      {"time of least pull", Of::time_of_least, "s"},
      {"period pull", Of::period, "s"},
      {"greatest  pull", Of::greatest, "none"},
      {"Greatest pull", Of::last, "none"},
      {"period", Of::last, "none"}};
  for (const auto& [text, of, expected] : all) {
    const ColumnQuantity quantity = column_quantity(text);
    EXPECT_EQ(quantity.of, of) << text;
    EXPECT_EQ(unit(quantity, columns).value_or("none"), expected) << text;
  }
}

TEST(ColumnNumber, OfACubicIsExactBetweenItsTimes) {
  const auto cubic = [](double t) { return (t - 1) * (t - 2) * (t - 3); };
  const Samples samples = sampled(0.75, 5, cubic);
  const double most = 2 - 1 / std::sqrt(3.0);
  EXPECT_NEAR(samples.number(Of::time_of_greatest, 2.5).value, most, 1e-12);
  EXPECT_NEAR(samples.number(Of::greatest, 2.5).value, cubic(most), 1e-12);
  EXPECT_EQ(samples.number(Of::time_of_least, 3).value, 0) << "the start is lower than all after it";
  EXPECT_EQ(samples.number(Of::least, 3).value, -6);
  Samples later = samples;
  for (double& value : later.values) value = -value;
  EXPECT_NEAR(later.number(Of::time_of_least, 2.5).value, most, 1e-12);
  EXPECT_EQ(later.number(Of::greatest, 3).value, 6);
  EXPECT_NEAR(samples.number(Of::last, 1.3).value, cubic(1.3), 1e-12);
}

TEST(ColumnNumber, EndsAtTheTimeThatIsAskedForAlsoBetweenTwo) {
  const Samples samples = sampled(1, 6, [](double t) { return t; });
  EXPECT_DOUBLE_EQ(samples.number(Of::greatest, 2.5).value, 2.5);
  EXPECT_DOUBLE_EQ(samples.number(Of::time_of_greatest, 2.5).value, 2.5);
  EXPECT_EQ(samples.number(Of::greatest, 2.5, false).value, 2) << "where nothing is known between them";
  EXPECT_EQ(samples.number(Of::greatest, 0).value, 0);
}

TEST(ColumnNumber, OfASineIsItsAmplitudeItsTimesAndItsPeriodToTheFourthOrder) {
  for (const double h : {0.2, 0.1}) {
    const Samples samples =
        sampled(h, static_cast<int>(20 / h) + 1, [](double t) { return 3 + std::sin(t); });
    EXPECT_NEAR(samples.number(Of::greatest, 20).value, 4, std::pow(h, 4) / 16) << h;
    EXPECT_NEAR(samples.number(Of::period, 20).value, 2 * pi, std::pow(h, 4)) << h;
    EXPECT_NEAR(samples.number(Of::time_of_least, 5).value, 1.5 * pi, std::pow(h, 3)) << h;
  }
}

TEST(ColumnNumber, APeriodTakesTwoCrossingsUpward) {
  const Samples samples = sampled(0.1, 200, [](double t) { return std::cos(t); });
  const ColumnNumber one = samples.number(Of::period, 7), none = samples.number(Of::period, 3);
  EXPECT_TRUE(std::isnan(one.value));
  EXPECT_EQ(one.fault, "up to 7 s it rises through the middle of its range once, and a period takes two");
  EXPECT_TRUE(none.fault.find("never") != std::string::npos) << none.fault;
  EXPECT_NEAR(samples.number(Of::period, 11).value, 2 * pi, 1e-4);
  EXPECT_FALSE(sampled(0.1, 20, [](double) { return 1.0; }).number(Of::period, 1.9).fault.empty());
}

TEST(ColumnNumber, OfWhatIsNotFiniteIsNone) {
  Samples samples = sampled(1, 5, [](double t) { return t; });
  samples.values[3] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(samples.number(Of::greatest, 2).value, 2) << "it comes later";
  const ColumnNumber number = samples.number(Of::greatest, 4);
  EXPECT_TRUE(std::isnan(number.value));
  EXPECT_EQ(number.fault, "no finite numbers up to 4 s");
}

}  // namespace column_quantity_test
}  // namespace plumb
