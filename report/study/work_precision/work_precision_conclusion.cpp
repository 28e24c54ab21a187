#include "report/study/work_precision/work_precision_conclusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "report/study/method_label.h"
#include "report/study/work_precision/compared_lines.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

constexpr std::size_t most_ways = 5;
constexpr std::size_t most_named = 3;

double mesh_error(const WorkPrecision& study, int elements) {
  if (!study.mesh) return -1;
  const MeshConvergence& mesh = *study.mesh;
  const auto own = std::find(mesh.elements.begin(), mesh.elements.end(), elements);
  if (own == mesh.elements.end()) return -1;
  if (own + 1 == mesh.elements.end()) return mesh.extrapolated_error;
  const auto k = static_cast<std::size_t>(own - mesh.elements.begin());
  return k < mesh.distance.size() ? mesh.distance[k] : -1;
}

/// Below which an error in time on a mesh says nothing, m.
double floor_of(const WorkPrecision& study, int elements) {
  for (const CertifiedReference& reference : study.mesh_references)
    if (reference.elements == elements) return reference.floor;
  return 0;
}

/// The least of some number over the good runs on a mesh.
template <class Measure>
std::optional<std::size_t> least(const WorkPrecision& study, int elements, Measure measure) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const WorkPrecisionRun& run = study.runs[k];
    if (run.elements != elements || fate_of(study, run, StudyQuestion::time) != RunFate::good) continue;
    const double value = measure(run);
    if (value >= 0 && (!best || value < measure(study.runs[*best]))) best = k;
  }
  return best;
}

MeshAdvice advice_for(const WorkPrecision& study, int elements) {
  MeshAdvice advice{elements, mesh_error(study, elements), {}};
  const double floor = floor_of(study, elements);
  advice.run = least(study, elements, [&](const WorkPrecisionRun& run) {
    const bool fine = std::max(run.time_error.tip_max, floor) <= share_of_mesh_error * advice.error;
    return fine ? study.work(run) : -1;
  });
  return advice;
}

std::vector<CheapestRun> ways_of(const std::vector<CheapestRun>& all) {
  std::vector<CheapestRun> ways;
  for (const CheapestRun& way : all) {
    if (!ways.empty() && ways.back().run == way.run) ways.pop_back();
    ways.push_back(way);
  }
  if (ways.size() <= most_ways) return ways;
  // The ends, and those evenly between them.
  std::vector<CheapestRun> some;
  for (std::size_t k = 0; k < most_ways; ++k) some.push_back(ways[k * (ways.size() - 1) / (most_ways - 1)]);
  return some;
}

double setting_of(const WorkPrecisionRun& run) {
  return run.method.step ? *run.method.step : run.method.rtol.value_or(0);
}

bool fails(const WorkPrecision& study, const WorkPrecisionRun& run) {
  if (run.completed()) return fate_of(study, run, StudyQuestion::time) == RunFate::wrong;
  return run.outcome != Outcome::out_of_time && run.outcome != Outcome::not_run;
}

std::vector<FailingCurve> failing_curves(const WorkPrecision& study) {
  std::vector<FailingCurve> failing;
  for (std::size_t c = 0; c < study.curves.size(); ++c) {
    const MethodCurve& curve = study.curves[c];
    if (curve.elements != study.fixed_elements) continue;
    const auto good = std::find_if_not(curve.runs.begin(), curve.runs.end(),
                                       [&](std::size_t k) { return fails(study, study.runs[k]); });
    if (good != curve.runs.begin()) failing.push_back({c, *std::prev(good), good == curve.runs.end()});
  }
  const auto of_step = [&](const FailingCurve& of) { return study.runs[of.run].method.step.has_value(); };
  std::stable_sort(failing.begin(), failing.end(), [&](const FailingCurve& a, const FailingCurve& b) {
    if (a.everywhere != b.everywhere) return a.everywhere;
    if (of_step(a) != of_step(b)) return of_step(a);
    return setting_of(study.runs[a.run]) < setting_of(study.runs[b.run]);
  });
  return failing;
}

/// How many methods with their variants there are on a mesh; on all of them for 0.
std::size_t labels_on(const WorkPrecision& study, int elements) {
  std::set<std::string> labels;
  for (const MethodCurve& curve : study.curves)
    if (elements == 0 || curve.elements == elements) labels.insert(curve.label);
  return labels.size();
}

