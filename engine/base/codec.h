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
/// An optional without a value is left out. `a.said(name, value)` writes what follows from the members for
/// those who read the file otherwise, with `value()`; it is not read back.
namespace plumb {

/// How a number that is not finite is written: as the string "inf", "-inf" or "nan", or as null, as in
/// results.json, which is read back as not a number.
enum class NotFinite { word, null };

template <class T>
nlohmann::ordered_json encode(const T& value, NotFinite not_finite = NotFinite::word);
/// Throws std::runtime_error or nlohmann::json::exception where something is missing or of the wrong type.
template <class T>
void decode(const nlohmann::ordered_json& json, T& value, NotFinite not_finite = NotFinite::word);

template <class T>
T decoded(const nlohmann::ordered_json& json, NotFinite not_finite = NotFinite::word) {
  T value{};
  decode(json, value, not_finite);
  return value;
}

class ObjectWriter {
 public:
  static constexpr bool reads = false;

  explicit ObjectWriter(NotFinite not_finite = NotFinite::word) : not_finite_(not_finite) {}

  template <class T>
  void operator()(const char* name, const T& value) {
    json[name] = encode(value, not_finite_);
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value) {
    if (value) json[name] = encode(*value, not_finite_);
  }
  template <class Value>
  void said(const char* name, const Value& value) {
    json[name] = encode(value(), not_finite_);
  }
  /// Whether there is something of that name: what the type says, or what the file has.
  bool has(const char*, bool there) const { return there; }

  nlohmann::ordered_json json = nlohmann::ordered_json::object();

 private:
  NotFinite not_finite_;
};

class ObjectReader {
 public:
  static constexpr bool reads = true;

  explicit ObjectReader(const nlohmann::ordered_json& json, NotFinite not_finite = NotFinite::word)
      : json_(json), not_finite_(not_finite) {}

  template <class T>
  void operator()(const char* name, T& value) {
    decode(json_.at(name), value, not_finite_);
  }
  template <class T>
  void operator()(const char* name, std::optional<T>& value) {
    if (json_.contains(name)) decode(json_.at(name), value.emplace(), not_finite_);
  }
  template <class Value>
  void said(const char*, const Value&) {}
  bool has(const char* name, bool) const { return json_.contains(name); }

 private:
  const nlohmann::ordered_json& json_;
  NotFinite not_finite_;
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

/// A list of a fixed length, as vectors and matrices of Eigen are.
template <class T>
concept IsFixed = IsArray<T>::value || requires {
  T::SizeAtCompileTime;
};

inline double number(const nlohmann::ordered_json& json, NotFinite not_finite) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (json.is_number()) return json.get<double>();
  if (json.is_null() && not_finite == NotFinite::null) return std::numeric_limits<double>::quiet_NaN();
  if (!json.is_string()) throw std::runtime_error("a number is missing");
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf" || json == "-inf") return json == "inf" ? infinity : -infinity;
  throw std::runtime_error(one_line(fmt::format("'{}' is no number", json.get<std::string>())));
}

/// By the members, where a type has another way to JSON besides.
template <class T>
nlohmann::ordered_json encode_members(const T& value, NotFinite not_finite) {
  ObjectWriter writer(not_finite);
  members(writer, const_cast<T&>(value));  // which only reads
  return std::move(writer.json);
}
template <class T>
void decode_members(const nlohmann::ordered_json& json, T& value, NotFinite not_finite) {
  ObjectReader reader(json, not_finite);
  members(reader, value);
}

}  // namespace codec

template <class T>
nlohmann::ordered_json encode(const T& value, NotFinite not_finite) {
  using Json = nlohmann::ordered_json;
  if constexpr (requires { to_stored(value); }) {
    return to_stored(value);
  } else if constexpr (std::is_same_v<T, Json>) {
    return value;
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
  } else if constexpr (codec::IsList<T>::value || codec::IsFixed<T>) {
    Json list = Json::array();
    for (const auto& item : value) list.push_back(encode(item, not_finite));
    return list;
  } else if constexpr (codec::IsMap<T>::value) {
    Json object = Json::object();
    for (const auto& [name, item] : value) object[name] = encode(item, not_finite);
    return object;
  } else {
    return codec::encode_members(value, not_finite);
  }
}

template <class T>
void decode(const nlohmann::ordered_json& json, T& value, NotFinite not_finite) {
  if constexpr (requires { from_stored(json, value); }) {
    from_stored(json, value);
  } else if constexpr (std::is_same_v<T, double>) {
    value = codec::number(json, not_finite);
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
  } else if constexpr (codec::IsFixed<T>) {
    if (!json.is_array() || json.size() != static_cast<std::size_t>(value.size()))
      throw std::runtime_error(fmt::format("a list of {} is missing", value.size()));
    auto item = value.begin();
    for (const auto& stored : json) decode(stored, *item++, not_finite);
  } else if constexpr (codec::IsList<T>::value) {
    if (!json.is_array()) throw std::runtime_error("a list is missing");
    value.clear();
    for (const auto& item : json) decode(item, value.emplace_back(), not_finite);
  } else if constexpr (codec::IsMap<T>::value) {
    if (!json.is_object()) throw std::runtime_error("an object is missing");
    for (const auto& [name, item] : json.items()) decode(item, value[name], not_finite);
  } else {
    codec::decode_members(json, value, not_finite);
  }
}

}  // namespace plumb
