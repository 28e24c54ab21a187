#include "engine/study/stability/outcome_maps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/integrate/integrate.h"
#include "engine/model/cable.h"
#include "engine/study/reference/classify_outcome.h"
#include "engine/study/reference/until.h"
#include "engine/study/stability/predicted_limit.h"
#include "engine/study/stability/stability_members.h"
#include "engine/study/stability/step_in_words.h"

namespace plumb {
namespace {

/// One integration and the points that it gives, one each time at which it is looked at.
struct MapRun {
  const MethodSetting* variant;
  const ReferenceMotion* motion;
  double setting;
  std::vector<double> ends;  ///< s, rising
  std::vector<StabilityPoint> points;
};

StabilityPoint point_of(const Trajectory& run, const ReferenceMotion& motion, double end, double tolerance) {
  const Trajectory part = until(run, end);
  const Judgement judgement =
      classify_outcome(part, until(motion.trajectory, end), tolerance, motion.horizon());
  StabilityPoint point;
  point.outcome = judgement.outcome;
  point.message = part.message;
  point.end_time = part.end_time;
  point.error = judgement.error;
  point.judged_until = judgement.judged_until;
  if (!part.energies.empty() && part.kinetic_scale() > 0)
    point.energy_change =
        (part.energies.back().total() - part.energies.front().total()) / part.kinetic_scale();
  point.steps = part.counters.steps;
  point.seconds = part.solve_seconds;
  return point;
}

std::vector<StabilityPoint> points_of(const MapRun& run, double tolerance, double time_limit) {
  Case spec = run.motion->spec;
  spec.time.end = run.ends.back();
  spec.method = run.variant->with(run.setting);
  const Trajectory trajectory = integrate(spec, {}, {time_limit, run.ends});
  std::vector<StabilityPoint> points;
  for (const double end : run.ends) points.push_back(point_of(trajectory, *run.motion, end, tolerance));
  return points;
}

/// A guess, to begin with the longest, s.
double work(const MapRun& run, double time_limit) {
  constexpr double seconds_of_element_step = 1e-7, implicit_over_explicit = 10;
  const double steps = run.variant->by_step ? run.ends.back() / run.setting : 1e3;
  const double guess = seconds_of_element_step * steps * run.motion->spec.cable.elements *
                       (run.variant->info->implicit ? implicit_over_explicit : 1);
  return std::min(guess, time_limit);
}

class Maps {
 public:
  Maps(const StabilitySpec& what, double end, const std::vector<MethodSetting>& variants,
       const StabilityMotions& motions)
      : what_(what), end_(end), variants_(variants), motions_(motions) {
    ends_of_base_ = what.durations;
    ends_of_base_.push_back(end);
    std::sort(ends_of_base_.begin(), ends_of_base_.end());
    ends_of_base_.erase(std::unique(ends_of_base_.begin(), ends_of_base_.end()), ends_of_base_.end());
  }

  void plan() {
    for (const MethodSetting& variant : variants_)
      for (const double setting : settings(variant)) {
        add(variant, motions_.base, setting, ends_of_base_);
        for (const ReferenceMotion& motion : motions_.parameters) add(variant, motion, setting, {end_});
        for (const ReferenceMotion& motion : motions_.elements) add(variant, motion, setting, {end_});
      }
  }

  void execute_all(Runner& runner) {
    std::vector<StudyPoint<std::vector<StabilityPoint>>> points;
    for (const MapRun& run : runs_)
      points.push_back({fmt::format("{}, {}, {}, to {} s", run.variant->label, run.setting,
                                    run.motion->in_words(), fmt::join(run.ends, ", ")),
                        [this, &run] { return points_of(run, what_.tolerance, what_.time_limit); },
                        work(run, what_.time_limit)});
    found_ = runner.plan("maps", std::move(points));
  }

  std::vector<OutcomeMap> collect() {
    for (std::size_t k = 0; k < runs_.size(); ++k) runs_[k].points = std::move((*found_)[k]);
    for (const MapRun& run : runs_) by_key_[{run.variant, run.motion, run.setting}] = &run;
    for (std::size_t k = 0; k < asked_.size(); ++k) limits_[asked_[k]] = (*found_limits_)[k];
    return made_maps();
  }

  /// Of each variant on each motion.
  void predict(Runner& runner) {
    std::vector<const ReferenceMotion*> motions{&motions_.base};
    for (const ReferenceMotion& motion : motions_.parameters) motions.push_back(&motion);
    for (const ReferenceMotion& motion : motions_.elements) motions.push_back(&motion);
    for (const MethodSetting& variant : variants_) {
      const LimitKind kind = variant.by_step ? limit_kind(variant.with(1)) : LimitKind::none;
      if (kind != LimitKind::vibration && kind != LimitKind::contraction) continue;
      for (const ReferenceMotion* motion : motions) asked_.emplace_back(&variant, motion);
    }
    std::vector<StudyPoint<PredictedLimit>> points;
    for (const auto& [variant, motion] : asked_)
      points.push_back({fmt::format("{}, {}", variant->label, motion->in_words()),
                        [this, variant = variant, motion = motion] {
                          return predicted_limit(
                              variant->method, Cable(motion->spec), until(motion->trajectory, end_),
                              motion->summary.frequency_at_start, motion->summary.frequency_at_worst);
                        }});
    found_limits_ = runner.plan("predicted limits", std::move(points));
  }

