#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

/// Numbers in JSON, which has no word for what is not finite: null, read back as not a number.
namespace plumb {

inline nlohmann::ordered_json number_to_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

inline double number_from_json(const nlohmann::ordered_json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

inline nlohmann::ordered_json numbers_to_json(const std::vector<double>& values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const double value : values) json.push_back(number_to_json(value));
  return json;
}

inline std::vector<double> numbers_from_json(const nlohmann::ordered_json& json) {
  std::vector<double> values;
  for (const auto& value : json) values.push_back(number_from_json(value));
  return values;
}

}  // namespace plumb
