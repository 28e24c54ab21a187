#include "engine/read/uncertain_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/distribution_words.h"

namespace plumb {
namespace {

struct NumberKey {
  std::string_view key;
  double value;
};

std::vector<NumberKey> numbers(const Case& spec) {
  return {{"cable.length", spec.cable.length},
          {"cable.area", spec.cable.area},
          {"cable.density", spec.cable.density},
          {"cable.youngs_modulus", spec.cable.youngs_modulus},
          {"cable.second_moment", spec.cable.second_moment},
          {"start.axial_speed", spec.start.axial_speed},
          {"start.imperfection", spec.start.imperfection}};
}

struct ListKey {
  std::string key;
  Vec3 value;
};

std::vector<ListKey> lists(const Case& spec) {
  std::vector<ListKey> all{{"start.direction", spec.start.direction},
                           {"start.angular_velocity", spec.start.angular_velocity}};
  for (const LoadKey& key : load_keys)
    all.push_back({fmt::format("loads.{}", key.name), spec.loads.*key.value});
  return all;
}

struct Value {
  std::string key;
  double value;
};

std::vector<Value> all_values(const Case& spec) {
  std::vector<Value> all;
  for (const auto& [name, value] : spec.parameters) all.push_back({"parameters." + name, value});
  for (const NumberKey& number : numbers(spec)) all.push_back({std::string(number.key), number.value});
  for (const ListKey& list : lists(spec))
    for (int k = 0; k < 3; ++k) all.push_back({fmt::format("{}.{}", list.key, k), list.value[k]});
  return all;
}

}  // namespace

std::vector<std::string> uncertain_keys(const Case& spec) {
  std::vector<std::string> keys;
  for (const Value& value : all_values(spec)) keys.push_back(value.key);
  return keys;
}

std::optional<double> uncertain_value(const Case& spec, std::string_view key) {
  for (const Value& value : all_values(spec))
    if (value.key == key) return value.value;
  return {};
}

std::vector<std::string> uncertain_overrides(const Case& spec, const std::vector<std::string>& keys,
                                             const std::vector<double>& values) {
  std::vector<std::string> overrides;
  for (const ListKey& list : lists(spec)) {
    const std::string start = fmt::format("{}.", list.key);
    if (std::any_of(keys.begin(), keys.end(), [&](const std::string& key) { return key.starts_with(start); }))
      overrides.push_back(fmt::format("{}=[{:.17g}, {:.17g}, {:.17g}]", list.key, list.value[0],
                                      list.value[1], list.value[2]));
  }
  for (std::size_t k = 0; k < keys.size(); ++k)
    overrides.push_back(fmt::format("{}={:.17g}", keys[k], values[k]));
  return overrides;
}

std::string_view word(Distribution distribution) {
  for (const auto& entry : words_of<Distribution>)
    if (entry.value == distribution) return entry.word;
  return {};
}

}  // namespace plumb