std::string label_of(const WorkPrecision& study, std::size_t run) {
  for (const MethodCurve& curve : study.curves)
    if (std::find(curve.runs.begin(), curve.runs.end(), run) != curve.runs.end()) return curve.label;
  return study.runs[run].method.name;
}

/// "the cheapest, rk4", "rk4, the only method,": who is named.
std::string who(const WorkPrecision& study, std::size_t run, int elements, const char* best) {
  const std::string label = label_in_sentence(label_of(study, run));
  return labels_on(study, elements) > 1 ? fmt::format("the {}, {},", best, label)
                                        : label + ", the only method,";
}

/// "a step of at most 5e-4 s", "rtol of at most 1e-6".
std::string at_most(const WorkPrecisionRun& run) {
  return run.method.step ? fmt::format("a step of at most {:.3g} s", *run.method.step)
                         : fmt::format("rtol of at most {:.3g}", setting_of(run));
}

std::string cost_of(const WorkPrecision& study, std::size_t run) {
  return study.work_in_words(study.work(study.runs[run]));
}

/// "1e-3"
std::string power_of_ten(double error) {
  return fmt::format("1e{}", std::lround(std::log10(error)));
}

std::string elements_in_words(int elements) {
  return counted(elements, "element", "elements");
}

/// Where nothing can be recommended: why.
std::string nothing_good(const WorkPrecision& study) {
  const auto completed = std::count_if(study.runs.begin(), study.runs.end(),
                                       [](const WorkPrecisionRun& run) { return run.completed(); });
  if (study.runs.empty()) return "No run was made, so no method can be named.";
  if (completed == 0) return "Every run failed, so no method can be named.";
  const StudyQuestion question =
      any_compared(study, StudyQuestion::time) ? StudyQuestion::time : StudyQuestion::total;
  std::optional<std::size_t> nearest;
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const auto error = [&](std::size_t run) { return errors_of(study.runs[run], question).tip_max; };
    if (fate_of(study, study.runs[k], question) == RunFate::failed) continue;
    if (!nearest || error(k) < error(*nearest)) nearest = k;
  }
  if (!nearest) return "No run that completed could be held against a reference, so no method can be named.";
  return fmt::format(
      "No run comes within {:.3g} m of the exact motion, {:g} % of the length, so no method can be named; "
      "the "
      "nearest, {} with {}, is {:.3g} m off.",
      wrong_beyond * study.length, 100 * wrong_beyond, label_in_sentence(label_of(study, *nearest)),
      study.runs[*nearest].setting(), errors_of(study.runs[*nearest], question).tip_max);
}

std::string about_own_mesh(const WorkPrecision& study, const MeshAdvice& own) {
  const std::string mesh = fmt::format("On the {} of the case", elements_in_words(own.elements));
  if (own.run)
    return fmt::format("{} {} needs {}, {}: the mesh itself is {:.2g} m off, and a finer step gains nothing.",
                       mesh, who(study, *own.run, own.elements, "cheapest"), at_most(study.runs[*own.run]),
                       cost_of(study, *own.run), own.error);
  const auto nearest =
      least(study, own.elements, [](const WorkPrecisionRun& run) { return run.time_error.tip_max; });
  if (!nearest) return fmt::format("{} no run is near enough to the exact motion to be named.", mesh);
  const double floor = floor_of(study, own.elements);
  const double error = std::max(study.runs[*nearest].time_error.tip_max, floor);
  if (own.error >= 0)
    return fmt::format(
        "{}, itself {:.2g} m off, no run integrates time to a tenth of that: {} with {} is {:.2g} m off in "
        "{}.",
        mesh, own.error, who(study, *nearest, own.elements, "nearest"), at_most(study.runs[*nearest]), error,
        cost_of(study, *nearest));
  // The finest decade that is reached, where what the mesh errs is not known.
  if (!study.time_cheapest.empty()) {
    const CheapestRun& way = study.time_cheapest.back();
    return fmt::format("{} {} integrates time to {} m with {} in {}; how far off the mesh is, is not known.",
                       mesh, who(study, way.run, own.elements, "cheapest"), power_of_ten(way.error),
                       at_most(study.runs[way.run]), cost_of(study, way.run));
  }
  return fmt::format("{} {} with {} is {:.2g} m off in {}; how far off the mesh is, is not known.", mesh,
                     who(study, *nearest, own.elements, "nearest"), at_most(study.runs[*nearest]), error,
                     cost_of(study, *nearest));
}

std::string about_the_continuum(const WorkPrecision& study, std::optional<std::size_t> told) {
  if (study.total_cheapest.empty())
    return any_compared(study, StudyQuestion::total)
               ? fmt::format("No run comes within {:.2g} m of the continuum.", wrong_beyond * study.length)
               : "How far all is from the continuum is not known.";
  const CheapestRun& way = study.total_cheapest.back();
  const std::string reached = power_of_ten(way.error);
  if (way.run == told)
    return fmt::format("That is within {} m of the continuum; no run comes within a tenth of that.", reached);
  return fmt::format(
      "Within {} m of the continuum, and no run comes within a tenth of that, {} takes {}, {} "
      "and {}.",
      reached, who(study, way.run, 0, "cheapest"), elements_in_words(study.runs[way.run].elements),
      at_most(study.runs[way.run]), cost_of(study, way.run));
}

std::string about_failures(const WorkPrecision& study, const std::vector<FailingCurve>& failing) {
  if (failing.empty()) return "";
  std::vector<std::string> named;
  for (const FailingCurve& one : failing) {
    if (named.size() == most_named && failing.size() > most_named + 1) {
      named.push_back(fmt::format("{} more", failing.size() - most_named));
      break;
    }
    const WorkPrecisionRun& run = study.runs[one.run];
    const bool step = run.method.step.has_value();
    named.push_back(fmt::format("{} {} ({})", label_in_sentence(study.curves[one.curve].label),
                                one.everywhere ? std::string(step ? "at every step" : "at every tolerance")
                                               : fmt::format("from {}{:.3g}{}", step ? "" : "rtol ",
                                                             setting_of(run), step ? " s" : ""),
                                how_it_fails(run)));
  }
  return fmt::format("Too coarse a setting fails: {}.", listed(named));
}

}  // namespace

std::string how_it_fails(const WorkPrecisionRun& run) {
  return run.completed() ? "stable but wrong" : std::string(word(run.outcome));
}

WorkPrecisionConclusion conclude(const WorkPrecision& study) {
  WorkPrecisionConclusion all;
  all.of_time_alone = study.total_cheapest.empty();
  all.ways = ways_of(all.of_time_alone ? study.time_cheapest : study.total_cheapest);
  std::set<int> meshes;
  for (const MethodCurve& curve : study.curves) meshes.insert(curve.elements);
  for (const int elements : meshes) all.meshes.push_back(advice_for(study, elements));
  all.failing = failing_curves(study);
  if (study.time_cheapest.empty() && study.total_cheapest.empty()) {
    all.sentence = nothing_good(study);
    return all;
  }
  const auto own = std::find_if(all.meshes.begin(), all.meshes.end(), [&](const MeshAdvice& advice) {
    return advice.elements == study.fixed_elements;
  });
  const std::string failures = about_failures(study, all.failing);
  const bool has_own = own != all.meshes.end();
  all.sentence = has_own ? about_own_mesh(study, *own) : about_the_continuum(study, {});
  if (has_own) all.details = about_the_continuum(study, own->run);
  if (!failures.empty()) all.details += (all.details.empty() ? "" : " ") + failures;
  return all;
}

nlohmann::ordered_json conclusion_json(const WorkPrecision& study) {
  using Json = nlohmann::ordered_json;
  const WorkPrecisionConclusion all = conclude(study);
  Json json{{"in_words", all.sentence + (all.details.empty() ? "" : " ") + all.details},
            {"of_time_alone", all.of_time_alone},
            {"ways", Json::array()},
            {"meshes", Json::array()},
            {"failing", Json::array()}};
  for (const CheapestRun& way : all.ways) json["ways"].push_back({{"error", way.error}, {"run", way.run}});
  for (const MeshAdvice& mesh : all.meshes) {
    Json entry{{"elements", mesh.elements},
               {"error", std::isfinite(mesh.error) ? Json(mesh.error) : Json(nullptr)}};
    entry["run"] = mesh.run ? Json(*mesh.run) : Json(-1);
    json["meshes"].push_back(std::move(entry));
  }
  for (const FailingCurve& one : all.failing)
    json["failing"].push_back({{"curve", one.curve}, {"run", one.run}, {"everywhere", one.everywhere}});
  return json;
}

}  // namespace plumb
