#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/message.h"

/// The one way of every type to JSON and back. A type states its members once, in its own namespace:
///
///     template <class Archive>
///     void members(Archive& a, Candidate& candidate) {
///       a("elements", candidate.elements);
///     }
///
/// and an enumeration its values, as `enum_values(E)` beside `word(E)`. What is kept in another form has
/// `nlohmann::ordered_json to_stored(const T&)` and `void from_stored(const nlohmann::ordered_json&, T&)`.
/// An optional without a value is left out.
namespace plumb {

/// How a number that is not finite is written: as the string "inf", "-inf" or "nan", or as null, which
/// results.json has and nothing reads back.
enum class NotFinite { word, null };

template <class T>
nlohmann::ordered_json encode(const T& value, NotFinite not_finite = NotFinite::word);
/// Throws std::runtime_error or nlohmann::json::exception where something is missing or of the wrong type.
template <class T>
void decode(const nlohmann::ordered_json& json, T& value);

template <class T>
T decoded(const nlohmann::ordered_json& json) {
  T value{};
  decode(json, value);
  return value;
}

class ObjectWriter {
 public:
  explicit ObjectWriter(NotFinite not_finite = NotFinite::word) : not_finite_(not_finite) {}

  template <class T>
  void operator()(const char* name, const T& value) {
    json[name] = encode(value, not_finite_);
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value) {
    if (value) json[name] = encode(*value, not_finite_);
  }

  nlohmann::ordered_json json = nlohmann::ordered_json::object();

 private:
  NotFinite not_finite_;
};

class ObjectReader {
 public:
  explicit ObjectReader(const nlohmann::ordered_json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, T& value) {
    decode(json_.at(name), value);
  }
  template <class T>
  void operator()(const char* name, std::optional<T>& value) {
    if (json_.contains(name)) decode(json_.at(name), value.emplace());
  }

 private:
  const nlohmann::ordered_json& json_;
};

namespace codec {

template <class T>
struct IsList : std::false_type {};
template <class T>
struct IsList<std::vector<T>> : std::true_type {};
template <class T, std::size_t n>
struct IsList<std::array<T, n>> : std::true_type {};
template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t n>
struct IsArray<std::array<T, n>> : std::true_type {};
template <class T>
struct IsMap : std::false_type {};
template <class T>
struct IsMap<std::map<std::string, T>> : std::true_type {};
template <class T>
struct IsPairs : std::false_type {};
template <>
struct IsPairs<std::vector<std::pair<std::string, std::string>>> : std::true_type {};

inline double number(const nlohmann::ordered_json& json) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (json.is_number()) return json.get<double>();
  if (!json.is_string()) throw std::runtime_error("a number is missing");
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf" || json == "-inf") return json == "inf" ? infinity : -infinity;
  throw std::runtime_error(one_line(fmt::format("'{}' is no number", json.get<std::string>())));
}

}  // namespace codec

template <class T>
nlohmann::ordered_json encode(const T& value, NotFinite not_finite) {
  using Json = nlohmann::ordered_json;
  if constexpr (requires { to_stored(value); }) {
    return to_stored(value);
  } else if constexpr (std::is_same_v<T, double>) {
    if (std::isfinite(value)) return value;
    if (not_finite == NotFinite::null) return nullptr;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  } else if constexpr (std::is_enum_v<T>) {
    return word(value);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (codec::IsPairs<T>::value) {
    Json list = Json::array();
    for (const auto& [name, of_it] : value) list.push_back({{"name", name}, {"value", of_it}});
    return list;
  } else if constexpr (codec::IsList<T>::value) {
    Json list = Json::array();
    for (const auto& item : value) list.push_back(encode(item, not_finite));
    return list;
  } else if constexpr (codec::IsMap<T>::value) {
    Json object = Json::object();
    for (const auto& [name, item] : value) object[name] = encode(item, not_finite);
    return object;
  } else {
    ObjectWriter writer(not_finite);
    members(writer, const_cast<T&>(value));  // which only reads
    return std::move(writer.json);
  }
}

template <class T>
void decode(const nlohmann::ordered_json& json, T& value) {
  if constexpr (requires { from_stored(json, value); }) {
    from_stored(json, value);
  } else if constexpr (std::is_same_v<T, double>) {
    value = codec::number(json);
  } else if constexpr (std::is_enum_v<T>) {
    const auto name = json.get<std::string>();
    for (const T any : enum_values(value))
      if (word(any) == name) {
        value = any;
        return;
      }
    throw std::runtime_error(one_line(fmt::format("'{}' is no word for it", name)));
  } else if constexpr (std::is_same_v<T, bool>) {
    value = json.get<bool>();
  } else if constexpr (std::is_integral_v<T>) {
    if (!json.is_number_integer()) throw std::runtime_error("a whole number is missing");
    value = json.get<T>();
  } else if constexpr (std::is_same_v<T, std::string>) {
    value = one_line(json.get<std::string>());
  } else if constexpr (codec::IsPairs<T>::value) {
    if (json.is_object())  // which earlier versions wrote
      for (const auto& [name, of_it] : json.items())
        value.emplace_back(one_line(name), one_line(of_it.template get<std::string>()));
    else if (!json.is_array())
      throw std::runtime_error("a list is missing");
    else
      for (const auto& item : json)
        value.emplace_back(one_line(item.at("name").template get<std::string>()),
                           one_line(item.at("value").template get<std::string>()));
  } else if constexpr (codec::IsArray<T>::value) {
    if (!json.is_array() || json.size() != value.size())
      throw std::runtime_error(fmt::format("a list of {} is missing", value.size()));
    for (std::size_t k = 0; k < value.size(); ++k) decode(json[k], value[k]);
  } else if constexpr (codec::IsList<T>::value) {
    if (!json.is_array()) throw std::runtime_error("a list is missing");
    value.clear();
    for (const auto& item : json) decode(item, value.emplace_back());
  } else if constexpr (codec::IsMap<T>::value) {
    if (!json.is_object()) throw std::runtime_error("an object is missing");
    for (const auto& [name, item] : json.items()) decode(item, value[name]);
  } else {
    ObjectReader reader(json);
    members(reader, value);
  }
}

}  // namespace plumb
