#pragma once

#include "engine/study/uncertainty/assessment.h"
#include "engine/study/uncertainty/uncertainty_parts.h"

namespace plumb {

/// An uncertainty made by hand of the one comparison of run_with(), with a part of every state.
inline Uncertainty made_uncertainty(PartState input = PartState::not_estimated) {
  SeriesUncertainty series;
  series.reference = "known";
  series.series = "y";
  series.column = "tip.y";
  series.unit = "m";
  series.published = true;
  series.times = {0, 0.5, 1};
  series.error = {0, 0, -0.1};
  series.parts = {{"mesh", PartState::estimated, "by <meshes>", {0, 0.003, 0.003}},
                  {"time integration", PartState::no_part, "nothing moves", {}},
                  {"input", input, "nobody knows", {}},
                  {"data", PartState::estimated, "as stated", {0.004, 0.004, 0.004}}};
  conclude(series);
  Uncertainty made;
  made.series = {series};
  made.left_out = {"other: tip.x: the run did not complete"};
  made.sampling = {4,
                   9,
                   3,
                   {"cable.density = -1: refused"},
                   {{{"cable.density", Distribution::normal, 0.25, true, "a <sheet>"}, 1000}}};
  made.runs = 8;
  made.seconds = 0.5;
  return made;
}

/// An error budget made by hand of two series, with an item that failed and one for information.
inline ErrorBudget made_budget() {
  const auto run = [](const std::string& method, double scale) {
    BudgetRun made;
    made.overrides = {"method.name=" + method};
    made.outcome = Outcome::completed;
    made.method = method;
    made.elements = 4;
    made.seconds = 0.01;
    made.distances = {
        {"y", 2e-3 * scale, BudgetDistance{1e-3 * scale, 0.5, 1.5e-3 * scale, 0.55}, {0, 1e-3 * scale, 0}},
        {"z", 5e-3 * scale, BudgetDistance{4e-3 * scale, 1, 5e-3 * scale, 1}, {0, 0, 4e-3 * scale}}};
    return made;
  };
  ErrorBudget made;
  made.reference = "known";
  made.interval = 0.001;
  made.times = {0, 0.5, 1};
  made.seconds = 0.25;
  made.series = {{"y", "tip.y", "height", "m"}, {"z", "tip.z", "", "m"}};
  made.base = run("euler", 1);
  made.base.distances = {{"y", 1e-6, {}, {}}, {"z", 2e-6, {}, {}}};
  BudgetRun failed;
  failed.outcome = Outcome::unstable;
  failed.message = "it grew";
  failed.method = "rk4, step 1 s";
  failed.elements = 4;
  made.entries = {{"gravity", "as <stated>", true, false, false, true, run("euler", 1)},
                  {"step", "", true, true, false, true, failed},
                  {"strain", "", false, false, false, false, run("euler", 0.1)}};
  made.together = run("rk4", 3);
  return made;
}

}  // namespace plumb
