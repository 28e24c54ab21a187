#include "engine/study/stability/run_stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "engine/base/errors.h"
#include "engine/integrate/integrate.h"
#include "engine/study/reference/classify_outcome.h"
#include "engine/study/reference/until.h"
#include "engine/study/stability/mode_amplification.h"
#include "engine/study/stability/outcome_maps.h"
#include "engine/study/stability/step_in_words.h"
#include "tests/engine/study/stability/tiny_stability.h"

namespace plumb {
namespace stability_run_test {

const OutcomeMap& map_named(const Stability& study, const std::string& label, MapAxis axis) {
  for (const OutcomeMap& map : study.maps)
    if (map.label == label && map.axis == axis) return map;
  throw std::out_of_range("no map of " + label);
}

TEST(StabilityRun, EveryMethodHasAWholeMapOverEachAxis) {
  const Stability& study = tiny_stability().result;
  std::set<std::string> labels;
  for (const OutcomeMap& map : study.maps) {
    labels.insert(map.label);
    EXPECT_EQ(map.points.size(), map.settings.size() * map.values.size()) << map.label;
    EXPECT_EQ(map.settings.size(), 5U);
    EXPECT_FALSE(map.in_words.empty());
    for (const StabilityPoint& point : map.points) {
      EXPECT_NE(point.outcome, Outcome::not_run) << map.label;
      EXPECT_NE(point.outcome, Outcome::completed) << map.label << ": every run has a reference here";
      EXPECT_EQ(point.message.empty(), is_stable(point.outcome)) << map.label << ": " << point.message;
      EXPECT_EQ(point.error >= 0, is_stable(point.outcome)) << map.label;
    }
  }
  EXPECT_EQ(study.maps.size(), 3 * labels.size());
  EXPECT_GE(labels.size(), 9U) << "variants and both kinds of step control";
  EXPECT_EQ(map_named(study, "rk4", MapAxis::parameter).values, (std::vector<double>{2, 5}));
  EXPECT_EQ(map_named(study, "rk4", MapAxis::elements).values, (std::vector<double>{1, 2}));
  EXPECT_EQ(map_named(study, "rk4", MapAxis::duration).values, (std::vector<double>{0.05, 0.1, 0.2}));
}

TEST(StabilityRun, AnExplicitMethodIsAccurateBelowItsPredictedLimitAndFailsFarAbove) {
  const Stability& study = tiny_stability().result;
  for (const MapAxis axis : {MapAxis::parameter, MapAxis::elements, MapAxis::duration}) {
    const OutcomeMap& map = map_named(study, "velocity-verlet", axis);
    EXPECT_EQ(map.limit_kind, LimitKind::vibration);
    ASSERT_EQ(map.limits.size(), map.values.size());
    for (std::size_t row = 0; row < map.values.size(); ++row)
      for (std::size_t k = 0; k < map.settings.size(); ++k) {
        const Outcome outcome = map.points[row * map.settings.size() + k].outcome;
        if (map.settings[k] < 0.9 * map.limits[row].at_worst) {
          EXPECT_EQ(outcome, Outcome::accurate) << map.settings[k] << " s at " << map.values[row];
        }
        if (map.settings[k] > 3 * map.limits[row].at_worst) {
          EXPECT_FALSE(is_stable(outcome)) << map.settings[k] << " s at " << map.values[row];
        }
      }
  }
}

TEST(StabilityRun, MapsThatShareARunAgree) {
  const Stability& study = tiny_stability().result;
  for (const std::string label : {"rk4", "trapezoidal, fixed step"}) {
    const OutcomeMap &parameter = map_named(study, label, MapAxis::parameter),
                     &elements = map_named(study, label, MapAxis::elements),
                     &duration = map_named(study, label, MapAxis::duration);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_EQ(parameter.points[5 + k].error, elements.points[5 + k].error) << "f = 5, 2 elements";
      EXPECT_EQ(parameter.points[5 + k].error, duration.points[5 + k].error) << "until 0.1 s";
      if (is_stable(duration.points[10 + k].outcome)) {
        EXPECT_LE(duration.points[k].error, duration.points[10 + k].error) << "errors only grow";
      }
    }
  }
}

TEST(StabilityRun, TheParameterIsVariedByReadingTheCaseAgain) {
  // The axial wave is as fast as 1/f allows, so that the limit is in proportion to f.
  const OutcomeMap& map = map_named(tiny_stability().result, "rk4", MapAxis::parameter);
  EXPECT_NEAR(map.limits[0].at_start / map.limits[1].at_start, 2.0 / 5, 1e-3);
  LoadedCase bad = tiny_stability_case();
  bad.source.file.text += "[[probe]]\nname = \"a\"\nat = \"f/5\"\n";
  bad.spec.stability->parameter_values = {5, 6};
  EXPECT_THROW(run_stability(bad, InMemory()), InputError) << "a probe beyond the end at f = 6";
}

TEST(StabilityRun, WhatIsPredictedGoesWithTheMethod) {
  LoadedCase loaded = tiny_stability_case();
  loaded.spec.stability->methods = {"bdf", "trapezoidal", "arkode-erk", "cvode-bdf"};
  loaded.spec.stability->limit_methods.clear();
  std::map<std::string, LimitKind> kinds;
  const Stability study = run_stability(loaded, InMemory());
  for (const ModeAmplification& mode : study.amplifications)
    EXPECT_NEAR(mode.measured, mode.predicted, 3e-3 * std::max(1.0, mode.predicted))
        << mode.label << ", " << mode.steps_a_period << " steps a period";
  for (const OutcomeMap& map : study.maps) {
    kinds[map.label] = map.limit_kind;
    const bool limits = map.limit_kind == LimitKind::vibration || map.limit_kind == LimitKind::contraction;
    EXPECT_EQ(map.limits.size(), limits ? map.values.size() : 0) << map.label;
  }
  EXPECT_EQ(kinds.at("bdf, order 2"), LimitKind::contraction);
  EXPECT_EQ(kinds.at("bdf, order 3"), LimitKind::always);
  EXPECT_EQ(kinds.at("bdf, order 5"), LimitKind::vibration)
      << "it damps slow vibrations, and some others grow";
  EXPECT_EQ(kinds.at("trapezoidal, fixed step"), LimitKind::contraction);
  EXPECT_EQ(kinds.at("trapezoidal, controlled step"), LimitKind::none);
  EXPECT_EQ(kinds.at("arkode-erk, order 5, fixed step"), LimitKind::vibration);
  EXPECT_EQ(kinds.at("cvode-bdf, order ≤ 5"), LimitKind::none);
}

TEST(StabilityRun, CriticalStepsAreFoundBesideThePrediction) {
  const Stability& study = tiny_stability().result;
  ASSERT_EQ(study.critical_steps.size(), 3U) << "two values of f and another mesh";
  for (const CriticalStep& step : study.critical_steps) {
    EXPECT_GT(step.predicted.at_worst, 0);
    EXPECT_NEAR(std::sqrt(step.stable * step.unstable) / step.predicted.at_worst, 1, 0.05)
        << "f = " << step.parameter << ", " << step.elements << " elements";
  }
}

TEST(StabilityRun, AmplificationsAreThoseOfTheTheory) {
  const Stability& study = tiny_stability().result;
  EXPECT_GT(study.amplifications.size(), 30U);
  for (const ModeAmplification& mode : study.amplifications) {
    EXPECT_NEAR(mode.measured, mode.predicted, 1e-3 * std::max(1.0, mode.predicted))
        << mode.label << ", " << mode.steps_a_period << " steps a period";
  }
}

TEST(StabilityRun, EnergiesReferencesAndSeparationsAreThere) {
  const Stability& study = tiny_stability().result;
  EXPECT_EQ(study.energies.size(), 2 * 4U) << "four structural variants at two values";
  for (const EnergyHistory& history : study.energies) {
    EXPECT_EQ(history.times.size(), history.change.size());
    EXPECT_EQ(history.change.front(), 0);
  }
  ASSERT_EQ(study.references.size(), 3U);
  ASSERT_EQ(study.divergences.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(study.references[k].parameter, study.divergences[k].parameter);
    EXPECT_EQ(study.references[k].elements, study.divergences[k].elements);
    EXPECT_EQ(study.references[k].trusted_until, study.references[k].duration);
    EXPECT_LT(study.references[k].agreement, 1e-3 * study.tolerance);
  }
}

TEST(StabilityRun, ARunOutOfTimeIsKeptWithItsReason) {
  LoadedCase loaded = tiny_stability_case("time_limit = 1e-9\n");
  loaded.spec.stability->methods = {"rk4"};
  loaded.spec.stability->limit_methods.clear();
  const Stability study = run_stability(loaded, InMemory());
  const StabilityPoint& first = study.maps.front().points.front();
  EXPECT_EQ(first.outcome, Outcome::out_of_time);
  EXPECT_NE(first.message.find("the time allowed"), std::string::npos) << first.message;
}

TEST(StabilityRun, ProgressNamesThePartsAndCanStopTheStudy) {
  LoadedCase loaded = tiny_stability_case();
  loaded.spec.stability->methods = {"rk4"};
  std::vector<std::string> parts;
  Journal journal;
  Runner runner(journal, [&](const std::string& part, double share) {
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
    if (parts.empty() || parts.back() != part) parts.push_back(part);
  });
  run_stability(loaded, runner);
  EXPECT_EQ(parts, (std::vector<std::string>{"references", "maps"}))
      << "what needs references is computed together";
  Journal another;
  Runner stopped(another, [](const std::string&, double) { throw Interrupted(); });
  EXPECT_THROW(run_stability(loaded, stopped), Interrupted);
}

TEST(Until, KeepsWhatARunWouldHaveBeen) {
  Case spec = tiny_stability_case().spec;
  const Trajectory whole = integrate(spec);
  spec.time.end = 0.05;
  const Trajectory half = integrate(spec), part = until(whole, 0.05);
  EXPECT_EQ(part.outcome, Outcome::completed);
  EXPECT_EQ(part.times.size(), half.times.size());
  EXPECT_LT((part.q.back() - half.q.back()).norm(), 1e-12);
  EXPECT_EQ(part.end_time, 0.05);
  EXPECT_EQ(until(whole, 0.1).counters.steps, whole.counters.steps) << "the whole run";

  Trajectory failed = whole;
  failed.outcome = Outcome::unstable;
  failed.message = "why";
  failed.end_time = 0.075;
  EXPECT_EQ(until(failed, 0.05).outcome, Outcome::completed) << "it failed later";
  EXPECT_EQ(until(failed, 0.05).message, "");
  EXPECT_EQ(until(failed, 0.08).outcome, Outcome::unstable);
  EXPECT_EQ(until(failed, 0.08).message, "why");
}

TEST(GrowthAStep, OfASampledVibrationIsItsModulus) {
  for (const double growth : {0.3, 0.98, 1.0, 1.2})
    for (const double turn : {0.1, 1.0, 2.5}) {
      std::vector<double> series;
      for (int k = 0; k < 30; ++k) series.push_back(std::pow(growth, k) * std::cos(turn * k + 0.4));
      EXPECT_NEAR(growth_a_step(series), growth, 1e-9) << growth << " at " << turn;
    }
  EXPECT_NEAR(growth_a_step({1, -2, 4, -8, 16}), 2, 1e-9) << "a real root";
  EXPECT_EQ(growth_a_step({1, 2, 3}), -1);
  EXPECT_EQ(growth_a_step({0, 0, 0, 0, 0}), -1);
}

TEST(StepInWords, SaysWhatIsAccurateWhatIsStableAndWhatFails) {
  OutcomeMap map;
  map.settings = {1e-3, 2e-3, 4e-3, 8e-3};
  map.values = {1};
  const auto says = [&](std::initializer_list<Outcome> outcomes) {
    map.points.clear();
    for (const Outcome outcome : outcomes) map.points.emplace_back().outcome = outcome;
    return step_in_words(map, 0);
  };
  const Outcome a = Outcome::accurate, i = Outcome::inaccurate, u = Outcome::unstable;
  EXPECT_EQ(says({a, a, i, u}),
            "accurate up to a step of 2.0e-3 s, stable up to 4.0e-3 s; unstable at 8.0e-3 s");
  EXPECT_EQ(says({a, a, u, u}), "accurate up to a step of 2.0e-3 s; unstable at 4.0e-3 s");
  EXPECT_EQ(says({a, a, a, a}), "accurate at all of the steps, up to 8.0e-3 s");
  EXPECT_EQ(says({a, i, i, i}), "accurate up to a step of 1.0e-3 s, stable up to the longest, 8.0e-3 s");
  EXPECT_EQ(
      says({i, i, i, u}),
      "accurate at none of the steps from 1.0e-3 s to 8.0e-3 s, stable up to 4.0e-3 s; unstable at 8.0e-3 s");
  EXPECT_EQ(says({Outcome::out_of_time, a, a, u}),
            "accurate with a step from 2.0e-3 s to 4.0e-3 s (out-of-time at 1.0e-3 s); unstable at 8.0e-3 s");
  EXPECT_EQ(says({u, u, u, u}),
            "accurate at none of the steps from 1.0e-3 s to 8.0e-3 s; unstable at 1.0e-3 s");
  map.limit_kind = LimitKind::always;
  EXPECT_EQ(
      says({a, a, a, u}),
      "accurate up to a step of 4.0e-3 s; unstable at 8.0e-3 s; by theory a vibration grows at every step");
  map.limits = {{5e-3, 4.5e-3}};
  map.limit_kind = LimitKind::contraction;
  EXPECT_EQ(says({a, a, a, u}),
            "accurate up to a step of 4.0e-3 s; unstable at 8.0e-3 s; Newton's iteration is "
            "expected to contract up to 5.00e-3 s");
  map.limit_kind = LimitKind::vibration;
  EXPECT_EQ(says({a, a, a, u}),
            "accurate up to a step of 4.0e-3 s; unstable at 8.0e-3 s; the predicted limit is 4.50e-3 s");
}

TEST(EqualRatios, ReachBothEndsExactly) {
  const std::vector<double> values = equal_ratios(1e-4, 0.1, 14);
  EXPECT_EQ(values.front(), 1e-4);
  EXPECT_EQ(values.back(), 0.1);
  for (std::size_t k = 2; k < values.size(); ++k)
    EXPECT_NEAR(values[k] / values[k - 1], values[1] / values[0], 1e-9);
}

}  // namespace stability_run_test
}  // namespace plumb
