#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/read/toml_value.h"

namespace plumb {

/// The case's own [parameters]: numbers, and expressions of one another, by which other values can be given.
class Parameters {
 public:
  /// Evaluates all of them. `table` may be nullptr: no parameters. Throws InputError where one is not a
  /// finite number, has an unusable name, or depends on itself.
  explicit Parameters(const TomlValue* table);

  const std::map<std::string, double>& values() const { return values_; }

  /// The value of the expression in a string; `key` is the string's own, for errors. May be infinite or NaN.
  /// Throws InputError where it does not parse or uses an unknown parameter.
  double evaluate(const TomlValue& expression, const std::string& key) const;

  /// Refuses an expression in the time `t` and the parameters as `evaluate` does, and where a parameter has
  /// that name.
  void check_in_time(const TomlValue& expression, const std::string& key) const;

  /// Parameters that nothing evaluated so far has used.
  std::vector<std::string> unused() const;

 private:
  double resolve(const TomlValue& parameter);
  /// `beside`: a name that is allowed too; empty: none.
  std::vector<std::string> used_names(const TomlValue& expression, const std::string& key,
                                      std::string_view beside = {}) const;

  std::vector<std::string> names_;
  std::map<std::string, const TomlValue*> by_name_;
  std::vector<std::string> under_way_;
  std::map<std::string, double> values_;
  mutable std::set<std::string> used_;
};

}  // namespace plumb
