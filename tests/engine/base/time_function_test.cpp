#include "engine/base/time_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/expression.h"

namespace plumb {
namespace time_function_test {

const std::map<std::string, double> parameters{{"a", 0.7}, {"w", 3.0}};

/// Smooth in t from 0.2 to 0.8; all functions and operators are among them.
const std::vector<std::string> smooth{"3",
                                      "t",
                                      "-t^2",
                                      "2^-t^2",
                                      "-2*3-4-5*t/6/7",
                                      "2*-3^t+ +1",
                                      "(1+t)^3^0.5",
                                      "t^3 - t^2 + t^1 + t^0",
                                      "a*sin(w*t)+cos(w*t)^2",
                                      "tan(t)*asin(t)+acos(t)-atan(t*t)",
                                      "sinh(t)/cosh(2*t)+tanh(t-a)",
                                      "asinh(t)*acosh(1+t)-atanh(t)",
                                      "log2(t)+log10(t)*ln(1+t)-log(2*t)",
                                      "exp(-t)*sqrt(t)+abs(t-3)",
                                      "sign(t-2)*t+rint(t+1.7)",
                                      "atan2(t-a,0.5)+atan2(2,t*t)+atan2(t, -3)",
                                      "sum(t,t^2,a)+avg(t,1,sin(t))-min(t,2,3)*max(t,-t)",
                                      "t<0.9&&t>=0.1 ? t*t : 1/0",
                                      "t<0.1||t>1 ? 5 : t!=3 ? cosh(t) : 7",
                                      "1<2==1 ? pi*t : _e*t",
                                      "0 <= t == 0 ? 1 : (t > 2) + _pi*t*t + _e",
                                      "(6/15)*(t^2/2+(15/2/pi)^2*(cos(2*pi*t/15)-1))"};

TEST(TimeFunction, HasTheValuesOfAnExpression) {
  for (const std::string& expression : smooth) {
    const TimeFunction function(expression, parameters);
    for (const double t : {0.2, 0.37, 0.8}) {
      std::map<std::string, double> values = parameters;
      values["t"] = t;
      const double expected = evaluate(expression, values);
      EXPECT_NEAR(function(t), expected, 1e-12) << expression << " at " << t;
    }
  }
}

TEST(TimeFunction, HasTheDerivativesThatDifferencesShow) {
  constexpr double h = 1e-3;
  for (const std::string& expression : smooth) {
    const TimeFunction function(expression, parameters);
    for (const double t : {0.23, 0.5, 0.77}) {
      const double m2 = function(t - 2 * h), m1 = function(t - h), p1 = function(t + h),
                   p2 = function(t + 2 * h), now = function(t);
      const Jet jet = function.jet(t);
      EXPECT_NEAR(jet.rate, (8 * (p1 - m1) - (p2 - m2)) / (12 * h), 1e-8) << expression << " at " << t;
      EXPECT_NEAR(jet.second, (16 * (p1 + m1) - (p2 + m2) - 30 * now) / (12 * h * h), 1e-6)
          << expression << " at " << t;
    }
  }
}

TEST(TimeFunction, HasFiniteDerivativesWhereAWholePowerEnds) {
  const Jet square = TimeFunction("t^2", {}).jet(0), line = TimeFunction("t^1 + sqrt(4)", {}).jet(0);
  EXPECT_EQ(square.rate, 0);
  EXPECT_EQ(square.second, 2);
  EXPECT_EQ(line.value, 2);
  EXPECT_EQ(line.rate, 1);
  EXPECT_EQ(line.second, 0);
}

TEST(TimeFunction, KnowsWhetherItChanges) {
  EXPECT_TRUE(TimeFunction("a * w", parameters).is_constant());
  EXPECT_FALSE(TimeFunction("a * t", parameters).is_constant());
}

TEST(TimeFunction, RefusesWhatIsNoExpression) {
  for (const char* bad : {"", "sin(", "1,2", "t t", "u*t", "a=3", "sin(1,2)", "atan2(1)", "--t"})
    EXPECT_THROW(TimeFunction(bad, parameters), ExpressionError) << bad;
}

}  // namespace time_function_test
}  // namespace plumb
