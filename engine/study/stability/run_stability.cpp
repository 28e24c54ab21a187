#include "engine/study/stability/run_stability.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"
#include "engine/read/case_sections.h"
#include "engine/read/changed_case.h"
#include "engine/study/stability/critical_step.h"
#include "engine/study/stability/energy_histories.h"
#include "engine/study/stability/mode_amplification.h"
#include "engine/study/stability/motion_statistics.h"
#include "engine/study/stability/outcome_maps.h"
#include "engine/study/stability/predicted_limit.h"
#include "engine/study/stability/stability_members.h"

namespace plumb {
namespace {

class StabilityStudy {
 public:
  StabilityStudy(const LoadedCase& loaded, Runner& runner)
      : loaded_(loaded),
        runner_(runner),
        what_(stability_of(loaded.spec)),
        variants_(method_variants(what_.methods)),
        limit_variants_(method_variants(what_.limit_methods)) {}

  Stability make() {
    Stability study;
    study.title = loaded_.spec.title;
    study.parameter = what_.parameter;
    study.parameter_value = own_value();
    study.elements = loaded_.spec.cable.elements;
    study.end = loaded_.spec.time.end;
    study.duration = std::max(what_.durations.back(), study.end);
    study.tolerance = what_.tolerance;
    make_motions(study.duration);
    const auto maps = plan_outcome_maps(what_, study.end, variants_, motions_, runner_);
    const auto steps = plan_critical_steps();
    const auto energies = plan_energy_histories(variants_, energy_cases(), energy_parameters(),
                                                what_.energy_step, long_limit(), runner_);
    const auto amplifications = runner_.plan<std::vector<ModeAmplification>>(
        "amplification", {{"all", [&] {
                             return mode_amplifications(variants_, loaded_.spec, {3, 4, 5, 6, 8, 12, 20, 50});
                           }}});
    const auto statistics = runner_.plan<std::vector<MotionStatistics>>(
        "statistics",
        {{"all",
          [&] { return motion_statistics(energy_motions(), variants_, what_.energy_step, long_limit()); }}});
    runner_.compute("maps");
    runner_.conclude();
    study.maps = maps();
    study.critical_steps = std::move(*steps);
    study.energies = std::move(*energies);
    study.amplifications = std::move(amplifications->front());
    study.statistics = std::move(statistics->front());
    for (const ReferenceMotion* motion : all_motions()) {
      study.references.push_back(motion->summary);
      study.divergences.push_back(motion->divergence);
    }
    study.provenance = runner_.provenance();
    return study;
  }

 private:
  double own_value() const {
    return what_.parameter.empty() ? 0 : loaded_.spec.parameters.at(what_.parameter);
  }

  /// For what the whole study rests on, or what is drawn whole.
  double long_limit() const { return 30 * what_.time_limit; }

  Case plain(Case spec) const {
    spec.stability.reset();
    spec.work_precision.reset();
    spec.sweep.reset();
    spec.variants.clear();
    return spec;
  }

  Case with_parameter(double value) const {
    CaseSource source = loaded_.source;
    source.overrides.push_back(fmt::format("parameters.{}={}", what_.parameter, value));
    return plain(load_without_studies(source).spec);
  }

