#include "report/study/work_precision/work_precision_json.h"

#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/study/work_precision/work_precision_members.h"
#include "report/study/work_precision/work_precision_conclusion.h"

namespace plumb {

inline std::array<MethodFamily, 7> enum_values(MethodFamily) {
  return {MethodFamily::explicit_one_step,
          MethodFamily::structural,
          MethodFamily::implicit_stages,
          MethodFamily::multistep,
          MethodFamily::constrained,
          MethodFamily::quasi_static,
          MethodFamily::modal};
}

template <class Archive>
void members(Archive& a, ObservedOrder& observed) {
  a("order", observed.order);
  a("deviation", observed.deviation);
  a("largest_step", observed.largest_step);
  a("smallest_step", observed.smallest_step);
}

template <class Archive>
void members(Archive& a, MethodCurve& curve) {
  a("label", curve.label);
  a("method", curve.method);
  a("family", curve.family);
  a("elements", curve.elements);
  a("runs", curve.runs);
  a("stated_order", curve.stated_order);
  a("observed_order", curve.observed);
  a("ending", curve.ending);
  a("conspicuous", curve.conspicuous);
}

template <class Archive>
void members(Archive& a, CertifiedReference& reference) {
  a("elements", reference.elements);
  a("first", reference.first);
  a("second", reference.second);
  a("agreement", reference.agreement);
  a("smallest_error", reference.smallest_error);
  a("certified", reference.certified);
  a("why_not", reference.why_not);
  a("floor", reference.floor);
}

template <class Archive>
void members(Archive& a, CheapestRun& cheapest) {
  a("error", cheapest.error);
  a("run", cheapest.run);
  a("in_words", cheapest.in_words);
}

template <class Archive>
void members(Archive& a, CommonFloor& floor) {
  a("error", floor.error);
  a("curves", floor.curves);
}

template <class Archive>
void members(Archive& a, MeshConvergence& mesh) {
  a("elements", mesh.elements);
  a("distance", mesh.distance);
  a("change", mesh.change);
  a("observed_order", mesh.observed_order);
  a("extrapolated_error", mesh.extrapolated_error);
  a("grid_convergence_index", mesh.grid_convergence_index);
  a("safety_factor", mesh.safety_factor);
  a("standard", mesh.standard);
}

namespace {

/// All but its runs and its provenance.
template <class Archive>
void members_of_study(Archive& a, WorkPrecision& study) {
  a("quick", study.quick);
  a("fixed_elements", study.fixed_elements);
  a("end", study.end);
  a("length", study.length);
  // Reports of earlier versions have none.
  if (a.has("fastest_frequency", true)) a("fastest_frequency", study.fastest_frequency);
  a("curves", study.curves);
  a("mesh_references", study.mesh_references);
  a("converged_reference", study.converged_reference);
  a("converged_mesh_error", study.converged_mesh_error);
  a("time_front", study.time_front);
  a("total_front", study.total_front);
  a("time_cheapest", study.time_cheapest);
  a("total_cheapest", study.total_cheapest);
  a("common_floors", study.common_floors);
  a("mesh", study.mesh);
  if (a.has("yardstick", true)) a("yardstick", study.yardstick);
}

/// A run as reports have it, whose counters stand beside all else.
template <class Archive>
void members_of_run(Archive& a, WorkPrecisionRun& run, double length) {
  a.said("method", [&] { return method_json(run.method); });
  if constexpr (Archive::reads) a("method", run.method);
  a("elements", run.elements);
  a("outcome", run.outcome);
  a("message", run.message);
  a.said("stable_but_wrong",
         [&] { return run.completed() && run.time_error.tip_max > wrong_beyond * length; });
  a.said("work_seconds", [&] { return run.work_seconds(); });
  a("seconds", run.seconds);
  members(a, run.counters);
  a("time_error", run.time_error);
  a("total_error", run.total_error);
}

using Json = nlohmann::ordered_json;

/// Those of other programs, whose points also say what their time is here.
Json given_curves_json(const WorkPrecision& study) {
  Json curves = Json::array();
  for (const GivenCurve& curve : study.given_curves) {
    curves.push_back(encode(curve, NotFinite::null));
    for (std::size_t k = 0; k < curve.points.size(); ++k)
      curves.back()["points"][k]["work_seconds"] =
          encode(study.work(curve, curve.points[k]), NotFinite::null);
  }
  return curves;
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
  WorkPrecision written = study;
  ObjectWriter whole(NotFinite::null);
  members_of_study(whole, written);
  whole.json["given_curves"] = given_curves_json(study);
  Json& runs = whole.json["runs"] = Json::array();
  for (WorkPrecisionRun& run : written.runs) {
    ObjectWriter a(NotFinite::null);
    members_of_run(a, run, study.length);
    runs.push_back(std::move(a.json));
  }
  whole.json["conclusion"] = conclusion_json(study);
  for (const auto& [name, value] : study.provenance) whole.json["provenance"][name] = value;
  return std::move(whole.json);
}

WorkPrecision work_precision_from_json(const Json& json) {
  WorkPrecision study;
  ObjectReader whole(json, NotFinite::null);
  members_of_study(whole, study);
  for (const Json& item : json.at("runs")) {
    ObjectReader a(item, NotFinite::null);
    members_of_run(a, study.runs.emplace_back(), study.length);
  }
  if (json.contains("given_curves")) decode(json.at("given_curves"), study.given_curves, NotFinite::null);
  study.timed = study.has_times();
  decode(json.at("provenance"), study.provenance);
  check(study);
  return study;
}

}  // namespace plumb
