#include "engine/base/time_function.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

#include "engine/base/expression.h"

namespace plumb {
namespace {

using Values = std::vector<Jet>;

Jet constant(double value) {
  return {value, 0, 0};
}

Jet truth(bool is) {
  return constant(is ? 1 : 0);
}

struct Function {
  std::string_view name;
  Jet (*of)(const Jet&);
};

/// The built-in functions of one number.
constexpr std::array<Function, 21> functions{{
    {"sin",
     [](const Jet& x) { return chained(x, std::sin(x.value), std::cos(x.value), -std::sin(x.value)); }},
    {"cos",
     [](const Jet& x) { return chained(x, std::cos(x.value), -std::sin(x.value), -std::cos(x.value)); }},
    {"tan",
     [](const Jet& x) {
       const double f = std::tan(x.value), first = 1 + f * f;
       return chained(x, f, first, 2 * f * first);
     }},
    {"asin",
     [](const Jet& x) {
       const double first = 1 / std::sqrt(1 - x.value * x.value);
       return chained(x, std::asin(x.value), first, x.value * first * first * first);
     }},
    {"acos",
     [](const Jet& x) {
       const double first = -1 / std::sqrt(1 - x.value * x.value);
       return chained(x, std::acos(x.value), first, x.value * first * first * first);
     }},
    {"atan",
     [](const Jet& x) {
       const double first = 1 / (1 + x.value * x.value);
       return chained(x, std::atan(x.value), first, -2 * x.value * first * first);
     }},
    {"sinh",
     [](const Jet& x) { return chained(x, std::sinh(x.value), std::cosh(x.value), std::sinh(x.value)); }},
    {"cosh",
     [](const Jet& x) { return chained(x, std::cosh(x.value), std::sinh(x.value), std::cosh(x.value)); }},
    {"tanh",
     [](const Jet& x) {
       const double f = std::tanh(x.value), first = 1 - f * f;
       return chained(x, f, first, -2 * f * first);
     }},
    {"asinh",
     [](const Jet& x) {
       const double first = 1 / std::sqrt(x.value * x.value + 1);
       return chained(x, std::asinh(x.value), first, -x.value * first * first * first);
     }},
    {"acosh",
     [](const Jet& x) {
       const double first = 1 / std::sqrt(x.value * x.value - 1);
       return chained(x, std::acosh(x.value), first, -x.value * first * first * first);
     }},
    {"atanh",
     [](const Jet& x) {
       const double first = 1 / (1 - x.value * x.value);
       return chained(x, std::atanh(x.value), first, 2 * x.value * first * first);
     }},
    {"log2",
     [](const Jet& x) {
       const double first = std::numbers::log2e / x.value;
       return chained(x, std::log2(x.value), first, -first / x.value);
     }},
    {"log10",
     [](const Jet& x) {
       const double first = std::numbers::log10e / x.value;
       return chained(x, std::log10(x.value), first, -first / x.value);
     }},
    {"log",
     [](const Jet& x) { return chained(x, std::log(x.value), 1 / x.value, -1 / (x.value * x.value)); }},
    {"ln", [](const Jet& x) { return chained(x, std::log(x.value), 1 / x.value, -1 / (x.value * x.value)); }},
    {"exp",
     [](const Jet& x) {
       const double f = std::exp(x.value);
       return chained(x, f, f, f);
     }},
    {"sqrt",
     [](const Jet& x) {
       const double f = std::sqrt(x.value);
       return chained(x, f, 0.5 / f, -0.25 / (f * x.value));
     }},
    {"abs", [](const Jet& x) { return x.value < 0 ? -x : x; }},
    {"sign", [](const Jet& x) { return constant(x.value < 0   ? -1
                                                : x.value > 0 ? 1
                                                              : 0); }},
    {"rint", [](const Jet& x) { return constant(std::floor(x.value + 0.5)); }},
}};

Jet arctangent(const Jet& y, const Jet& x) {
  // The angle of (x, y) changes as that of the quotient which is finite.
  const bool flat = std::abs(x.value) >= std::abs(y.value);
  const Jet quotient = flat ? y / x : -(x / y);
  const double first = 1 / (1 + quotient.value * quotient.value);
  return chained(quotient, std::atan2(y.value, x.value), first, -2 * quotient.value * first * first);
}

Jet sum_of(const Values& values) {
  Jet sum;
  for (const Jet& x : values) sum = sum + x;
  return sum;
}

struct FunctionOfSeveral {
  std::string_view name;
  Jet (*of)(const Values&);
};

bool less(const Jet& a, const Jet& b) {
  return a.value < b.value;
}

constexpr std::array<FunctionOfSeveral, 5> functions_of_several{{
    {"atan2", [](const Values& x) { return arctangent(x.at(0), x.at(1)); }},
    {"sum", sum_of},
    {"avg", [](const Values& x) { return sum_of(x) / constant(static_cast<double>(x.size())); }},
    {"min", [](const Values& x) { return *std::min_element(x.begin(), x.end(), less); }},
    {"max", [](const Values& x) { return *std::max_element(x.begin(), x.end(), less); }},
}};

/// Reads an expression into a tree of what it does, by the precedence of its operators: from the loosest, ?:,
/// ||, &&, comparisons, + -, * / and signs, ^, of two of which the right one comes first.
class TreeOf {
 public:
  using Part = std::function<Jet(double)>;

