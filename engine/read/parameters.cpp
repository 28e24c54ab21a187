#include "engine/read/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/base/expression.h"
#include "engine/base/nearest.h"
#include "engine/base/number_text.h"
#include "engine/base/time_function.h"

namespace plumb {
namespace {

/// A chain of parameters is followed by recursion, so that their number bounds its depth.
constexpr std::size_t most_parameters = 1000;

bool is_usable(const std::string& name) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), part);
}

[[noreturn]] void refuse_expression(const TomlValue& value, const std::string& key, std::size_t position,
                                    const std::string& what) {
  Place place = value.place;
  if (value.text_column > 0) place.column = value.text_column + static_cast<int>(position);
  refuse(place, key, value.written, what);
}

}  // namespace

Parameters::Parameters(const TomlValue* table) {
  if (table == nullptr) return;
  if (table->kind != TomlValue::Kind::table) {
    refuse(table->place, "parameters", table->written,
           fmt::format("must be a table [parameters], found {}", words(table->kind)));
  }
  if (table->items.size() > most_parameters) {
    refuse(table->place, "parameters", "", fmt::format("at most {} parameters are allowed", most_parameters));
  }
  for (const TomlValue& parameter : table->items) {
    const std::string key = "parameters." + parameter.key;
    if (!is_usable(parameter.key)) {
      refuse(parameter.key_place, key, parameter.written,
             "the name must be a letter followed by letters, digits and _");
    }
    if (is_built_in(parameter.key)) {
      refuse(parameter.key_place, key, parameter.written,
             "the name is taken by a built-in function or constant");
    }
    names_.push_back(parameter.key);
    by_name_.emplace(parameter.key, &parameter);
  }
  for (const TomlValue& parameter : table->items) resolve(parameter);
}

double Parameters::resolve(const TomlValue& parameter) {
  if (const auto known = values_.find(parameter.key); known != values_.end()) return known->second;
  const std::string key = "parameters." + parameter.key;
  double value = 0;
  std::string computed;
  if (parameter.kind == TomlValue::Kind::integer || parameter.kind == TomlValue::Kind::real) {
    value = parameter.number;
  } else if (parameter.kind == TomlValue::Kind::string) {
    const auto begun = std::find(under_way_.begin(), under_way_.end(), parameter.key);
    if (begun != under_way_.end()) {
      refuse(parameter.place, key, parameter.written,
             fmt::format("depends on itself: {} -> {}", fmt::join(begun, under_way_.end(), " -> "),
                         parameter.key));
    }
    under_way_.push_back(parameter.key);
    for (const std::string& name : used_names(parameter, key)) resolve(*by_name_.at(name));
    under_way_.pop_back();
    value = evaluate(parameter, key);
    computed = number_text(value);
  } else {
    refuse(parameter.place, key, parameter.written,
           fmt::format("must be a number or an expression, found {}", words(parameter.kind)));
  }
  if (!std::isfinite(value)) refuse(parameter.place, key, parameter.written, "must be finite", computed);
  values_.emplace(parameter.key, value);
  return value;
}

std::vector<std::string> Parameters::used_names(const TomlValue& expression, const std::string& key,
                                                std::string_view beside) const {
  try {
    std::vector<std::string> names;
    for (const UsedName& used : names_in(expression.string)) {
      if (used.name == beside) continue;
      if (!by_name_.contains(used.name)) {
        const std::string end =
            names_.empty() ? "; the case has no [parameters]" : suggestion(used.name, names_);
        refuse_expression(expression, key, used.position,
                          fmt::format("unknown parameter \"{}\"{}", used.name, end));
      }
      names.push_back(used.name);
    }
    return names;
  } catch (const ExpressionError& error) {
    refuse_expression(expression, key, error.position(),
                      fmt::format("not a valid expression: {}", error.what()));
  }
}

double Parameters::evaluate(const TomlValue& expression, const std::string& key) const {
  std::map<std::string, double> values;
  for (const std::string& name : used_names(expression, key)) {
    values.emplace(name, values_.at(name));
    used_.insert(name);
  }
  try {
    return plumb::evaluate(expression.string, values);
  } catch (const ExpressionError& error) {
    refuse_expression(expression, key, error.position(),
                      fmt::format("not a valid expression: {}", error.what()));
  }
}

void Parameters::check_in_time(const TomlValue& expression, const std::string& key) const {
  if (by_name_.contains("t"))
    refuse(expression.place, key, expression.written,
           "t is the time here, and a parameter must have another name");
  for (const std::string& name : used_names(expression, key, "t")) used_.insert(name);
  try {
    TimeFunction(expression.string, values_);
  } catch (const ExpressionError& error) {
    refuse_expression(expression, key, error.position(),
                      fmt::format("not a valid expression: {}", error.what()));
  }
}

std::vector<std::string> Parameters::unused() const {
  std::vector<std::string> names;
  std::copy_if(names_.begin(), names_.end(), std::back_inserter(names),
               [&](const std::string& name) { return !used_.contains(name); });
  return names;
}

}  // namespace plumb
