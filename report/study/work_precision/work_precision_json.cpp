#include "report/study/work_precision/work_precision_json.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "report/document/case_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json norms_json(const ErrorNorms& norms) {
  return {{"tip_max", norms.tip_max},
          {"tip_rms", norms.tip_rms},
          {"curve", norms.curve},
          {"energy", norms.energy}};
}

Json run_json(const WorkPrecisionRun& run, double length) {
  return {{"method", method_json(run.method)},
          {"elements", run.elements},
          {"outcome", word(run.outcome)},
          {"message", run.message},
          {"stable_but_wrong", run.completed() && run.time_error.tip_max > wrong_beyond * length},
          {"work_seconds", run.work_seconds()},
          {"seconds", run.seconds},
          {"steps", run.counters.steps},
          {"rejected_steps", run.counters.rejected_steps},
          {"force_evaluations", run.counters.force_evaluations},
          {"tangent_evaluations", run.counters.tangent_evaluations},
          {"factorizations", run.counters.factorizations},
          {"newton_iterations", run.counters.newton_iterations},
          {"time_error", norms_json(run.time_error)},
          {"total_error", norms_json(run.total_error)}};
}

Json curve_json(const MethodCurve& curve) {
  return {{"label", curve.label},
          {"method", curve.method},
          {"family", word(curve.family)},
          {"elements", curve.elements},
          {"runs", curve.runs},
          {"stated_order", curve.stated_order},
          {"observed_order",
           {{"order", curve.observed.order},
            {"deviation", curve.observed.deviation},
            {"largest_step", curve.observed.largest_step},
            {"smallest_step", curve.observed.smallest_step}}},
          {"ending", curve.ending},
          {"conspicuous", curve.conspicuous}};
}

Json reference_json(const CertifiedReference& reference) {
  return {{"elements", reference.elements},
          {"first", reference.first},
          {"second", reference.second},
          {"agreement", reference.agreement},
          {"smallest_error", reference.smallest_error},
          {"certified", reference.certified},
          {"why_not", reference.why_not},
          {"floor", reference.floor}};
}

Json cheapest_json(const std::vector<CheapestRun>& cheapest) {
  Json json = Json::array();
  for (const CheapestRun& run : cheapest)
    json.push_back({{"error", run.error}, {"run", run.run}, {"in_words", run.in_words}});
  return json;
}

Json mesh_json(const MeshConvergence& mesh) {
  return {{"elements", mesh.elements},
          {"distance", mesh.distance},
          {"change", mesh.change},
          {"observed_order", mesh.observed_order},
          {"extrapolated_error", mesh.extrapolated_error},
          {"grid_convergence_index", mesh.grid_convergence_index},
          {"safety_factor", mesh.safety_factor},
          {"standard", mesh.standard}};
}

/// What is not finite has no number in JSON.
double number(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

template <typename T>
void read(const Json& json, const char* key, T& value) {
  value = json.at(key).get<T>();
}

MethodSpec method_of(const Json& json) {
  MethodSpec method;
  for (const auto& [key, value] : json.items()) {
    if (key == "name")
      method.name = value.get<std::string>();
    else if (key == "step")
      method.step = value.get<double>();
    else if (key == "rtol")
      method.rtol = value.get<double>();
    else if (key == "atol")
      method.atol = value.get<double>();
    else
      method.parameters[key] = value.get<double>();
  }
  return method;
}

Outcome outcome_of(const std::string& text) {
  const auto all = outcomes();
  const auto found = std::find_if(all.begin(), all.end(), [&](Outcome one) { return word(one) == text; });
  if (found == all.end()) throw InputError("results.json: work_precision: no outcome is called " + text);
  return *found;
}

MethodFamily family_of(const std::string& text) {
  for (const MethodFamily family :
       {MethodFamily::explicit_one_step, MethodFamily::structural, MethodFamily::implicit_stages,
        MethodFamily::multistep, MethodFamily::constrained, MethodFamily::quasi_static})
    if (word(family) == text) return family;
  throw InputError("results.json: work_precision: no family of methods is called " + text);
}

ErrorNorms norms_of(const Json& json) {
  return {number(json, "tip_max"), number(json, "tip_rms"), number(json, "curve"), number(json, "energy")};
}

WorkPrecisionRun run_of(const Json& json) {
  WorkPrecisionRun run;
  run.method = method_of(json.at("method"));
  read(json, "elements", run.elements);
  run.outcome = outcome_of(json.at("outcome").get<std::string>());
  read(json, "message", run.message);
  read(json, "seconds", run.seconds);
  read(json, "steps", run.counters.steps);
  read(json, "rejected_steps", run.counters.rejected_steps);
  read(json, "force_evaluations", run.counters.force_evaluations);
  read(json, "tangent_evaluations", run.counters.tangent_evaluations);
  read(json, "factorizations", run.counters.factorizations);
  read(json, "newton_iterations", run.counters.newton_iterations);
  run.time_error = norms_of(json.at("time_error"));
  run.total_error = norms_of(json.at("total_error"));
  return run;
}

MethodCurve curve_of(const Json& json) {
  MethodCurve curve;
  read(json, "label", curve.label);
  read(json, "method", curve.method);
  curve.family = family_of(json.at("family").get<std::string>());
  read(json, "elements", curve.elements);
  read(json, "runs", curve.runs);
  read(json, "stated_order", curve.stated_order);
  const Json& order = json.at("observed_order");
  curve.observed = {number(order, "order"), number(order, "deviation"), number(order, "largest_step"),
                    number(order, "smallest_step")};
  read(json, "ending", curve.ending);
  read(json, "conspicuous", curve.conspicuous);
  return curve;
}

CertifiedReference reference_of(const Json& json) {
  CertifiedReference reference;
  read(json, "elements", reference.elements);
  read(json, "first", reference.first);
  read(json, "second", reference.second);
  reference.agreement = number(json, "agreement");
  reference.smallest_error = number(json, "smallest_error");
  read(json, "certified", reference.certified);
  read(json, "why_not", reference.why_not);
  reference.floor = number(json, "floor");
  return reference;
}

std::vector<CheapestRun> cheapest_of(const Json& json) {
  std::vector<CheapestRun> all;
  for (const Json& item : json)
    all.push_back(
        {number(item, "error"), item.at("run").get<std::size_t>(), item.at("in_words").get<std::string>()});
  return all;
}

MeshConvergence mesh_of(const Json& json) {
  MeshConvergence mesh;
  read(json, "elements", mesh.elements);
  read(json, "distance", mesh.distance);
  read(json, "change", mesh.change);
  mesh.observed_order = number(json, "observed_order");
  mesh.extrapolated_error = number(json, "extrapolated_error");
  mesh.grid_convergence_index = number(json, "grid_convergence_index");
  mesh.safety_factor = number(json, "safety_factor");
  read(json, "standard", mesh.standard);
  return mesh;
}

/// Places in a list must lie in it.
void check_places(const std::vector<std::size_t>& places, std::size_t size) {
  for (const std::size_t place : places)
    if (place >= size)
      throw InputError("results.json: work_precision: place " + std::to_string(place) + " of a list of " +
                       std::to_string(size));
}

void check(const WorkPrecision& study) {
  for (const MethodCurve& curve : study.curves) check_places(curve.runs, study.runs.size());
  for (const auto* front : {&study.time_front, &study.total_front}) check_places(*front, study.runs.size());
  for (const auto* cheapest : {&study.time_cheapest, &study.total_cheapest})
    for (const CheapestRun& run : *cheapest) check_places({run.run}, study.runs.size());
  for (const CommonFloor& floor : study.common_floors) check_places(floor.curves, study.curves.size());
}

}  // namespace