  TreeOf(const std::string& expression, const std::map<std::string, double>& values)
      : text_(expression), values_(values) {}

  Part read() {
    Part whole = choice();
    if (next() != '\0') fail();
    return whole;
  }

 private:
  using Binary = Jet (*)(const Jet&, const Jet&);
  struct Operator {
    std::string_view sign;
    Binary of;
  };

  Part choice() {
    Part condition = level(0);
    if (!take("?")) return condition;
    Part then = choice();
    expect(":");
    return [condition, then, otherwise = choice()](double t) {
      return condition(t).value != 0 ? then(t) : otherwise(t);
    };
  }

  static const std::vector<std::vector<Operator>>& levels() {
    static const std::vector<std::vector<Operator>> all{
        {{"||", [](const Jet& a, const Jet& b) { return truth(a.value != 0 || b.value != 0); }}},
        {{"&&", [](const Jet& a, const Jet& b) { return truth(a.value != 0 && b.value != 0); }}},
        {{"<=", [](const Jet& a, const Jet& b) { return truth(a.value <= b.value); }},
         {">=", [](const Jet& a, const Jet& b) { return truth(a.value >= b.value); }},
         {"==", [](const Jet& a, const Jet& b) { return truth(a.value == b.value); }},
         {"!=", [](const Jet& a, const Jet& b) { return truth(a.value != b.value); }},
         {"<", [](const Jet& a, const Jet& b) { return truth(a.value < b.value); }},
         {">", [](const Jet& a, const Jet& b) { return truth(a.value > b.value); }}},
        {{"+", [](const Jet& a, const Jet& b) { return a + b; }},
         {"-", [](const Jet& a, const Jet& b) { return a - b; }}},
        {{"*", [](const Jet& a, const Jet& b) { return a * b; }},
         {"/", [](const Jet& a, const Jet& b) { return a / b; }}}};
    return all;
  }

  /// Operators of one level, from left to right.
  Part level(std::size_t which) {
    if (which == levels().size()) return signed_part();
    Part left = level(which + 1);
    while (const Operator* found = operator_of(levels()[which]))
      left = [left, of = found->of, right = level(which + 1)](double t) { return of(left(t), right(t)); };
    return left;
  }

  const Operator* operator_of(const std::vector<Operator>& operators) {
    for (const Operator& any : operators)
      if (take(any.sign)) return &any;
    return nullptr;
  }

  Part signed_part() {
    if (take("-")) return [of = power()](double t) { return -of(t); };
    take("+");
    return power();
  }

  Part power() {
    Part base = primary();
    if (!take("^")) return base;
    return [base, exponent = signed_part()](double t) { return pow(base(t), exponent(t)); };
  }

  Part primary() {
    if (take("(")) {
      Part inner = choice();
      expect(")");
      return inner;
    }
    const char c = next();
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_') return named();
    const char *first = text_.data() + at_, *last = text_.data() + text_.size();
    double value = 0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc()) fail();
    at_ += static_cast<std::size_t>(end - first);
    return [value](double) { return constant(value); };
  }

  Part named() {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const std::size_t first = at_;
    while (at_ < text_.size() && is_part(text_[at_])) ++at_;
    const std::string name = text_.substr(first, at_ - first);
    if (take("(")) return called(name, first);
    if (name == "t") return [](double t) { return Jet{t, 1, 0}; };
    if (name == "pi" || name == "_pi") return [](double) { return constant(std::numbers::pi); };
    if (name == "_e") return [](double) { return constant(std::numbers::e); };
    const auto known = values_.find(name);
    if (known == values_.end()) fail(first);
    return [value = known->second](double) { return constant(value); };
  }

  Part called(const std::string& name, std::size_t place) {
    std::vector<Part> arguments{choice()};
    while (take(",")) arguments.push_back(choice());
    expect(")");
    if (const auto one = std::find_if(functions.begin(), functions.end(),
                                      [&](const Function& any) { return any.name == name; });
        one != functions.end()) {
      if (arguments.size() != 1) fail(place);
      return [of = one->of, x = arguments[0]](double t) { return of(x(t)); };
    }
    const auto several = std::find_if(functions_of_several.begin(), functions_of_several.end(),
                                      [&](const FunctionOfSeveral& any) { return any.name == name; });
    if (several == functions_of_several.end()) fail(place);
    return [of = several->of, arguments](double t) {
      Values values;
      for (const Part& argument : arguments) values.push_back(argument(t));
      return of(values);
    };
  }

  char next() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(std::string_view sign) {
    next();
    if (!std::string_view(text_).substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }

  void expect(std::string_view sign) {
    if (!take(sign)) fail();
  }

  [[noreturn]] void fail() const { fail(at_); }
  [[noreturn]] static void fail(std::size_t position) {
    throw ExpressionError("is not understood as a function of time", position);
  }

  const std::string& text_;
  const std::map<std::string, double>& values_;
  std::size_t at_ = 0;
};

}  // namespace

TimeFunction::TimeFunction(const std::string& expression, const std::map<std::string, double>& values)
    : constant_(true) {
  // What is wrong with it is said as of every other expression.
  for (const UsedName& used : names_in(expression)) constant_ = constant_ && used.name != "t";
  std::map<std::string, double> all = values;
  all["t"] = 0;
  evaluate(expression, all);
  of_ = TreeOf(expression, values).read();
}

}  // namespace plumb
