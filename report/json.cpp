#include <nlohmann/json.hpp>

#include "report/case_json.h"
#include "report/results.h"
#include "report/study_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json error_json(const SeriesError& error, const Run& run) {
  const ReferenceUse& use = run.loaded.spec.references[error.reference];
  const ReferenceSeries& series = *run.loaded.references[error.reference].find(error.series);
  return {{"reference", use.name},
          {"series", error.series},
          {"column", error.column},
          {"figure", series.figure},
          {"unit", error.unit},
          {"points", error.times.size()},
          {"missed_points", error.missed},
          {"interpolated_points", error.interpolated},
          {"max", error.max},
          {"max_time", error.max_time},
          {"rms", error.rms},
          {"max_relative_to_length", error.max / run.loaded.spec.cable.length},
          {"rms_relative_to_length", error.rms / run.loaded.spec.cable.length},
          {"reference_uncertainty", series.uncertainty},
          {"reference_uncertainty_basis", series.uncertainty_basis},
          {"time", error.times},
          {"expected", error.expected},
          {"difference", error.difference}};
}

Json reference_json(const Reference& reference) {
  return {{"title", reference.title},
          {"kind", reference.kind == ReferenceKind::published ? "published" : "computed"},
          {"source", reference.source},
          {"obtained", reference.obtained},
          {"notes", reference.notes}};
}

Json energy_json(const Trajectory& trajectory) {
  Json kinetic = Json::array(), axial = Json::array(), bending = Json::array(), potential = Json::array();
  for (const Energies& e : trajectory.energies) {
    kinetic.push_back(e.kinetic);
    axial.push_back(e.axial);
    bending.push_back(e.bending);
    potential.push_back(e.potential);
  }
  return {{"unit", "J"},
          {"drift", trajectory.energy_drift()},
          {"drift_relative_to_first_kinetic", trajectory.relative_energy_drift()},
          {"kinetic", kinetic},
          {"axial", axial},
          {"bending", bending},
          {"potential", potential}};
}

}  // namespace

std::string to_json(const Results& results) {
  const Run& run = results.run;
  Json json;
  json["schema_version"] = results_version;
  json["title"] = run.loaded.spec.title;
  json["headline"] = headline(results);
  json["outcome"] = word(results.outcome);
  json["outcome_reason"] = outcome_reason(results);
  json["complete"] = results.solved();
  json["all_criteria_met"] = results.solved() && all_passed(results.verdicts);
  json["verdicts"] = Json::array();
  for (const Verdict& verdict : results.verdicts) json["verdicts"].push_back(verdict_json(verdict));
  json["solve"] = solve_json(run);
  json["errors"] = Json::array();
  for (const SeriesError& error : results.errors) json["errors"].push_back(error_json(error, run));
  json["references"] = Json::array();
  for (const Reference& reference : run.loaded.references)
    json["references"].push_back(reference_json(reference));
  json["energy"] = energy_json(run.trajectory);
  json["probes"]["t"] = {{"unit", "s"}, {"values", run.probes.times}};
  for (const Column& column : run.probes.columns)
    json["probes"][column.name] = {{"unit", column.unit}, {"values", column.values}};
  if (results.study) json["work_precision"] = work_precision_json(results.study->result);
  json["case"] = case_json(run.loaded);
  for (const auto& [name, seconds] : results.stages.all()) json["seconds"][name] = seconds;
  for (const auto& [name, value] : run.provenance) json["provenance"][name] = value;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumb
