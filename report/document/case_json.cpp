#include "report/document/case_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/case/case_codec.h"
#include "engine/model/support_constraints.h"
#include "engine/run/method_json.h"
#include "engine/run/stored_parts.h"
#include "report/document/given_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

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
            {"remark", t.remark()},
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

Json modes_json(const Run& run) {
  const Vibrations& found = run.trajectory.vibrations;
  Json json{{"count", found.modes.size()},
            {"rigid_body", found.rigid_body},
            {"spin", found.spin},
            {"axis", {found.axis.x(), found.axis.y(), found.axis.z()}},
            {"orthonormality", found.orthonormality}};
  Json& kinds = json["kind"] = Json::array();
  Json& residuals = json["residual"] = Json::array();
  for (const VibrationMode& mode : found.modes) {
    kinds.push_back(word(mode.kind));
    residuals.push_back(mode.residual);
  }
  Json& columns = json["columns"] = Json::object();
  for (const Column& column : run.modes.columns)
    columns[column.name] = {{"unit", column.unit}, {"values", column.values}};
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
  Json json{{"kind", word(verdict.kind)},
            {"status", word(verdict.status)},
            {"name", verdict.name},
            {"criterion", verdict.criterion},
            {"value", verdict.value},
            {"limit", verdict.limit},
            {"unit", verdict.unit},
            {"detail", verdict.detail},
            {"message", verdict.message},
            {"reason", verdict.reason},
            {"time", std::isfinite(verdict.time) ? verdict.time : -1}};
  if (verdict.coverage) json["coverage"] = coverage_json(*verdict.coverage);
  return json;
}

Json case_json(const LoadedCase& loaded) {
  const Case& spec = loaded.spec;
  Json json;
  json["file"] = loaded.source.file.name;
  json["overrides"] = loaded.source.overrides;
  json["parameters"] = spec.parameters;
  visit_motion(spec, [&](const char* table, const auto& section) { json[table] = encode(section); });
  json["load"] = encode(spec.loads.applied);
  json["mass"] = encode(spec.masses);
  if (!reports_given_run(spec)) json["method"] = method_json(spec.method);
  if (!loaded.given_runs.empty()) json["given_runs"] = given_runs_json(loaded);
  json["time"] = encode(spec.time);
  json["probes"] = encode(spec.probes);
  json["text"] = loaded.source.file.text;
  return json;
}

}  // namespace plumb
