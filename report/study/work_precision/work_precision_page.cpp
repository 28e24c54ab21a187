#include "report/study/work_precision/work_precision_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/study/work_precision/cheapest.h"
#include "report/base/escape.h"
#include "report/page/page_template.h"
#include "report/study/work_precision/compared_lines.h"
#include "report/study/work_precision/study_chart_data.h"
#include "report/study/work_precision/work_precision_conclusion.h"
#include "report/study/work_precision/work_precision_figures.h"
#include "report/study/work_precision/work_precision_json.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view study_mustache;
extern const std::string_view study_css;
extern const std::string_view study_js;
extern const std::string_view study_js_sha256;
extern const std::string_view chart_min_js;
extern const std::string_view chart_min_js_sha256;

namespace {

using kainjow::mustache::data;

constexpr std::size_t few_failures = 12;
constexpr const char* study_key = "work_precision";
constexpr const char* study_figures_key = "study_figures";
constexpr const char* study_data_id = "study-data";

std::string number(double value) {
  return value < 0 ? "–" : fmt::format("{:.3g}", value);
}

std::string count(long n) {
  return n < 0 ? "–" : std::to_string(n);
}

std::string duration(double seconds) {
  return seconds < 0 ? "not timed" : duration_in_words(seconds);
}

/// How much longer than the least the greatest repeat took.
std::string spread(const WorkPrecisionRun& run) {
  if (run.seconds.size() < 2 || !(run.work_seconds() > 0)) return "–";
  const double greatest = *std::max_element(run.seconds.begin(), run.seconds.end());
  return fmt::format("+{:.0f} % of {}", 100 * (greatest / run.work_seconds() - 1), run.seconds.size());
}

/// The label of each run's curve.
std::vector<std::string> labels_of(const WorkPrecision& study) {
  std::vector<std::string> labels(study.runs.size());
  for (const MethodCurve& curve : study.curves)
    for (const std::size_t k : curve.runs) labels[k] = curve.label;
  return labels;
}

data run_row(const WorkPrecision& study, const std::string& label, std::size_t index,
             StudyQuestion question) {
  const WorkPrecisionRun& run = study.runs[index];
  data row;
  row["label"] = label;
  row["elements"] = std::to_string(run.elements);
  row["setting"] = run.setting();
  row["seconds"] = duration(run.work_seconds());
  row["spread"] = spread(run);
  row["forces"] = count(run.counters.force_evaluations);
  row["tangents"] = count(run.counters.tangent_evaluations);
  row["error"] = number(errors_of(run, question).tip_max) + " m";
  return row;
}

std::string drawn_in_words(const WorkPrecision& study, StudyQuestion question) {
  const std::size_t all = study_lines(study, question).size();
  const std::size_t drawn = chosen_lines(study, question, most_drawn_curves).size();
  std::string text = drawn < all ? fmt::format(
                                       " At first, {} of {} are shown: the best of the front and of each "
                                       "family.",
                                       drawn, counted(static_cast<long>(all), "curve", "curves"))
                                 : "";
  text += fmt::format(
      " The wide line is the Pareto front of what is shown. Crosses at the upper edge are runs that failed; "
      "those in a circle are stable, but more than {:g} % "
      "of "
      "the length off.",
      100 * wrong_beyond);
  return text;
}

data question_values(const WorkPrecision& study, StudyQuestion question,
                     const std::vector<Picture>& pictures) {
  const bool time = question == StudyQuestion::time;
  const std::string mesh = counted(study.fixed_elements, "element", "elements");
  data values;
  values["id"] = time ? "time" : "total";
  values["title"] = time ? "How well is time integrated?" : "How close do method and mesh come together?";
  values["intro"] =
      time ? fmt::format(
                 "The mesh is that of the case, {}, and the reference is the same mesh integrated "
                 "exactly: what remains is the error of time integration alone.",
                 mesh)
           : "The reference is the solution that no longer depends on the mesh: methods and meshes compete. "
             "Where a curve turns level, a shorter step gains nothing, as it is the mesh that errs.";
  const CertifiedReference* reference = reference_of(study, question);
  values["certified"] = reference != nullptr && reference->certified;
  values["certificate"] = reference ? certificate_in_words(*reference) : "missing: no method gave one";
  const Picture* picture = find_picture(pictures, time ? time_work_figure_name : total_work_figure_name);
  if (picture) values.set("picture", picture_values(*picture, drawn_in_words(study, question)));
  values["no_picture"] = any_compared(study, question)
                             ? "The figure was not drawn."
                             : "No run could be compared, so there is nothing to draw.";

  const std::vector<std::string> labels = labels_of(study);
  data cheapest{data::type::list};
  for (const CheapestRun& entry : time ? study.time_cheapest : study.total_cheapest) {
    data row = run_row(study, labels[entry.run], entry.run, question);
    row["decade"] = fmt::format("1e{} m", std::lround(std::log10(entry.error)));
    cheapest.push_back(row);
  }
  values["has_cheapest"] = !(time ? study.time_cheapest : study.total_cheapest).empty();
  values.set("cheapest", cheapest);
  data front{data::type::list};
  std::size_t members = 0;
  for (const std::size_t k : front_of(study, question)) {
    if (fate_of(study, study.runs[k], question) != RunFate::good) continue;
    front.push_back(run_row(study, labels[k], k, question));
    ++members;
  }
  values["has_front"] = members > 0;
  values["front_count"] = std::to_string(members);
  values.set("front", front);
  return values;
}

/// What is true of the curves of other programs, as far as there are such.
std::string given_in_words(const WorkPrecision& study) {
  const auto any = [&](auto what) {
    return std::any_of(study.given_curves.begin(), study.given_curves.end(), what);
  };
  std::string text =
      "Their errors are those of the tip in their files, held against the same references; their times are "
      "what the case says. On the chart of time integration an error is the whole distance to the motion of "
      "the case's mesh, with all that their model and mesh differ by. Fronts and cheapest methods are of "
      "Plumb's own runs. Where a chart counts force evaluations they are left out.";
  if (!study.timed)
    return text + " They are on neither chart, as work is counted there and their counts are not known.";
  if (any([&](const GivenCurve& curve) { return study.is_scaled(curve); }))
    text += fmt::format(
        " Times with a yardstick are scaled to this machine by the ratio of the yardsticks, which is {} here "
        "(plumb yardstick).",
        duration_in_words(study.yardstick));
  if (any([&](const GivenCurve& curve) { return curve.is_elsewhere() && !study.is_scaled(curve); }))
    text +=
        " Hollow marks are of another machine without a yardstick: their times cannot be held against those "
        "measured here.";
  return text;
}

data given_rows(const WorkPrecision& study) {
  data rows{data::type::list};
  for (const GivenCurve& curve : study.given_curves)
    for (const GivenPoint& point : curve.points) {
      data row;
      row["name"] = curve.name;
      row["program"] = curve.program;
      row["point"] = point.label;
      row["stated"] = duration_in_words(point.seconds);
      row["threads"] = std::to_string(curve.threads);
      row["machine"] = machine_in_words(curve);
      const bool elsewhere = curve.is_elsewhere() && !study.is_scaled(curve);
      row["here"] = elsewhere || !study.timed ? "–" : duration_in_words(study.work(curve, point));
      row["time"] = number(point.time_error.tip_max);
      row["total"] = number(point.total_error.tip_max);
      row["note"] = point.why_not;
      rows.push_back(row);
    }
  return rows;
}

data order_rows(const WorkPrecision& study) {
  data rows{data::type::list};
  for (const StudyLine& line : study_lines(study, StudyQuestion::time)) {
    const MethodCurve& curve = study.curves[line.curves.front()];
    const ObservedOrder& seen = curve.observed;
    data row;
    row["label"] = line.label;
    row["family"] = std::string(word(line.family));
    row["stated"] = curve.stated_order;
    row["observed"] =
        seen.order < 0 ? "none seen" : fmt::format("{:.2f} ± {:.2f}", seen.order, seen.deviation);
    row["part"] = seen.order < 0 ? "–"
                                 : fmt::format("{} to {}", duration_in_words(seen.largest_step),
                                               duration_in_words(seen.smallest_step));
    row["ending"] = curve.ending + (curve.conspicuous ? " (flattens together with others)" : "");
    rows.push_back(row);
  }
  return rows;
}

std::string mesh_in_words(const MeshConvergence& mesh) {
  std::string text = fmt::format(
      "Each mesh integrated exactly, with the greatest distance of its tip over time to that of finer "
      "ones. ");
  if (mesh.observed_order > 0)
    text += fmt::format(
        "From the last three meshes the order is {:.2f}. Richardson's extrapolation puts the finest mesh, of "
        "{}, "
        "{:.2g} m from the continuum; its grid convergence index is {:.2g} m with a safety factor of {:g}",
        mesh.observed_order, counted(mesh.elements.back(), "element", "elements"), mesh.extrapolated_error,
        mesh.grid_convergence_index, mesh.safety_factor);
  else
    text += "The changes do not fall from mesh to mesh, so nothing can be extrapolated";
  if (!mesh.standard.empty()) text += fmt::format(" ({})", mesh.standard);
  return text + ".";
}

data mesh_values(const MeshConvergence& mesh, const std::vector<Picture>& pictures) {
  data values;
  values["words"] = mesh_in_words(mesh);
  if (const Picture* picture = find_picture(pictures, mesh_figure_name))
    values.set("mesh_picture", picture_values(*picture));
  data rows{data::type::list};
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    data row;
    row["elements"] = std::to_string(mesh.elements[k]);
    const bool finest = k + 1 == mesh.elements.size();
    row["distance"] = k < mesh.distance.size() && !finest ? number(mesh.distance[k]) : "–";
    row["change"] = k < mesh.change.size() ? number(mesh.change[k]) : "–";
    rows.push_back(row);
  }
  values.set("rows", rows);
  return values;
}

