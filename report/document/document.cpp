#include "report/document/document.h"

#include "engine/base/document_sum.h"
#include "engine/run/stored_parts.h"
#include "report/document/case_json.h"
#include "report/document/given_json.h"
#include "report/document/report_formats.h"
#include "report/figure/panels_json.h"

namespace plumb {
namespace {

using Json = Document;

Json error_json(const SeriesError& error, const Run& run) {
  const ReferenceUse& use = run.loaded.spec.references[error.reference];
  const Reference& reference = run.loaded.references[error.reference];
  const ReferenceSeries& series = *reference.find(error.series);
  const std::string given = given_name(error, run.loaded.spec);
  Json json{{"reference", use.name},
            {"run", given.empty() ? reported_name(run.loaded.spec) : given},
            {"against", error.exact ? "exact" : "printed"},
            {"series", error.series},
            {"column", error.column},
            {"description", series.description},
            {"figure", series.figure},
            {"unit", error.unit},
            {"points", error.times.size()},
            {"missed_points", error.coverage.demanded - error.coverage.compared},
            {"interpolated_points", error.coverage.interpolated},
            {"coverage", coverage_json(error.coverage)},
            {"max", error.max},
            {"max_time", error.max_time},
            {"rms", error.rms},
            {"max_relative_to_length", error.max / run.loaded.spec.cable.length},
            {"rms_relative_to_length", error.rms / run.loaded.spec.cable.length},
            {"reference_uncertainty", error.exact ? series.exact_uncertainty : series.uncertainty},
            {"reference_uncertainty_basis",
             error.exact ? reference.exact->uncertainty_basis : series.uncertainty_basis},
            {"time", error.times},
            {"expected", error.expected},
            {"difference", error.difference}};
  if (error.print)
    json["print"] = {{"max", error.print->max},
                     {"max_time", error.print->max_time},
                     {"rms", error.print->rms},
                     {"greatest_exact", error.print->greatest}};
  if (series.model_error && !error.exact) json["model_error"] = *series.model_error;
  return json;
}

Json reference_json(const Reference& reference, const ReferenceUse& use) {
  Json json{{"name", use.name},
            {"title", reference.title},
            {"kind", reference.kind == ReferenceKind::published ? "published" : "computed"},
            {"source", reference.source},
            {"obtained", reference.obtained},
            {"reason", use.reason},
            {"notes", reference.notes}};
  if (reference.exact) json["exact"] = reference.exact->obtained;
  if (reference.model) json["model_differences"] = reference.model->differences;
  return json;
}

Json energy_json(const Trajectory& trajectory) {
  // Of an external run, which has no states, they are not known.
  if (trajectory.energies.empty() && !trajectory.times.empty()) return nullptr;
  Json json = {{"unit", "J"},
               {"drift", has_energy_to_keep(trajectory) ? Json(trajectory.energy_drift()) : Json(nullptr)},
               {"drift_relative_to_first_kinetic", trajectory.relative_energy_drift()},
               {"drift_in_words", drift_in_words(trajectory)},
               {"time", trajectory.times}};
  for (const auto& [name, part] : stored_energies()) {
    Json& values = json[name] = Json::array();
    for (const Energies& e : trajectory.energies) values.push_back(e.*part);
  }
  return json;
}

Json picture_json(const std::vector<Picture>& pictures) {
  Json json = Json::array();
  for (const Picture& picture : pictures)
    json.push_back({{"file", picture.file},
                    {"title", picture.title},
                    {"alt", picture.alt},
                    {"tall", picture.tall},
                    {"panels", panels_json(picture.plot, picture.times)}});
  return json;
}

Json animation_json(const Pictures& pictures) {
  return {{"frames", pictures.frames},
          {"first_frame", pictures.first_frame},
          {"frame_rate", pictures.frame_rate},
          {"player_frame_rate", pictures.player_frame_rate},
          {"width", pictures.page_animation_width},
          {"height", pictures.page_animation_height},
          {"notes", pictures.animation_notes}};
}

}  // namespace

bool is_figures_key(std::string_view key) {
  return key == figures_key || key.ends_with(std::string("_") + figures_key);
}

Document document_of(const Results& results, const Pictures& pictures) {
  const Run& run = results.run;
  Json json;
  json["schema_version"] = results_version;
  json["title"] = run.loaded.spec.title;
  json["headline"] = headline(results);
  json["reported"] = reported_name(run.loaded.spec);
  if (reports_given_run(run.loaded.spec))
    json["computed_by"] = computed_by(run.loaded.spec.given_runs.front());
  json["outcome"] = word(results.outcome);
  json["outcome_reason"] = outcome_reason(results);
  json["complete"] = results.solved();
  // Where there is none, nothing is met.
  json["all_criteria_met"] = results.solved() && all_met(results.verdicts);
  json["verdicts"] = Json::array();
  for (const Verdict& verdict : results.verdicts) json["verdicts"].push_back(verdict_json(verdict));
  json["solve"] = solve_json(run);
  json["errors"] = Json::array();
  for (const SeriesError& error : results.errors) json["errors"].push_back(error_json(error, run));
  json["references"] = Json::array();
  for (std::size_t r = 0; r < run.loaded.references.size(); ++r)
    json["references"].push_back(reference_json(run.loaded.references[r], run.loaded.spec.references[r]));
  json["energy"] = energy_json(run.trajectory);
  json["probes"]["t"] = {{"unit", "s"}, {"values", run.probes.times}};
  for (const Column& column : run.probes.columns)
    json["probes"][column.name] = {{"unit", column.unit}, {"values", column.values}};
  if (!run.loaded.given_runs.empty()) json["given_runs"] = given_runs_json(results);
  json[figures_key] = picture_json(pictures.figures);
  json["animation"] = animation_json(pictures);
  json["renderer"] = pictures.renderer;
  for (const RunSection& section : results.sections) {
    if (!section.key.empty()) json[section.key] = section.json;
    if (!section.figures_key.empty() && section.figures_key != figures_key)
      json[section.figures_key] = picture_json(pictures.of(section.figures_key));
  }
  json["case"] = case_json(run.loaded);
  json["seconds"] = Json::object();
  for (const auto& [name, seconds] : results.stages.all()) json["seconds"][name] = seconds;
  json["provenance"] = Json::object();
  for (const auto& [name, value] : run.provenance) json["provenance"][name] = value;
  // As the file will say it, so that a page from the file is the same: what is not finite becomes null.
  return Json::parse(to_json(json));
}

std::string to_json(const Document& document, bool has_sum) {
  if (has_sum && document.contains("schema_version")) return to_summed_text(document, 1);
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReportFormat results_json_format() {
  return {"results.json",
          [](const ReportContent& content) { return to_json(content.document, content.has_sum); }};
}

}  // namespace plumb
