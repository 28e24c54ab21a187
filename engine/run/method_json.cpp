#include "engine/run/method_json.h"

#include <nlohmann/json.hpp>

namespace plumb {

nlohmann::json method_to_json(const MethodSpec& method) {
  nlohmann::json json{{"name", method.name}, {"parameters", method.parameters}};
  if (method.step) json["step"] = *method.step;
  if (method.rtol) json["rtol"] = *method.rtol;
  if (method.atol) json["atol"] = *method.atol;
  return json;
}

MethodSpec method_from_json(const nlohmann::json& json) {
  MethodSpec method;
  method.name = json.at("name");
  method.parameters = json.at("parameters").get<std::map<std::string, double>>();
  if (json.contains("step")) method.step = json.at("step").get<double>();
  if (json.contains("rtol")) method.rtol = json.at("rtol").get<double>();
  if (json.contains("atol")) method.atol = json.at("atol").get<double>();
  return method;
}

}  // namespace plumb