/// Each run that failed, or is wrong in the eyes of either question.
data failure_rows(const WorkPrecision& study, std::size_t& failures) {
  const std::vector<std::string> labels = labels_of(study);
  data rows{data::type::list};
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const WorkPrecisionRun& run = study.runs[k];
    std::string reason = trouble_of(study, run, StudyQuestion::time);
    const std::string total = trouble_of(study, run, StudyQuestion::total);
    const bool uncompared = run.completed() && fate_of(study, run, StudyQuestion::total) == RunFate::failed;
    // A study without a converged reference says so once, not at every run.
    if (reason.empty() && !(uncompared && !any_compared(study, StudyQuestion::total))) reason = total;
    if (reason.empty()) continue;
    data row;
    row["label"] = labels[k];
    row["elements"] = std::to_string(run.elements);
    row["setting"] = run.setting();
    row["outcome"] = std::string(word(run.outcome));
    row["seconds"] = duration(run.work_seconds());
    row["reason"] = reason;
    rows.push_back(row);
    ++failures;
  }
  return rows;
}

data reference_rows(const WorkPrecision& study) {
  data rows{data::type::list};
  const auto add = [&](const CertifiedReference& reference, bool converged) {
    data row;
    row["elements"] = std::to_string(reference.elements);
    row["converged"] = converged;
    row["first"] = reference.first;
    row["second"] = reference.second;
    row["agreement"] = number(reference.agreement);
    row["smallest"] = number(reference.smallest_error);
    row["floor"] = reference.floor > 0 ? number(reference.floor) : "–";
    row["certified"] = reference.certified;
    row["why_not"] = reference.certified ? "" : reference.why_not;
    rows.push_back(row);
  };
  for (const CertifiedReference& reference : study.mesh_references) add(reference, false);
  if (study.converged_reference.elements > 0) add(study.converged_reference, true);
  return rows;
}

