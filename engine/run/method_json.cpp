#include "engine/run/method_json.h"

#include <algorithm>

#include "engine/base/codec.h"
#include "engine/integrate/method_info.h"

namespace plumb {
namespace {

/// The words of a parameter; none of a number.
std::vector<std::string> words_of_parameter(const std::string& method, const std::string& name) {
  const MethodInfo* info = find_method(method);
  if (info == nullptr) return {};
  const auto found = std::find_if(info->parameters.begin(), info->parameters.end(),
                                  [&](const MethodParameter& parameter) { return parameter.name == name; });
  return found == info->parameters.end() ? std::vector<std::string>() : found->words;
}

void add_settings(ObjectWriter& a, const MethodSpec& method) {
  a("step", method.step);
  a("rtol", method.rtol);
  a("atol", method.atol);
}

}  // namespace

nlohmann::ordered_json method_json(const MethodSpec& method) {
  ObjectWriter a;
  a("name", method.name);
  add_settings(a, method);
  for (const auto& [name, value] : method.parameters) {
    const std::vector<std::string> words = words_of_parameter(method.name, name);
    if (words.empty())
      a(name.c_str(), value);
    else
      a(name.c_str(), words.at(static_cast<std::size_t>(value)));
  }
  return a.json;
}

nlohmann::ordered_json to_stored(const MethodSpec& method) {
  ObjectWriter a;
  a("name", method.name);
  a("parameters", method.parameters);
  add_settings(a, method);
  return a.json;
}

void from_stored(const nlohmann::ordered_json& json, MethodSpec& method) {
  ObjectReader a(json);
  method = {};
  a("name", method.name);
  a("step", method.step);
  a("rtol", method.rtol);
  a("atol", method.atol);
  if (a.has("parameters", true)) {
    a("parameters", method.parameters);
    return;
  }
  for (const auto& [key, value] : json.items())
    if (key != "name" && key != "step" && key != "rtol" && key != "atol") {
      const std::vector<std::string> words = words_of_parameter(method.name, key);
      if (words.empty()) {
        decode(value, method.parameters[key]);
        continue;
      }
      const auto word = std::find(words.begin(), words.end(), value.get<std::string>());
      if (word == words.end()) throw std::runtime_error("its " + key + " is unknown");
      method.parameters[key] = static_cast<double>(word - words.begin());
    }
}

}  // namespace plumb
