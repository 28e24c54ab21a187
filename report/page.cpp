#include "report/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/integrate/method_info.h"
#include "engine/model/support_constraints.h"
#include "report/page_template.h"
#include "report/study_page.h"
#include "report/verdict_html.h"

namespace plumb {

extern const std::string_view page_mustache;
extern const std::string_view page_css;
extern const std::string_view study_css;
extern const std::string_view formulation_mustache;

namespace {

using kainjow::mustache::data;

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

data error_rows(const Results& results) {
  const Run& run = results.run;
  data rows{data::type::list};
  for (const SeriesError& error : results.errors) {
    const ReferenceUse& use = run.loaded.spec.references[error.reference];
    const ReferenceSeries& series = *run.loaded.references[error.reference].find(error.series);
    const double length = run.loaded.spec.cable.length;
    data row;
    row["reference"] = use.name;
    row["column"] = error.column;
    row["series"] = series.description;
    row["figure"] = series.figure;
    row["published"] = run.loaded.references[error.reference].kind == ReferenceKind::published;
    row["unit"] = error.unit;
    row["points"] = std::to_string(error.times.size());
    const bool any = !error.times.empty();
    row["max"] = any ? number(error.max) : "not run";
    row["max_time"] = any ? number(error.max_time) : "–";
    row["rms"] = any ? number(error.rms) : "not run";
    row["max_relative"] = any && error.unit == "m" ? number(error.max / length) : "–";
    row["rms_relative"] = any && error.unit == "m" ? number(error.rms / length) : "–";
    row["uncertainty"] = number(series.uncertainty);
    row["basis"] = series.uncertainty_basis;
    rows.push_back(row);
  }
  return rows;
}

data reference_rows(const Results& results) {
  data rows{data::type::list};
  const auto& references = results.run.loaded.references;
  for (std::size_t r = 0; r < references.size(); ++r) {
    const ReferenceUse& use = results.run.loaded.spec.references[r];
    data row;
    row["name"] = use.name;
    row["title"] = references[r].title;
    row["published"] = references[r].kind == ReferenceKind::published;
    row["kind"] = references[r].kind == ReferenceKind::published
                      ? "published, so it can validate"
                      : "computed, so it can verify but not validate";
    row["source"] = references[r].source;
    row["obtained"] = references[r].obtained;
    row["reason"] = use.reason;
    row["has_reason"] = !use.reason.empty();
    data notes{data::type::list};
    for (const std::string& note : references[r].notes) notes.push_back(data{"note", note});
    row.set("notes", notes);
    rows.push_back(row);
  }
  return rows;
}

data pair_row(const std::string& name, const std::string& value) {
  data row;
  row["name"] = name;
  row["value"] = value;
  return row;
}

data cost_rows(const Results& results) {
  const Trajectory& t = results.run.trajectory;
  const Counters& c = t.counters;
  const auto count = [](long n) { return n < 0 ? std::string("not counted") : std::to_string(n); };
  data rows{data::type::list};
  rows.push_back(pair_row("outcome", fmt::format("{}: {}", word(results.outcome), outcome_reason(results))));
  rows.push_back(pair_row("method", results.run.loaded.spec.method.name));
  rows.push_back(pair_row("elements", std::to_string(t.elements)));
  rows.push_back(pair_row("time reached", number(t.end_time) + " s"));
  rows.push_back(pair_row("steps (rejected)", count(c.steps) + " (" + count(c.rejected_steps) + ")"));
  if (const std::string cuts = step_cuts(t); !cuts.empty()) rows.push_back(pair_row("its step", cuts));
  rows.push_back(pair_row("force evaluations", count(c.force_evaluations)));
  rows.push_back(pair_row("tangent evaluations", count(c.tangent_evaluations)));
  rows.push_back(pair_row("factorizations of the block banded matrix", count(c.factorizations)));
  rows.push_back(pair_row("Newton iterations", count(c.newton_iterations)));
  rows.push_back(pair_row("time loop", t.solve_seconds < 0 ? "not run" : number(t.solve_seconds) + " s"));
  rows.push_back(
      pair_row("outputs (interpolated)", fmt::format("{} ({})", t.times.size(), t.interpolated_outputs)));
  if (!t.multipliers.empty()) {
    rows.push_back(pair_row("greatest drift of the joint", number(t.constraint_drift) + " m"));
    rows.push_back(
        pair_row("greatest reaction at the joint",
                 number(greatest_reaction(results.run.loaded.spec.supports, t.multipliers)) + " N"));
  }
  return rows;
}

data case_rows(const Case& spec) {
  const CableSpec& cable = spec.cable;
  const auto vector = [](const Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]); };
  const auto exact = [](double value) { return fmt::format("{:.12g}", value); };
  data rows{data::type::list};
  for (const auto& [name, value] : spec.parameters)
    rows.push_back(pair_row("parameter " + name, exact(value)));
  rows.push_back(pair_row("length L", exact(cable.length) + " m"));
  rows.push_back(pair_row("axial stiffness EA", exact(cable.youngs_modulus * cable.area) + " N"));
  rows.push_back(
      pair_row("bending stiffness EI", exact(cable.youngs_modulus * cable.second_moment) + " N m²"));
  rows.push_back(pair_row("mass per length ρA", exact(cable.density * cable.area) + " kg/m"));
  rows.push_back(pair_row("model", std::string(word(cable.model))));
  rows.push_back(pair_row("strain model", std::string(word(cable.strain))));
  if (cable.model == CableModel::cable)
    rows.push_back(pair_row("quadrature", std::string(word(cable.quadrature))));
  rows.push_back(pair_row("direction at the start", vector(spec.start.direction)));
  rows.push_back(pair_row("angular velocity at the start", vector(spec.start.angular_velocity) + " rad/s"));
  rows.push_back(pair_row("slope rates at the start", std::string(word(spec.start.slope_rates))));
  rows.push_back(
      pair_row("axial speed of the last end at the start", exact(spec.start.axial_speed) + " m/s"));
  rows.push_back(
      pair_row("supports", fmt::format("{} – {}", word(spec.supports.first), word(spec.supports.last))));
  rows.push_back(pair_row("gravity", vector(spec.loads.gravity) + " m/s²"));
  rows.push_back(pair_row("force on the last end", vector(spec.loads.end_force) + " N"));
  std::string method = spec.method.name;
  if (spec.method.step) method += fmt::format(", step {:.6g} s", *spec.method.step);
  if (spec.method.rtol)
    method += fmt::format(", rtol {:.6g}, atol {:.6g}", *spec.method.rtol, *spec.method.atol);
  for (const auto& [name, value] : spec.method.parameters) method += fmt::format(", {} {:.6g}", name, value);
  rows.push_back(pair_row("method", method));
  return rows;
}

}  // namespace

