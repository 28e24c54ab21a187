#pragma once

#include <cmath>

#include "engine/study/work_precision/run_work_precision.h"
#include "engine/study/work_precision/work_precision_file.h"
#include "tests/report/made_run.h"

namespace plumb {

/// A study made by hand, of numbers that no integration gave: methods of exact orders on meshes of exact
/// order 2, with a run of each kind of trouble.
class MadeCurves {
 public:
  MadeCurves() {
    study_.title = "made";
    study_.fixed_elements = 4;
    study_.end = 1;
    study_.length = 2;
    study_.provenance = {{"program", "test data"}};
    for (const int elements : {4, 8}) {
      CertifiedReference reference;
      reference.elements = elements;
      reference.first = "one";
      reference.second = "another";
      reference.agreement = 1e-13;
      study_.mesh_references.push_back(reference);
    }
    study_.converged_reference = study_.mesh_references.front();
    study_.converged_reference.elements = 32;
    study_.converged_mesh_error = 1e-5;
    MeshConvergence mesh;
    mesh.elements = {4, 8, 16, 32};
    mesh.distance = {0.016, 0.004, 0.001, 0};
    mesh.change = {0.012, 0.003, 0.00075};
    mesh.observed_order = 2;
    mesh.extrapolated_error = 0.00025;
    mesh.grid_convergence_index = 0.0003125;
    mesh.standard = "made standard";
    study_.mesh = mesh;
  }

  /// A curve of `order` whose error is `factor` h^order for steps h = 0.01, 0.005, …; a step costs `cost` s.
  MadeCurves& curve(const std::string& label, MethodFamily family, int elements, double order, double factor,
                    double cost, int points = 5) {
    MethodCurve& curve = study_.curves.emplace_back();
    curve.label = label;
    curve.method = label;
    curve.family = family;
    curve.elements = elements;
    curve.stated_order = std::to_string(static_cast<int>(order));
    for (int k = 0; k < points; ++k) {
      const double step = 0.01 / std::pow(2.0, k);
      WorkPrecisionRun run;
      run.method.name = label;
      run.method.step = step;
      run.elements = elements;
      run.outcome = Outcome::completed;
      run.counters.steps = std::lround(1 / step);
      run.counters.force_evaluations = 4 * run.counters.steps;
      run.seconds = {1.5 * cost / step, cost / step, 1.25 * cost / step};
      const double error = factor * std::pow(step, order);
      run.time_error = {error, error / 2, error / 3, error / 4};
      const double total = error + 0.25 / (elements * elements);
      run.total_error = {total, total / 2, total / 3, error / 4};
      curve.runs.push_back(study_.runs.size());
      study_.runs.push_back(run);
    }
    return *this;
  }

  /// Another run at the start of the last curve, which did not complete.
  MadeCurves& failed(Outcome outcome, const std::string& message) {
    WorkPrecisionRun run;
    run.method = study_.runs.back().method;
    run.method.step = 0.1;
    run.elements = study_.runs.back().elements;
    run.outcome = outcome;
    run.message = message;
    run.seconds = {1e-3};
    study_.curves.back().runs.insert(study_.curves.back().runs.begin(), study_.runs.size());
    study_.runs.push_back(run);
    return *this;
  }

  /// Another one, which completed and is half a length off.
  MadeCurves& wrong() {
    failed(Outcome::completed, "");
    WorkPrecisionRun& run = study_.runs.back();
    run.method.step = 0.05;
    run.counters.steps = 20;
    run.time_error = run.total_error = {1.0, 0.5, 0.4, 0.3};
    return *this;
  }

  /// Judged as the engine does.
  WorkPrecision judged() const {
    WorkPrecision study = study_;
    evaluate(study);
    return study;
  }

 private:
  WorkPrecision study_;
};

/// The curve of another program, of which the last point has no error.
inline GivenCurve made_given_curve(const std::string& machine = "", double yardstick = -1) {
  return {"springs",
          "Springs 1.0",
          4,
          machine,
          yardstick,
          {{"8 links", "a.csv", 0.25, {0.02, 0.01, -1, -1}, {0.03, 0.015, -1, -1}, ""},
           {"16 links", "b.csv", 1, {0.005, 0.002, -1, -1}, {0.015, 0.01, -1, -1}, ""},
           {"32 links", "c.csv", 4, {}, {}, "it ended early"}}};
}

inline WorkPrecision made_study() {
  MadeCurves made;
  for (const int elements : {4, 8}) {
    made.curve("first", MethodFamily::structural, elements, 1, 1, 1e-7);
    made.curve("second", MethodFamily::explicit_one_step, elements, 2, 10, 2e-7);
    made.failed(Outcome::unstable, "it grew at 0.25 s").wrong();
    made.curve("fourth", MethodFamily::explicit_one_step, elements, 4, 100, 4e-7);
  }
  return made.judged();
}

inline Study made_study_of_a_case() {
  return {run_with("made").loaded, made_study()};
}

}  // namespace plumb
