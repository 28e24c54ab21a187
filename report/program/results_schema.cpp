#include "report/program/results_schema.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/case/case_words.h"
#include "report/program/study_kinds.h"

namespace plumb {

extern const std::string_view results_schema_json;

namespace {

using Json = nlohmann::ordered_json;

template <class Spec>
Json table_schema(const Spec& spec);

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
Json type_of(const T&) {
  if constexpr (std::is_enum_v<T>) {
    Json words = Json::array();
    for (const auto& known : words_of<T>) words.push_back(known.word);
    return {{"enum", words}};
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return {{"$ref", "#/$defs/vector"}};
  } else if constexpr (IsOptional<T>::value) {
    return table_schema(typename T::value_type());
  } else if constexpr (std::is_same_v<T, std::string>) {
    return {{"type", "string"}};
  } else {
    return {{"type", std::is_same_v<T, int> ? "integer" : "number"}};
  }
}

template <class Spec>
Json table_schema(const Spec& spec) {
  Json properties, required = Json::array();
  visit_keys(spec, [&](const Key& key, const auto& field) {
    Json& schema = properties[std::string(key.name)] = type_of(field);
    if (!key.range.unit.empty()) schema["description"] = key.range.unit;
    if (!IsOptional<std::remove_cvref_t<decltype(field)>>::value) required.push_back(key.name);
  });
  return {{"type", "object"},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

}  // namespace

std::string results_schema() {
  Json schema = Json::parse(results_schema_json);
  Json& tables = schema["$defs"]["case"]["properties"];
  const Case spec;
  visit_motion(spec, [&](const char* name, const auto& table) { tables[name] = table_schema(table); });
  tables["time"] = table_schema(spec.time);
  tables["probes"]["items"] = table_schema(ProbeSpec());
  Json& study = schema["$defs"]["study"];
  for (const StudyKind& kind : study_kinds()) {
    std::string key = kind.name;
    std::replace(key.begin(), key.end(), '-', '_');
    schema["$defs"][key + "_study"] = Json::parse(kind.schema);
    study["properties"][key] = {{"$ref", "#/$defs/" + key + "_study"}};
    study["oneOf"].push_back({{"required", Json::array({key})}});
  }
  return schema.dump(1) + "\n";
}

}  // namespace plumb
