#pragma once

#include <functional>
#include <map>
#include <string>

#include "engine/base/jet.h"

namespace plumb {

/// An expression in the time `t` (s), made ready once: evaluated again and again, by any thread. Its
/// derivatives are exact, by the rules of calculus on each of its parts; those of a part that is chosen by a
/// comparison, of `abs`, `min` or `max` are those of what is chosen.
class TimeFunction {
 public:
  /// The expression's other names are all among `values`. Throws ExpressionError.
  TimeFunction(const std::string& expression, const std::map<std::string, double>& values);

  /// May be infinite or NaN.
  double operator()(double t) const { return jet(t).value; }
  /// The same with its derivatives by t.
  Jet jet(double t) const { return of_(t); }
  /// False where `t` is among its names.
  bool is_constant() const { return constant_; }

 private:
  std::function<Jet(double)> of_;
  bool constant_;
};

}  // namespace plumb
