#include "report/study/work_precision/study_chart_data.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/figure/curve_style.h"
#include "report/study/work_precision/compared_lines.h"
#include "report/study/work_precision/work_precision_figures.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string name(ErrorNorm norm) {
  switch (norm) {
    case ErrorNorm::tip_max:
      return "tip, greatest";
    case ErrorNorm::tip_rms:
      return "tip, RMS over time";
    case ErrorNorm::curve:
      return "whole curve, RMS";
    case ErrorNorm::energy:
      break;
  }
  return "energy drift";
}

std::string word(Marker marker) {
  switch (marker) {
    case Marker::square:
      return "square";
    case Marker::diamond:
      return "diamond";
    case Marker::triangle_up:
      return "triangle-up";
    case Marker::triangle_down:
      return "triangle-down";
    case Marker::triangle_right:
      return "triangle-right";
    default:
      return "circle";
  }
}

std::string word(Dash dash) {
  return dash == Dash::solid ? "solid" : dash == Dash::dashed ? "dashed" : "dotted";
}

Json known(double value) {
  return value < 0 || !std::isfinite(value) ? Json(nullptr) : Json(value);
}

Json known(long count) {
  return count < 0 ? Json(nullptr) : Json(count);
}

Json errors_json(const ErrorNorms& norms) {
  Json json;
  for (const ErrorNorm norm : error_norm_list) json[std::string(word(norm))] = known(value(norms, norm));
  return json;
}

Json run_json(const WorkPrecisionRun& run) {
  const Counters& c = run.counters;
  Json json;
  json["method"] = run.method.name;
  json["elements"] = run.elements;
  json["setting"] = run.setting();
  json["parameters"] = Json::object();
  for (const auto& [key, value] : run.method.parameters) json["parameters"][key] = value;
  json["outcome"] = word(run.outcome);
  json["message"] = run.message;
  json["time"] = errors_json(run.time_error);
  json["total"] = errors_json(run.total_error);
  json["counters"] = {{"steps", known(c.steps)},
                      {"rejected_steps", known(c.rejected_steps)},
                      {"force_evaluations", known(c.force_evaluations)},
                      {"tangent_evaluations", known(c.tangent_evaluations)},
                      {"factorizations", known(c.factorizations)},
                      {"newton_iterations", known(c.newton_iterations)}};
  json["seconds"] = run.seconds;
  return json;
}

Json given_json(const WorkPrecision& study, const GivenCurve& curve, const Json& style) {
  Json json{{"label", label_of(study, curve)},
            {"program", curve.program.empty() ? curve.name : curve.program},
            {"threads", curve.threads},
            {"machine", machine_in_words(curve)},
            {"scaled", study.is_scaled(curve)},
            {"style", style},
            {"runs", Json::array()}};
  for (const GivenPoint& point : curve.points)
    json["runs"].push_back({{"setting", point.label},
                            {"file", point.file},
                            {"outcome", point.why_not.empty() ? "completed" : "not compared"},
                            {"message", point.why_not},
                            {"time", errors_json(point.time_error)},
                            {"total", errors_json(point.total_error)},
                            {"stated_seconds", point.seconds},
                            {"seconds", {study.work(curve, point)}}});
  return json;
}

Json style_json(const CurveStyle& style) {
  return {{"color", css(style.color)},
          {"dark", css(style.dark_color)},
          {"marker", word(style.marker)},
          {"open", style.open_marker},
          {"dash", word(style.dash)}};
}

Json floor_json(const CertifiedReference* reference) {
  if (!reference || !(reference->floor > 0)) return nullptr;
  return {{"value", reference->floor}, {"certified", reference->certified}};
}

Json chosen_json(const WorkPrecision& study, StudyQuestion question) {
  Json labels = Json::array();
  for (const StudyLine& line : chosen_lines(study, question, most_drawn_curves)) labels.push_back(line.label);
  for (std::size_t k = 0; study.timed && k < study.given_curves.size(); ++k)
    labels.push_back(label_of(study, study.given_curves[k]));
  return labels;
}

}  // namespace

std::string study_chart_data(const WorkPrecision& study) {
  const auto styles = curve_styles(study);
  Json json;
  json["fixed_elements"] = study.fixed_elements;
  json["end"] = study.end;
  json["timed"] = study.timed;
  json["wrong_beyond"] = study.length > 0 ? Json(wrong_beyond * study.length) : Json(nullptr);
  json["norms"] = Json::array();
  for (const ErrorNorm norm : error_norm_list)
    json["norms"].push_back({{"id", word(norm)}, {"name", name(norm)}, {"unit", unit(norm)}});
  json["runs"] = Json::array();
  for (const WorkPrecisionRun& run : study.runs) json["runs"].push_back(run_json(run));
  json["curves"] = Json::array();
  for (const MethodCurve& curve : study.curves)
    json["curves"].push_back({{"label", curve.label},
                              {"family", word(curve.family)},
                              {"elements", curve.elements},
                              {"style", style_json(styles.at(curve.label))},
                              {"runs", curve.runs}});
  json["given"] = Json::array();
  for (std::size_t k = 0; study.timed && k < study.given_curves.size(); ++k)
    json["given"].push_back(given_json(study, study.given_curves[k], style_json(given_style(study, k))));
  json["chosen"] = {{"time", chosen_json(study, StudyQuestion::time)},
                    {"total", chosen_json(study, StudyQuestion::total)}};
  json["front"] = {{"time", study.time_front}, {"total", study.total_front}};
  json["floor"] = {{"time", floor_json(reference_of(study, StudyQuestion::time))},
                   {"total", floor_json(reference_of(study, StudyQuestion::total))}};
  json["mesh_alone"] = Json::array();
  if (study.mesh)
    for (std::size_t k = 0; k + 1 < study.mesh->elements.size() && k < study.mesh->distance.size(); ++k)
      json["mesh_alone"].push_back(
          {{"elements", study.mesh->elements[k]}, {"distance", known(study.mesh->distance[k])}});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace plumb
