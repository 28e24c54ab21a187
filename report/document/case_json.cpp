#include "report/document/case_json.h"

#include <nlohmann/json.hpp>

#include "engine/base/codec.h"
#include "engine/integrate/method_info.h"
#include "engine/model/support_constraints.h"
#include "engine/run/stored_parts.h"
#include "report/document/given_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

Json equilibria_json(const Equilibria& equilibria) {
  const auto column = [&](auto PathPoint::*member) {
    Json values = Json::array();
    for (const PathPoint& point : equilibria.path) values.push_back(point.*member);
    return values;
  };
  return {{"negative_eigenvalues", equilibria.negative_eigenvalues},
          {"critical_points", encode(equilibria.critical_points)},
          {"path",
           {{"load", column(&PathPoint::load)},
            {"displacement", column(&PathPoint::displacement)},
            {"negative_eigenvalues", column(&PathPoint::negative)},
            {"joined", column(&PathPoint::joined)}}}};
}

}  // namespace

Json solve_json(const Run& run) {
  const Trajectory& t = run.trajectory;
  Json json{{"outcome", word(t.outcome)},
            {"message", t.message},
            {"method", reports_given_run(run.loaded.spec) ? "given" : run.loaded.spec.method.name},
            {"elements", t.elements},
            {"end_time", t.end_time},
            {"outputs", t.times.size()},
            {"interpolated_outputs", t.interpolated_outputs},
            {"solve_seconds", t.solve_seconds},
            {"steps", t.counters.steps},
            {"rejected_steps", t.counters.rejected_steps},
            {"shortest_cut", t.shortest_cut},
            {"force_evaluations", t.counters.force_evaluations},
            {"tangent_evaluations", t.counters.tangent_evaluations},
            {"factorizations", t.counters.factorizations},
            {"newton_iterations", t.counters.newton_iterations},
            {"energy_drift", t.relative_energy_drift()},
            {"constraint_drift", t.constraint_drift},
            {"greatest_reaction",
             t.multipliers.empty() ? -1 : greatest_reaction(run.loaded.spec.supports, t.multipliers)}};
  if (!t.equilibria.path.empty()) json["equilibria"] = equilibria_json(t.equilibria);
  return json;
}

Json coverage_json(const Coverage& coverage) {
  return {{"demanded", coverage.demanded},
          {"compared", coverage.compared},
          {"interpolated", coverage.interpolated},
          {"first", coverage.first},
          {"last", coverage.last},
          {"longest_gap", coverage.longest_gap},
          {"interpolation_error", coverage.interpolation_error},
          {"share", coverage.share},
          {"allowance", coverage.allowance},
          {"lacking", coverage.lacking}};
}

Json verdict_json(const Verdict& verdict) {
  Json json{{"kind", word(verdict.kind)},     {"status", word(verdict.status)}, {"name", verdict.name},
            {"criterion", verdict.criterion}, {"value", verdict.value},         {"limit", verdict.limit},
            {"unit", verdict.unit},           {"detail", verdict.detail},       {"message", verdict.message},
            {"reason", verdict.reason}};
  if (verdict.coverage) json["coverage"] = coverage_json(*verdict.coverage);
  return json;
}

Json method_json(const MethodSpec& method) {
  Json json{{"name", method.name}};
  if (method.step) json["step"] = *method.step;
  if (method.rtol) json["rtol"] = *method.rtol;
  if (method.atol) json["atol"] = *method.atol;
  for (const auto& [name, value] : method.parameters) json[name] = value;
  if (const MethodInfo* info = find_method(method.name))
    for (const MethodParameter& parameter : info->parameters)
      if (!parameter.words.empty() && method.parameters.contains(parameter.name))
        json[parameter.name] =
            parameter.words.at(static_cast<std::size_t>(method.parameters.at(parameter.name)));
  return json;
}

Json case_json(const LoadedCase& loaded) {
  const Case& spec = loaded.spec;
  Json json;
  json["file"] = loaded.source.file.name;
  json["overrides"] = loaded.source.overrides;
  json["parameters"] = spec.parameters;
  json["cable"] = {{"length", spec.cable.length},
                   {"area", spec.cable.area},
                   {"density", spec.cable.density},
                   {"youngs_modulus", spec.cable.youngs_modulus},
                   {"second_moment", spec.cable.second_moment},
                   {"elements", spec.cable.elements},
                   {"model", word(spec.cable.model)},
                   {"strain", word(spec.cable.strain)},
                   {"quadrature", word(spec.cable.quadrature)}};
  json["start"] = {{"direction", vector_json(spec.start.direction)},
                   {"angular_velocity", vector_json(spec.start.angular_velocity)},
                   {"slope_rates", word(spec.start.slope_rates)},
                   {"axial_speed", spec.start.axial_speed},
                   {"imperfection", spec.start.imperfection}};
  json["supports"] = {{"first", word(spec.supports.first)}, {"last", word(spec.supports.last)}};
  for (const LoadKey& key : load_keys)
    json["loads"][std::string(key.name)] = vector_json(spec.loads.*key.value);
  if (!reports_given_run(spec)) json["method"] = method_json(spec.method);
  if (!loaded.given_runs.empty()) json["given_runs"] = given_runs_json(loaded);
  json["time"] = {{"end", spec.time.end}, {"output_interval", spec.time.output_interval}};
  json["probes"] = Json::array();
  for (const ProbeSpec& probe : spec.probes)
    json["probes"].push_back({{"name", probe.name}, {"at", probe.at}, {"quantity", word(probe.quantity)}});
  json["text"] = loaded.source.file.text;
  return json;
}

}  // namespace plumb
