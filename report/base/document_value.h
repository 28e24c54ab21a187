#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace plumb {

/// A report as data: all that its page, junit.xml and summary.md say. Keys as in output/README.md.
using Document = nlohmann::ordered_json;

/// The text that an object has under a key. Throws nlohmann::json::exception where it has none.
template <typename Json>
std::string text_of(const Json& object, const char* key) {
  return object.at(key).template get<std::string>();
}

/// A number, which is not a number where null stands for one that is not finite.
inline double number_of(const Document& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// A number of a table, "1.234e-05"; "not finite" where it is none.
std::string four_digits(double value);
/// The same of a document, in which null stands for what is not finite.
std::string four_digits(const Document& value);

}  // namespace plumb