data floor_rows(const WorkPrecision& study) {
  data rows{data::type::list};
  for (const CommonFloor& floor : study.common_floors) {
    std::string names;
    for (const std::size_t c : floor.curves) names += (names.empty() ? "" : "; ") + study.curves[c].label;
    data row;
    row["text"] = fmt::format("{} all stop at {:.2g} m.", names, floor.error);
    rows.push_back(row);
  }
  return rows;
}

/// Studies of earlier versions do not say it.
std::string how_timed(const WorkPrecision& study) {
  for (const auto& [name, value] : study.provenance)
    if (name == "timing") return value;
  return "one run at a time on one core";
}

std::string summary(const WorkPrecision& study) {
  const auto completed = std::count_if(study.runs.begin(), study.runs.end(),
                                       [](const WorkPrecisionRun& run) { return run.completed(); });
  std::set<std::string> labels;
  std::set<int> meshes;
  for (const MethodCurve& curve : study.curves) {
    labels.insert(curve.label);
    meshes.insert(curve.elements);
  }
  std::string of_meshes;
  for (const int mesh : meshes)
    of_meshes += fmt::format("{}{}",
                             of_meshes.empty()          ? ""
                             : mesh == *meshes.rbegin() ? " and "
                                                        : ", ",
                             mesh);
  return fmt::format(
      "{}{} over {:.4g} s: {} of {} completed, {} on {} of {} elements. Work is {}; an error is the greatest "
      "distance of the tip over time, "
      "where nothing else is said.",
      study.quick ? "A short study: " : "",
      counted(static_cast<long>(labels.size()), "variant of a method", "variants of methods"), study.end,
      completed, counted(static_cast<long>(study.runs.size()), "run", "runs"),
      "each with several steps or tolerances", meshes.size() == 1 ? "a mesh" : "meshes", of_meshes,
      study.timed ? fmt::format("the least time of the time loop over repeats, {}", how_timed(study))
                  : "counted in force evaluations, as the runs were computed on unlike machines, whose times "
                    "cannot be held against one another");
}