  std::vector<OutcomeMap> made_maps() const {
    std::vector<OutcomeMap> maps;
    for (const MethodSetting& variant : variants_) {
      if (!what_.parameter_values.empty())
        maps.push_back(map_over(variant, MapAxis::parameter, what_.parameter_values));
      maps.push_back(map_over(variant, MapAxis::elements, {what_.elements.begin(), what_.elements.end()}));
      maps.push_back(map_over(variant, MapAxis::duration, what_.durations));
    }
    return maps;
  }

 private:
  using Key = std::tuple<const MethodSetting*, const ReferenceMotion*, double>;

  std::vector<double> settings(const MethodSetting& variant) const {
    return variant.by_step ? equal_ratios(what_.smallest_step, what_.largest_step, what_.steps)
                           : equal_ratios(what_.tightest_tolerance, what_.loosest_tolerance, what_.steps);
  }

  void add(const MethodSetting& variant, const ReferenceMotion& motion, double setting,
           const std::vector<double>& ends) {
    runs_.push_back({&variant, &motion, setting, ends, {}});
  }

  const ReferenceMotion& motion_of(MapAxis axis, double value) const {
    if (axis == MapAxis::parameter) return motions_.at_parameter(value);
    if (axis == MapAxis::elements) return motions_.on_mesh(static_cast<int>(value));
    return motions_.base;
  }

  OutcomeMap map_over(const MethodSetting& variant, MapAxis axis, const std::vector<double>& values) const {
    OutcomeMap map;
    map.label = variant.label;
    map.method = variant.method;
    map.by_step = variant.by_step;
    map.axis = axis;
    map.settings = settings(variant);
    map.values = values;
    map.limit_kind = variant.by_step ? limit_kind(variant.with(map.settings.front())) : LimitKind::none;
    for (const double value : values) {
      const ReferenceMotion& motion = motion_of(axis, value);
      const double end = axis == MapAxis::duration ? value : end_;
      for (const double setting : map.settings) {
        const MapRun& run = *by_key_.at({&variant, &motion, setting});
        const auto at = std::find(run.ends.begin(), run.ends.end(), end) - run.ends.begin();
        map.points.push_back(run.points[static_cast<std::size_t>(at)]);
      }
      if (const auto limit = limits_.find({&variant, &motion}); limit != limits_.end())
        map.limits.push_back(limit->second);
    }
    map.in_words = step_in_words(map, place_of_case(axis, values));
    return map;
  }

  /// The value that is nearest to the case's own.
  std::size_t place_of_case(MapAxis axis, const std::vector<double>& values) const {
    const double own = axis == MapAxis::parameter  ? motions_.base.parameter
                       : axis == MapAxis::elements ? motions_.base.spec.cable.elements
                                                   : end_;
    const auto nearest = std::min_element(values.begin(), values.end(), [&](double a, double b) {
      return std::abs(a - own) < std::abs(b - own);
    });
    return static_cast<std::size_t>(nearest - values.begin());
  }

  const StabilitySpec& what_;
  double end_;
  const std::vector<MethodSetting>& variants_;
  const StabilityMotions& motions_;
  std::vector<double> ends_of_base_;
  std::vector<MapRun> runs_;
  std::map<Key, const MapRun*> by_key_;
  Runner::Planned<std::vector<StabilityPoint>> found_;
  std::vector<std::pair<const MethodSetting*, const ReferenceMotion*>> asked_;
  Runner::Planned<PredictedLimit> found_limits_;
  std::map<std::pair<const MethodSetting*, const ReferenceMotion*>, PredictedLimit> limits_;
};

}  // namespace

std::vector<double> equal_ratios(double least, double greatest, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k)
    values.push_back(k + 1 == count ? greatest : least * std::pow(greatest / least, k / (count - 1.0)));
  return values;
}

const ReferenceMotion& StabilityMotions::at_parameter(double value) const {
  for (const ReferenceMotion& motion : parameters)
    if (motion.parameter == value) return motion;
  return base;
}

const ReferenceMotion& StabilityMotions::on_mesh(int count) const {
  for (const ReferenceMotion& motion : elements)
    if (motion.spec.cable.elements == count) return motion;
  return base;
}

std::function<std::vector<OutcomeMap>()> plan_outcome_maps(const StabilitySpec& what, double end,
                                                           const std::vector<MethodSetting>& variants,
                                                           const StabilityMotions& motions, Runner& runner) {
  const auto maps = std::make_shared<Maps>(what, end, variants, motions);
  maps->plan();
  maps->predict(runner);
  maps->execute_all(runner);
  return [maps] { return maps->collect(); };
}

}  // namespace plumb