std::string to_page(const Results& results, const Pictures& pictures) {
  const Run& run = results.run;
  const Case& spec = run.loaded.spec;
  const Trajectory& trajectory = run.trajectory;

  data formulation;
  formulation["chain"] = spec.cable.model == CableModel::chain;
  formulation["green"] = spec.cable.strain == StrainModel::green_geometric;
  formulation["full"] = spec.cable.quadrature == QuadratureRule::full;
  const MethodInfo& method = *find_method(spec.method.name);
  formulation["dynamic"] = method.dynamic;
  formulation["method"] = method.name;
  formulation["method_summary"] = method.summary;
  formulation["method_order"] = method.order;
  formulation["method_source"] = method.source;

  data page;
  page["css"] = std::string(page_css) + (results.study ? std::string(study_css) : "");
  page["dynamic"] = method.dynamic;
  page["title"] = spec.title;
  page["headline"] = headline(results);
  page["good"] = results.solved() && all_passed(results.verdicts);
  page["solved"] = results.solved();
  page["ended_early"] = results.solved()
                            ? std::string()
                            : fmt::format(
                                  "Only the {:.4g} s of {:.4g} s before the run ended ({}): what is "
                                  "shown is how it failed, no result of the case.",
                                  trajectory.end_time, spec.time.end, word(trajectory.outcome));
  page["message"] = trajectory.message;
  page["outcome"] = std::string(word(trajectory.outcome));
  page["has_verdicts"] = !results.verdicts.empty();
  page["verdicts"] = verdict_html(results.verdicts);
  page["has_errors"] = !results.errors.empty();
  page["errors"] = error_rows(results);
  page["references"] = reference_rows(results);
  data figures{data::type::list};
  for (const Picture& picture : pictures.figures) {
    data row;
    row["title"] = picture.title;
    row["alt"] = picture.alt;
    row["tall"] = picture.tall;
    row["file"] = picture.file;
    row["uri"] = data_uri(picture.png);
    figures.push_back(row);
  }
  page.set("figures", figures);
  page["animation"] = data_uri(pictures.page_animation);
  page["still"] = data_uri(pictures.page_still);
  page["animation_width"] = std::to_string(pictures.page_animation_width);
  page["animation_height"] = std::to_string(pictures.page_animation_height);
  page["frames"] = std::to_string(pictures.frames);
  page["frame_rate"] = number(pictures.frame_rate);
  page["end_time"] = number(trajectory.end_time);
  page["first_kinetic"] =
      trajectory.energies.empty() ? "not run" : number(trajectory.energies.front().kinetic);
  page["drift"] = number(trajectory.energy_drift());
  page["drift_in_words"] = drift_in_words(trajectory);
  page["cost"] = cost_rows(results);
  page["formulation"] = fill_in(formulation_mustache, formulation);
  page["case_rows"] = case_rows(spec);
  set_case_and_provenance(page, run.loaded.source, run.provenance, results.stages);
  page["has_study"] = results.study != nullptr;
  if (results.study) {
    page["script_policy"] = "; " + study_script_policy();
    page["study"] = study_section(results.study->result, pictures.study);
    page["scripts"] = study_scripts(results.study->result);
  }
  return fill_in(page_mustache, page);
}

}  // namespace plumb