/// What to choose: for some accuracies, and for each mesh.
void set_conclusion(data& values, const WorkPrecision& study) {
  const WorkPrecisionConclusion conclusion = conclude(study);
  const std::vector<std::string> labels = labels_of(study);
  const StudyQuestion question = conclusion.of_time_alone ? StudyQuestion::time : StudyQuestion::total;
  const auto row_of = [&](std::size_t run) {
    data row = run_row(study, labels[run], run, question);
    row["cost"] = study.work_in_words(study.work(study.runs[run]));
    return row;
  };
  data ways{data::type::list}, meshes{data::type::list}, failing{data::type::list};
  for (const CheapestRun& way : conclusion.ways) {
    data row = row_of(way.run);
    row["within"] = fmt::format("1e{} m", std::lround(std::log10(way.error)));
    ways.push_back(row);
  }
  bool known = false;
  for (const MeshAdvice& mesh : conclusion.meshes) {
    data row;
    if (mesh.run) row = row_of(*mesh.run);
    row["has_run"] = mesh.run.has_value();
    row["mesh"] = std::to_string(mesh.elements);
    row["mesh_error"] = mesh.error >= 0 ? number(mesh.error) + " m" : "not known";
    meshes.push_back(row);
    known = known || mesh.error >= 0;
  }
  for (const FailingCurve& one : conclusion.failing) {
    const WorkPrecisionRun& run = study.runs[one.run];
    data row;
    row["label"] = study.curves[one.curve].label;
    row["from"] = one.everywhere ? "every one that was tried" : run.setting() + " and coarser";
    row["how"] = how_it_fails(run);
    failing.push_back(row);
  }
  values["of_time_alone"] = conclusion.of_time_alone;
  values["has_ways"] = !conclusion.ways.empty();
  values.set("ways", ways);
  values["has_meshes"] = known;
  values.set("meshes", meshes);
  values["has_failing"] = !conclusion.failing.empty();
  values["failing_count"] = counted(std::ssize(conclusion.failing), "curve", "curves");
  values.set("failing", failing);
}

