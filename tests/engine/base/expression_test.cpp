#include "engine/base/expression.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace plumb {
namespace expression_test {

double moderate(int numerator) {
  return numerator / 64.0;
}

RC_GTEST_PROP(Expression, ANumberKeepsEveryDigit, (int mantissa, unsigned exponent)) {
  const double value = std::ldexp(std::abs(mantissa) + 0.25, static_cast<int>(exponent % 400) - 200);
  RC_ASSERT(evaluate(fmt::format("{}", value), {}) == value);
}

RC_GTEST_PROP(Expression, ArithmeticIsThatOfTheMachine, (int a, int b, int c)) {
  const std::map<std::string, double> values{{"a", moderate(a)}, {"b", moderate(b)}, {"c", moderate(c)}};
  const double x = values.at("a"), y = values.at("b"), z = values.at("c");
  RC_ASSERT(evaluate("a + b * c", values) == x + y * z);
  RC_ASSERT(evaluate("(a + b) * c", values) == (x + y) * z);
  RC_ASSERT(evaluate("a - b - c", values) == x - y - z);
  RC_PRE(y != 0 && z != 0);
  RC_ASSERT(evaluate("a / b / c", values) == x / y / z);
}

RC_GTEST_PROP(Expression, EveryNameThatIsUsedIsFound, (unsigned seed)) {
  const std::string name = fmt::format("n{}_x", seed);
  const auto names = names_in(fmt::format("2 * {} + sin({}) / other", name, name));
  RC_ASSERT(names.size() == 2U);
  RC_ASSERT(names[0].name == name);
  RC_ASSERT(names[0].position == 4U);
  RC_ASSERT(names[1].name == "other");
}

RC_GTEST_PROP(Expression, AnyTextGivesANumberOrAnExpressionError, (const std::string& text)) {
  try {
    if (names_in(text).empty()) evaluate(text, {});
  } catch (const ExpressionError& error) {
    RC_ASSERT(error.position() <= std::max<std::size_t>(text.size(), 1));
  }
}

TEST(Expression, KnowsPi) {
  EXPECT_EQ(evaluate("pi", {}), std::numbers::pi);
  EXPECT_TRUE(names_in("2 * pi").empty());
}

TEST(Expression, PowersBindStrongerThanProductsAndGoFromTheRight) {
  EXPECT_EQ(evaluate("2 * 3^2", {}), 18);
  EXPECT_EQ(evaluate("2^3^2", {}), 512);
}

TEST(Expression, CannotAssignToAParameter) {
  EXPECT_THROW(evaluate("f = 3", {{"f", 5}}), ExpressionError);
}

TEST(Expression, ErrorsPointToWhereItStopsMakingSense) {
  try {
    evaluate("1 + * 2", {});
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.position(), 4U);
  }
}

TEST(Expression, KeepsFunctionsAndConstantsForItself) {
  for (const char* name : {"pi", "_pi", "sin", "max"}) EXPECT_TRUE(is_built_in(name)) << name;
  EXPECT_FALSE(is_built_in("f"));
}

}  // namespace expression_test
}  // namespace plumb