Json work_precision_json(const WorkPrecision& study) {
  Json json{{"quick", study.quick},
            {"fixed_elements", study.fixed_elements},
            {"end", study.end},
            {"length", study.length},
            {"fastest_frequency", study.fastest_frequency},
            {"runs", Json::array()},
            {"curves", Json::array()},
            {"mesh_references", Json::array()}};
  for (const WorkPrecisionRun& run : study.runs) json["runs"].push_back(run_json(run, study.length));
  for (const MethodCurve& curve : study.curves) json["curves"].push_back(curve_json(curve));
  for (const CertifiedReference& reference : study.mesh_references)
    json["mesh_references"].push_back(reference_json(reference));
  json["converged_reference"] = reference_json(study.converged_reference);
  json["converged_mesh_error"] = study.converged_mesh_error;
  json["time_front"] = study.time_front;
  json["total_front"] = study.total_front;
  json["time_cheapest"] = cheapest_json(study.time_cheapest);
  json["total_cheapest"] = cheapest_json(study.total_cheapest);
  json["common_floors"] = Json::array();
  for (const CommonFloor& floor : study.common_floors)
    json["common_floors"].push_back({{"error", floor.error}, {"curves", floor.curves}});
  if (study.mesh) json["mesh"] = mesh_json(*study.mesh);
  for (const auto& [name, value] : study.provenance) json["provenance"][name] = value;
  return json;
}

WorkPrecision work_precision_from_json(const Json& json) {
  WorkPrecision study;
  read(json, "quick", study.quick);
  read(json, "fixed_elements", study.fixed_elements);
  study.end = number(json, "end");
  study.length = number(json, "length");
  // Reports of earlier versions have none.
  if (json.contains("fastest_frequency")) study.fastest_frequency = number(json, "fastest_frequency");
  for (const Json& item : json.at("runs")) study.runs.push_back(run_of(item));
  for (const Json& item : json.at("curves")) study.curves.push_back(curve_of(item));
  for (const Json& item : json.at("mesh_references")) study.mesh_references.push_back(reference_of(item));
  study.converged_reference = reference_of(json.at("converged_reference"));
  study.converged_mesh_error = number(json, "converged_mesh_error");
  read(json, "time_front", study.time_front);
  read(json, "total_front", study.total_front);
  study.time_cheapest = cheapest_of(json.at("time_cheapest"));
  study.total_cheapest = cheapest_of(json.at("total_cheapest"));
  for (const Json& item : json.at("common_floors"))
    study.common_floors.push_back({number(item, "error"), item.at("curves").get<std::vector<std::size_t>>()});
  if (json.contains("mesh")) study.mesh = mesh_of(json.at("mesh"));
  for (const auto& [name, value] : json.at("provenance").items())
    study.provenance.emplace_back(name, value.get<std::string>());
  check(study);
  return study;
}

}  // namespace plumb