std::string study_html(const WorkPrecision& study, const std::vector<Picture>& pictures) {
  data values;
  values["summary"] = summary(study);
  set_conclusion(values, study);
  values["fixed"] = counted(study.fixed_elements, "element", "elements");
  values["has_floors"] = !study.common_floors.empty();
  values["floors"] = floor_rows(study);
  data questions{data::type::list};
  for (const StudyQuestion question : {StudyQuestion::time, StudyQuestion::total})
    questions.push_back(question_values(study, question, pictures));
  values.set("questions", questions);
  values["has_given"] = !study.given_curves.empty();
  if (!study.given_curves.empty()) values["given_words"] = given_in_words(study);
  values["given"] = given_rows(study);
  values["has_orders"] = !study_lines(study, StudyQuestion::time).empty();
  values["orders"] = order_rows(study);
  if (const Picture* picture = find_picture(pictures, order_figure_name))
    values.set("order_picture", picture_values(*picture));
  if (study.mesh && !study.mesh->elements.empty()) values.set("mesh", mesh_values(*study.mesh, pictures));
  std::size_t failures = 0;
  values["failures"] = failure_rows(study, failures);
  values["has_failures"] = failures > 0;
  values["few_failures"] = failures <= few_failures;
  values["failure_count"] = counted(static_cast<long>(failures), "run", "runs");
  values["has_references"] = !study.mesh_references.empty() || study.converged_reference.elements > 0;
  values["references"] = reference_rows(study);
  return fill_in(study_mustache, values);
}

}  // namespace

RunSection work_precision_section(const WorkPrecision& study) {
  return {.key = study_key,
          .json = work_precision_json(study),
          .figures_key = study_figures_key,
          .drawing_stage = "study figures",
          .figures = [study] { return study_figures(study); }};
}

PageSection work_precision_on_page() {
  return {.key = study_key,
          .place = PagePlace::cost,
          .id = "study",
          .link = "Speed against accuracy",
          .title = "Speed against accuracy",
          .html =
              [](const Document& json, const std::vector<Picture>& pictures) {
                const WorkPrecision study = work_precision_from_json(json);
                const WorkPrecisionConclusion conclusion = conclude(study);
                return fmt::format("<p><span class=\"sentence\">{}</span> {}</p>\n",
                                   escape_xml(conclusion.sentence), escape_xml(conclusion.details)) +
                       study_html(study, pictures);
              },
          .figures_key = study_figures_key,
          .css = study_css,
          .script = {study_js, study_js_sha256},
          .data_id = study_data_id,
          .data = [](const Document& json) { return study_chart_data(work_precision_from_json(json)); },
          .clause = mesh_clause};
}

std::string mesh_clause(const Document& document) {
  if (document.contains("computed_by")) return "";
  if (!document.contains(study_key) || !document.at(study_key).contains("mesh")) return "";
  const Document &study = document.at(study_key), &mesh = study.at("mesh");
  const auto elements = mesh.at("elements").get<std::vector<long>>();
  const auto own =
      std::find(elements.begin(), elements.end(), document.at("solve").at("elements").get<long>());
  if (elements.empty() || own == elements.end() || own + 1 == elements.end()) return "";
  const Document& distance = mesh.at("distance").at(static_cast<std::size_t>(own - elements.begin()));
  if (!distance.is_number() || !(distance.get<double>() > 0)) return "";
  return fmt::format("the mesh itself is {} m from that of {} elements over {} s",
                     number(distance.get<double>()), elements.back(), number(study.at("end").get<double>()));
}

StudySection shown_work_precision(const WorkPrecision& study, const std::vector<Picture>& pictures) {
  StudySection section;
  section.links = {
      {"study-choice", "What to choose"}, {"study-time", "Time integration"}, {"study-total", "Total error"}};
  if (!study.given_curves.empty()) section.links.emplace_back("study-given", "Other programs");
  if (!study_lines(study, StudyQuestion::time).empty()) section.links.emplace_back("study-orders", "Orders");
  if (study.mesh) section.links.emplace_back("study-mesh", "Mesh");
  section.links.emplace_back("study-failures", "Failures");
  section.html = study_html(study, pictures);
  section.data = data_element(study_data_id, study_chart_data(study));
  section.scripts = {{chart_min_js, chart_min_js_sha256}, {study_js, study_js_sha256}};
  section.verdict_note =
      "All are <strong>verification</strong>: of the references, and of each method's order where its curve "
      "shows one.";
  return section;
}

}  // namespace plumb
