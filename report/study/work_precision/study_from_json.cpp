#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "report/study/work_precision/work_precision_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

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

StudyRun run_of(const Json& json) {
  StudyRun run;
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

StudyCurve curve_of(const Json& json) {
  StudyCurve curve;
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
  for (const StudyCurve& curve : study.curves) check_places(curve.runs, study.runs.size());
  for (const auto* front : {&study.time_front, &study.total_front}) check_places(*front, study.runs.size());
  for (const auto* cheapest : {&study.time_cheapest, &study.total_cheapest})
    for (const CheapestRun& run : *cheapest) check_places({run.run}, study.runs.size());
  for (const CommonFloor& floor : study.common_floors) check_places(floor.curves, study.curves.size());
}

}  // namespace

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
