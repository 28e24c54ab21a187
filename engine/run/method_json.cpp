#include "engine/run/method_json.h"

#include "engine/base/codec.h"

namespace plumb {
namespace {

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
  for (const auto& [name, value] : method.parameters) a(name.c_str(), value);
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
    if (key != "name" && key != "step" && key != "rtol" && key != "atol")
      decode(value, method.parameters[key]);
}

}  // namespace plumb
