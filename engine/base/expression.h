#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// An expression that does not parse; the message says why.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& what, std::size_t position)
      : std::runtime_error(what), position_(position) {}

  /// Where in the expression, in characters from 0.
  std::size_t position() const { return position_; }

 private:
  std::size_t position_;
};

/// A name that an expression uses, and where first, in characters from 0.
struct UsedName {
  std::string name;
  std::size_t position = 0;
};

/// The names in an expression that are neither functions nor built-in constants (pi, _pi, _e), in the order
/// of first use. Throws ExpressionError.
std::vector<UsedName> names_in(const std::string& expression);

/// The value of an expression whose names are all among `values`; may be infinite or NaN. Throws
/// ExpressionError.
double evaluate(const std::string& expression, const std::map<std::string, double>& values);

/// True for names that expressions keep for themselves: "pi", "sin".
bool is_built_in(std::string_view name);

}  // namespace plumb
