#include <cmath>

#include "engine/base/expression.h"
#include "engine/base/time_function.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

bool feed(std::string_view input) {
  const std::string text(input);
  try {
    std::map<std::string, double> values;
    for (const UsedName& used : names_in(text)) {
      promise(used.position < text.size() && text.compare(used.position, used.name.size(), used.name) == 0,
              "\"" + used.name + "\" is not where it is said to be");
      values[used.name] = 0.75;
    }
    const double value = evaluate(text, values), again = evaluate(text, values);
    promise(value == again || (std::isnan(value) && std::isnan(again)), "an expression has two values");
    // The parser takes && and || of constants without their fractions, and of what changes with them.
    if (text.find("&&") != text.npos || text.find("||") != text.npos) return true;
    const double t = values.contains("t") ? values.at("t") : 0, in_time = TimeFunction(text, values)(t);
    promise((std::isnan(value) && std::isnan(in_time)) || value == in_time ||
                std::abs(value - in_time) <= 1e-9 * std::abs(value),
            "an expression has another value as a function of time");
    return true;
  } catch (const ExpressionError& error) {
    promise(error.position() <= text.size(), "an error beyond the expression");
    promise(error.what()[0] != '\0', "an error says nothing");
    return false;
  }
}

std::vector<std::string> seeds() {
  return {"1e9 / f^4",
          "-g + 0.19",
          "2*pi*sqrt(a/b)",
          "a < b ? min(a, 1, 2) : max(b, sin(c))",
          "_pi - _e",
          "rint(2.5) && 1 || 0",
          "(1 + 2) * (3 - atan2(y, x))",
          "1e-6 * f^2"};
}

}  // namespace

const Target expression_target{"expression", feed, seeds};

}  // namespace plumb::fuzz
