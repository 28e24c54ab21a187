#include "report/study/work_precision/work_precision_json.h"

#include <nlohmann/json.hpp>

#include "report/document/case_json.h"
#include "report/study/work_precision/work_precision_results.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json norms_json(const ErrorNorms& norms) {
  return {{"tip_max", norms.tip_max},
          {"tip_rms", norms.tip_rms},
          {"curve", norms.curve},
          {"energy", norms.energy}};
}

Json run_json(const StudyRun& run, double length) {
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

Json curve_json(const StudyCurve& curve) {
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
  for (const StudyRun& run : study.runs) json["runs"].push_back(run_json(run, study.length));
  for (const StudyCurve& curve : study.curves) json["curves"].push_back(curve_json(curve));
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

std::string to_json(const StudyResults& results) {
  Json json;
  json["schema_version"] = results_version;
  json["title"] = results.study.result.title;
  json["headline"] = headline(results);
  json["all_criteria_met"] = results.any_completed() && all_passed(results.verdicts);
  json["verdicts"] = Json::array();
  for (const Verdict& verdict : results.verdicts) json["verdicts"].push_back(verdict_json(verdict));
  json["work_precision"] = work_precision_json(results.study.result);
  json["case"] = case_json(results.study.loaded);
  for (const auto& [name, seconds] : results.stages.all()) json["seconds"][name] = seconds;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumb
