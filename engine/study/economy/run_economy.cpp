#include "engine/study/economy/run_economy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/straight_frequency.h"
#include "engine/read/case_sections.h"
#include "engine/study/economy/candidates.h"
#include "engine/study/economy/economy_members.h"
#include "engine/study/economy/economy_scenes.h"
#include "engine/study/economy/model_selection.h"
#include "engine/study/slowdown.h"

namespace plumb {
namespace {

/// The true motion of a case with outputs where frames are, and what tells how true it is.
struct Truth {
  Trajectory motion;
  Trajectory on_half_the_mesh;
  Trajectory by_another_method;  // not run: not made
};

double greatest(const std::vector<double>& values) {
  double greatest = values.empty() ? INFINITY : 0;
  for (const double value : values) greatest = std::isfinite(value) ? std::max(greatest, value) : INFINITY;
  return greatest;
}

Trajectory by_explicit(const Case& spec, int elements) {
  constexpr double phase = 1.2;  // ωh of the fastest vibration: half of what it is stable up to
  Candidate candidate = cable_candidate(spec, elements);
  candidate.method = plain_method(accurate_explicit(spec));
  candidate.method.step =
      std::min(phase / straight_frequency(candidate.cable), scene_output_interval(spec) / 4);
  return integrate(with_candidate(spec, candidate));
}

Trajectory by_implicit(const Case& spec, int elements) {
  constexpr double parts = 40;  // of an interval between frames
  Candidate candidate = cable_candidate(spec, elements);
  candidate.method = plain_method(accurate_implicit());
  candidate.method.step = scene_output_interval(spec) / parts;
  return integrate(with_candidate(spec, candidate));
}

Truth truth_of(const Case& spec, int elements, bool two_methods) {
  Truth truth;
  for_each_in_parallel(two_methods ? 3 : 2, [&](std::size_t k) {
    if (k == 0) truth.motion = by_explicit(spec, elements);
    if (k == 1) truth.on_half_the_mesh = by_explicit(spec, elements / 2);
    if (k == 2) truth.by_another_method = by_implicit(spec, elements);
  });
  return truth;
}

/// Of one by two methods.
std::string truth_in_words(const Case& spec, int elements) {
  return fmt::format("{} elements by {}, held against {} and against half the elements", elements,
                     accurate_explicit(spec).name, accurate_implicit().name);
}

/// What the truth may be off by on the picture: half the mesh is, by order 2 at least, three times as far
/// off.
double doubt_of(const Truth& truth, const PictureErrors& errors) {
  if (truth.motion.outcome != Outcome::completed || truth.motion.unstable_since >= 0) return INFINITY;
  double doubt = greatest(errors(truth.on_half_the_mesh)) / 3;
  if (truth.by_another_method.outcome != Outcome::not_run) doubt += greatest(errors(truth.by_another_method));
  return doubt;
}

/// The elements of a reference for what was chosen.
int reference_elements(const EconomySpec& spec, const Economy& economy) {
  const TriedCandidate* choice = economy.choice();
  const int chosen =
      choice && choice->candidate.cable.model == CableModel::cable ? choice->candidate.cable.elements : 0;
  return std::max(spec.reference_elements, 2 * chosen);
}

double least_seconds(const Case& spec, const Candidate& candidate) {
  constexpr int repeats = 3;
  double least = INFINITY;
  for (int k = 0; k < repeats; ++k)
    least = std::min(least, integrate(with_candidate(spec, candidate)).processor_seconds);
  return least;
}

SceneNeed need_of(const std::string& name, const Case& spec, const GaugeOfCase& gauge_of) {
  SceneNeed need;
  need.name = name;
  need.scene = spec.scene;
  need.economy = choose_candidate(spec, gauge_of(spec));
  return need;
}

void prove(const Case& spec, const Truth& truth, const GaugeOfCase& gauge_of, SceneNeed& need) {
  constexpr double certain_share = 0.1;
  const PictureErrors errors = gauge_of(spec)(truth.motion);
  need.reference_doubt = doubt_of(truth, errors);
  need.certified = need.reference_doubt <= certain_share * need.economy.tolerance;
  for (TriedCandidate& tried : need.economy.tried)
    if (tried.outcome == Outcome::completed)
      tried.true_error = greatest(errors(integrate(with_candidate(spec, tried.candidate))));
  if (const TriedCandidate* choice = need.economy.choice())
    need.seconds = least_seconds(spec, choice->candidate);
}

std::vector<std::pair<std::string, Case>> pictures_of(const Case& file_case, const EconomySpec& study) {
  std::vector<std::pair<std::string, Case>> all;
  for (const bool close_up : {false, true}) {
    if (close_up && !study.close_up) continue;
    for (const int width : study.widths) {
      Case spec = file_case;
      spec.scene.size = {width, static_cast<int>(std::lround(1.0 * width * file_case.scene.size[1] /
                                                             file_case.scene.size[0]))};
      if (close_up) spec.scene.camera = study.close_up;
      all.emplace_back(fmt::format("{} by {}, {}", spec.scene.size[0], spec.scene.size[1],
                                   close_up ? "close-up" : "camera of the scene"),
                       std::move(spec));
    }
  }
  return all;
}

/// The one safe run that every picture could be drawn from: how long it took and how far it came, s.
std::array<double, 2> safe_run(const Case& spec) {
  constexpr double time_limit = 120;
  const Trajectory safe = integrate(with_candidate(spec, safe_candidate(spec)), {}, time_limit);
  return {safe.processor_seconds, safe.end_time};
}

/// Which begins first: what takes longest and cannot be divided, and then what others wait for.
constexpr double work_of_safe_run = 1000, work_of_proof = 100;

bool has_both(const TriedCandidate& tried) {
  return tried.estimate > 0 && std::isfinite(tried.estimate) && tried.true_error >= 0;
}

}  // namespace

double SceneNeed::worst_ratio() const {
  double worst = 0;
  for (const TriedCandidate& tried : economy.tried)
    if (has_both(tried)) worst = std::max(worst, (tried.true_error - reference_doubt) / tried.estimate);
  return worst;
}

long SceneNeed::proven_candidates() const {
  if (!(reference_doubt >= 0) || !std::isfinite(reference_doubt)) return 0;
  return std::count_if(economy.tried.begin(), economy.tried.end(), has_both);
}

EconomySpec economy_study_of(const Case& spec) {
  return spec.economy ? *spec.economy : default_economy(spec.scene);
}

RandomScene run_random_scene(const LoadedCase& loaded, const EconomySpec& study, long number,
                             const GaugeOfCase& gauge_of) {
  RandomScene scene;
  scene.number = number;
  scene.overrides = scene_overrides(loaded.spec, study.seed, number);
  const Case spec = load_case(loaded.source.with(scene.overrides)).spec;
  const Economy economy = choose_candidate(spec, gauge_of(spec));
  const TriedCandidate& choice = *economy.choice();
  scene.chosen = in_words(choice.candidate);
  scene.tolerance = economy.tolerance;
  scene.holds = economy.holds;
  scene.estimate = choice.estimate;
  scene.seconds = choice.seconds;
  scene.search_share = economy.search_work / economy.safe_work;
  scene.uncertain = economy.uncertain;
  if (!scene.holds) return scene;
  EconomySpec coarser = study;
  coarser.reference_elements = std::max(2, study.reference_elements / 2);
  const Truth truth = truth_of(spec, reference_elements(coarser, economy), false);
  const PictureErrors errors = gauge_of(spec)(truth.motion);
  scene.reference_doubt = doubt_of(truth, errors);
  scene.true_error = greatest(errors(integrate(with_candidate(spec, choice.candidate))));
  return scene;
}

EconomyStudy run_economy(const LoadedCase& loaded, const GaugeOfCase& gauge_of, Runner& runner) {
  EconomyStudy study;
  study.loaded = loaded;
  study.spec = economy_study_of(loaded.spec);
  const std::vector<std::pair<std::string, Case>> pictures = pictures_of(loaded.spec, study.spec);

  const double slowdown = slowdown_in_company(loaded.spec, runner);
  const Company timed = company_of_timed(slowdown);
  std::vector<StudyPoint<SceneNeed>> choices;
  for (const auto& [name, spec] : pictures)
    choices.push_back({name, [&, name = name, spec = spec] { return need_of(name, spec, gauge_of); }});
  const std::vector<SceneNeed> needs = runner.run({"choosing", timed, Division::shared}, choices);

  int elements = study.spec.reference_elements;
  for (const SceneNeed& need : needs)
    elements = std::max(elements, reference_elements(study.spec, need.economy));
  study.reference = truth_in_words(loaded.spec, elements);
  std::optional<Truth> truth;  // made where a proof is to be computed
  std::once_flag truth_made;
  std::vector<StudyPoint<SceneNeed>> proofs;
  for (std::size_t k = 0; k < pictures.size(); ++k)
    proofs.push_back({pictures[k].first,
                      [&, k] {
                        std::call_once(truth_made, [&] { truth = truth_of(loaded.spec, elements, true); });
                        SceneNeed need = needs[k];
                        prove(pictures[k].second, *truth, gauge_of, need);
                        return need;
                      },
                      work_of_proof});
  const auto needs_proven = runner.plan({"proving", timed}, proofs);

  const auto safe = runner.plan<std::array<double, 2>>(
      {"safe default", timed}, {{"one run", [&] { return safe_run(loaded.spec); }, work_of_safe_run}});

  std::vector<StudyPoint<RandomScene>> scenes;
  for (long k = 0; k < study.spec.scenes; ++k)
    scenes.push_back(
        {fmt::format("{}", k), [&, k] { return run_random_scene(loaded, study.spec, k, gauge_of); }});
  const auto random_scenes = runner.plan("random scenes", scenes);
  runner.compute("scenes");
  runner.conclude();
  study.needs = std::move(*needs_proven);
  for (std::size_t k = 0; k < pictures.size(); ++k) study.needs[k].scene = pictures[k].second.scene;
  // Costs are held against that of the safe default.
  study.safe_seconds = runner.alike({"choosing", "proving", "safe default"}) ? safe->front()[0] : -1;
  study.safe_end = safe->front()[1];
  study.scenes = std::move(*random_scenes);
  study.provenance = runner.provenance();
  study.provenance.emplace_back("timing", "of the processor; " + slowdown_in_words(slowdown));
  return study;
}

}  // namespace plumb