  void make_motions(double longest) {
    std::vector<std::pair<Case, double>> cases;
    Case base = plain(loaded_.spec);
    base.time.end = longest;
    cases.emplace_back(base, own_value());
    std::size_t parameters = 0;
    for (const double value : what_.parameter_values) {
      if (value == own_value()) continue;
      cases.emplace_back(with_parameter(value), value);
      ++parameters;
    }
    for (const int elements : what_.elements) {
      if (elements == loaded_.spec.cable.elements) continue;
      Case spec = plain(loaded_.spec);
      spec.cable.elements = elements;
      cases.emplace_back(spec, own_value());
    }
    std::vector<Trajectory> trajectories(cases.size());
    std::vector<StudyPoint<ReferenceMotion>> points;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const auto& [spec, parameter] = cases[k];
      points.push_back({fmt::format("{} elements, parameter {}", spec.cable.elements, parameter),
                        [&, k] {
                          ReferenceMotion motion = reference_motion(cases[k].first, cases[k].second,
                                                                    what_.tolerance, long_limit());
                          trajectories[k] = std::move(motion.trajectory);
                          return motion;
                        },
                        spec.cable.elements * spec.time.end});
    }
    std::vector<ReferenceMotion> motions = runner_.run({"references", Division::shared}, points);
    for_each_in_parallel(cases.size(), [&](std::size_t k) {
      motions[k].spec = cases[k].first;
      motions[k].trajectory = std::move(trajectories[k]);
      if (!motions[k].trajectory.times.empty() || motions[k].method.name.empty()) return;
      Case spec = motions[k].spec;  // of a motion that the journal had
      spec.method = motions[k].method;
      motions[k].trajectory = integrate(spec);
    });
    motions_.base = std::move(motions.front());
    for (std::size_t k = 1; k < motions.size(); ++k)
      (k <= parameters ? motions_.parameters : motions_.elements).push_back(std::move(motions[k]));
  }

  /// Those over the parameter first, then those over the meshes, either with the case's own among them.
  std::vector<const ReferenceMotion*> all_motions() const {
    std::vector<const ReferenceMotion*> all{&motions_.base};
    for (const ReferenceMotion& motion : motions_.parameters) all.push_back(&motion);
    std::sort(all.begin(), all.end(),
              [](const ReferenceMotion* a, const ReferenceMotion* b) { return a->parameter < b->parameter; });
    for (const ReferenceMotion& motion : motions_.elements) all.push_back(&motion);
    return all;
  }

  Runner::Planned<CriticalStep> plan_critical_steps() const {
    struct Task {
      const MethodSetting* variant;
      const ReferenceMotion* motion;
    };
    std::vector<Task> tasks;
    for (const MethodSetting& variant : limit_variants_)
      if (variant.by_step)
        for (const ReferenceMotion* motion : all_motions()) tasks.push_back({&variant, motion});
    std::vector<StudyPoint<CriticalStep>> points;
    for (const auto& [variant, motion] : tasks)
      points.push_back(
          {fmt::format("{}, {}", variant->label, motion->in_words()),
           [this, variant = variant, motion = motion] { return critical_step_of(*variant, *motion); }});
    return runner_.plan("critical steps", std::move(points));
  }

  CriticalStep critical_step_of(const MethodSetting& variant, const ReferenceMotion& motion) const {
    Case spec = motion.spec;
    spec.time.end = loaded_.spec.time.end;
    CriticalStep step = critical_step(spec, variant.method, long_limit());
    step.label = variant.label;
    step.parameter = motion.parameter;
    step.limit_kind = limit_kind(variant.method);
    step.predicted =
        vibration_limit(variant.method, motion.summary.frequency_at_start, motion.summary.frequency_at_worst);
    return step;
  }

  /// The case itself, and the first of the parameter's values where that is another one.
  std::vector<const ReferenceMotion*> energy_motions() const {
    std::vector<const ReferenceMotion*> motions{&motions_.base};
    if (!motions_.parameters.empty() && what_.parameter_values.front() != own_value())
      motions.push_back(&motions_.parameters.front());
    return motions;
  }

  std::vector<Case> energy_cases() const {
    std::vector<Case> cases;
    for (const ReferenceMotion* motion : energy_motions()) {
      cases.push_back(motion->spec);
      cases.back().time.end = motions_.base.spec.time.end;
    }
    return cases;
  }

  std::vector<double> energy_parameters() const {
    std::vector<double> values;
    for (const ReferenceMotion* motion : energy_motions()) values.push_back(motion->parameter);
    return values;
  }

  const LoadedCase& loaded_;
  Runner& runner_;
  StabilitySpec what_;
  std::vector<MethodSetting> variants_, limit_variants_;
  StabilityMotions motions_;
};

}  // namespace

Stability run_stability(const LoadedCase& loaded, Runner& runner) {
  return StabilityStudy(loaded, runner).make();
}

}  // namespace plumb
