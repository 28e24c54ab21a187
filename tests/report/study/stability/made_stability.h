#pragma once

#include "engine/study/stability/stability_file.h"
#include "tests/engine/study/stability/tiny_stability.h"

namespace plumb {

/// A stability study made by hand, of numbers that no integration gave: two methods over each axis, every
/// outcome, and a horizon before the end.
inline Stability made_stability() {
  Stability study;
  study.title = "made";
  study.parameter = "f";
  study.parameter_value = 5;
  study.elements = 4;
  study.end = 2;
  study.duration = 10;
  study.tolerance = 0.01;
  study.provenance = {{"program", "test data"}};
  const std::vector<Outcome> row{Outcome::accurate,
                                 Outcome::inaccurate,
                                 Outcome::unstable,
                                 Outcome::diverged,
                                 Outcome::no_convergence,
                                 Outcome::singular,
                                 Outcome::unstable_equilibrium,
                                 Outcome::out_of_time};
  for (const bool by_step : {true, false})
    for (const MapAxis axis : {MapAxis::parameter, MapAxis::elements, MapAxis::duration}) {
      OutcomeMap map;
      map.label = by_step ? "rk4" : "cvode-bdf, order ≤ 2";
      map.method.name = by_step ? "rk4" : "cvode-bdf";
      map.by_step = by_step;
      map.axis = axis;
      for (int k = 0; k < 8; ++k) map.settings.push_back(1e-4 * std::pow(2.0, k));
      map.values = axis == MapAxis::parameter  ? std::vector<double>{1, 5}
                   : axis == MapAxis::elements ? std::vector<double>{4, 8}
                                               : std::vector<double>{2, 10};
      if (by_step) {
        map.limit_kind = LimitKind::vibration;
        map.limits = {{2e-4, 1.9e-4}, {1e-3, 0.9e-3}};
      }
      map.in_words = "accurate up to a step of 1.0e-4 s";
      for (int value = 0; value < 2; ++value)
        for (const Outcome outcome : row) {
          StabilityPoint& point = map.points.emplace_back();
          point.outcome = outcome;
          point.end_time = is_stable(outcome) ? 2 : 0.5;
          point.error = outcome == Outcome::accurate ? 1e-4 : outcome == Outcome::inaccurate ? 0.5 : -1;
          point.judged_until = is_stable(outcome) ? 1.75 : -1;
          if (!is_stable(outcome)) point.message = "it ended so";
        }
      study.maps.push_back(map);
    }
  for (const double parameter : {1.0, 5.0}) {
    CriticalStep step;
    step.label = "rk4";
    step.method.name = "rk4";
    step.parameter = parameter;
    step.elements = 4;
    step.stable = 1e-3;
    step.unstable = 1.01e-3;
    step.beyond = Outcome::diverged;
    step.limit_kind = LimitKind::vibration;
    step.predicted = {1.1e-3, 1.02e-3};
    study.critical_steps.push_back(step);
    EnergyHistory history;
    history.label = "trapezoidal";
    history.parameter = parameter;
    history.step = 0.01;
    history.outcome = parameter == 1 ? Outcome::unstable : Outcome::completed;
    history.message = parameter == 1 ? "it grew" : "";
    history.times = {0, 0.5, 1};
    history.change = {0, 0.1, 0.4};
    study.energies.push_back(history);
    TrajectoryDivergence divergence;
    divergence.parameter = parameter;
    divergence.elements = 4;
    divergence.times = {0, 1, 2};
    divergence.distances = {1e-10, 1e-6, 1e-1};
    divergence.exponent = 10;
    divergence.horizon = parameter == 1 ? 1.75 : -1;
    divergence.beyond_end = parameter != 1;
    divergence.in_words = "They part.";
    study.divergences.push_back(divergence);
    study.references.push_back({parameter, 4, 2, "one", "another", 1e-9, 2, 1900, 1950});
  }
  for (const double steps : {3.0, 10.0})
    study.amplifications.push_back({"rk4", steps, 0.3 * steps / 10 + 0.6, 0.3 * steps / 10 + 0.6});
  return study;
}

inline StabilityStudyFile made_stability_file() {
  return {tiny_stability_case(), made_stability()};
}

}  // namespace plumb
