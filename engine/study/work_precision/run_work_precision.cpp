#include "engine/study/work_precision/run_work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/integrate/cost_forecast.h"
#include "engine/integrate/integrate.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "engine/study/reference/grid_convergence.h"
#include "engine/study/reference/method_curves.h"
#include "engine/study/slowdown.h"
#include "engine/study/work_precision/given_curves.h"
#include "engine/study/work_precision/timing.h"
#include "engine/study/work_precision/work_precision_members.h"
#include "engine/study/yardstick.h"

namespace plumb {
namespace {

/// A mesh of the study with what its runs are held against.
struct Mesh {
  int elements;
  StudyReference reference;
};

/// The runs that were made of a curve, and why there are no more.
struct CurveRuns {
  std::vector<WorkPrecisionRun> runs;
  std::string ending;
};

template <class Archive>
void members(Archive& a, CurveRuns& curve) {
  a("runs", curve.runs);
  a("ending", curve.ending);
}

/// One curve on one mesh.
struct CurveTask {
  const CurvePlan* plan;
  const Mesh* mesh;
  CurveRuns made;
};

class Computation {
 public:
  Computation(const Case& spec, bool quick, Runner& runner, std::span<const GivenRun> given)
      : spec_(spec),
        given_(given),
        what_(work_precision_of(spec)),
        extent_(quick ? what_.quick : what_.full),
        quick_(quick),
        runner_(runner) {
    spec_.time.end = what_.end;
    spec_.work_precision.reset();
  }

  WorkPrecision make() {
    make_references();
    slowdown_ = slowdown_in_company(on_mesh(fixed_elements()), runner_);
    make_curves();
    const double own_yardstick = take_yardstick();
    runner_.conclude();
    WorkPrecision study = collect();
    study.yardstick = own_yardstick;
    // Times of unlike machines tell nothing of methods.
    if (!runner_.alike({"errors", "yardstick"}))
      for (WorkPrecisionRun& run : study.runs) run.seconds.clear();
    evaluate(study);
    study.provenance = runner_.provenance();
    study.provenance.emplace_back(
        "timing", fmt::format("of the processor; {}; {}", slowdown_in_words(slowdown_), timing_rule()));
    return study;
  }

 private:
  int fixed_elements() const { return spec_.cable.elements; }

  Case on_mesh(int elements) const {
    Case spec = spec_;
    spec.cable.elements = elements;
    return spec;
  }

  /// How well the two methods of a reference should agree, m. On the mesh of the case, time integration is in
  /// question and curves go down to the tightest tolerance; on the others the mesh errs by far more.
  double target(int elements) const {
    constexpr double for_other_meshes = 1e-9, quick_target = 1e-11, round_off = 2e-13;
    if (elements != fixed_elements()) return for_other_meshes * spec_.cable.length;
    const double share = std::max(0.01 * what_.tightest_tolerance, round_off);
    return (quick_ ? std::max(share, quick_target) : share) * spec_.cable.length;
  }

  void make_references() {
    for (const int elements : extent_.elements) meshes_.push_back({elements, {}});
    meshes_.push_back({2 * extent_.elements.back(), {}});
    // As references are worth far more than any one run, they may take longer.
    const double time_limit = (quick_ ? 30 : 60) * extent_.time_limit;
    std::vector<Trajectory> trajectories(meshes_.size());
    std::vector<StudyPoint<StudyReference>> points;
    for (std::size_t k = 0; k < meshes_.size(); ++k) {
      const int elements = meshes_[k].elements;
      const double wanted = target(elements);
      const std::string what = fmt::format("{} elements to {} m", elements, wanted);
      const auto make = [&, k, elements, wanted] {
        StudyReference made = make_reference(on_mesh(elements), wanted, time_limit);
        trajectories[k] = std::move(made.trajectory);
        if (trajectories[k].times.empty()) made.method = {};
        return made;
      };
      // One that agrees as well as it should will do whatever time it was given; another one might agree
      // better in more.
      const auto agrees = [wanted](const StudyReference& known) {
        return known.certificate.agreement >= 0 && known.certificate.agreement <= wanted;
      };
      points.push_back({fmt::format("{} in {} s", what, time_limit),
                        [this, what, make, agrees] {
                          return runner_.once<StudyReference>("agreed references", {what, make}, agrees);
                        },
                        1.0 * elements});
    }
    std::vector<StudyReference> made = runner_.run({"references", Division::shared}, points);
    for_each_in_parallel(meshes_.size(), [&](std::size_t k) {
      Mesh& mesh = meshes_[k];
      mesh.reference = std::move(made[k]);
      mesh.reference.trajectory = std::move(trajectories[k]);
      if (!mesh.reference.trajectory.times.empty() || mesh.reference.method.name.empty()) return;
      Case spec = on_mesh(mesh.elements);  // of a reference that the journal had
      spec.method = mesh.reference.method;
      mesh.reference.trajectory = integrate(spec);
    });
  }

  /// Of a run, and of all that its errors depend on.
  std::string key(const MethodSpec& method, const Mesh& mesh) const {
    return fmt::format("{}, held against {} and {}", encode(method).dump(), encode(mesh.reference).dump(),
                       encode(meshes_.back().reference).dump());
  }

  WorkPrecisionRun made_run(const MethodSpec& method, const Mesh& mesh) const {
    Case spec = on_mesh(mesh.elements);
    spec.method = method;
    const Trajectory trajectory = integrate(spec, {}, {extent_.time_limit, {spec.time.end}});
    WorkPrecisionRun run;
    run.method = method;
    run.elements = mesh.elements;
    run.outcome = trajectory.outcome;
    run.message = trajectory.message;
    run.counters = trajectory.counters;
    if (run.completed()) {
      run.time_error = error_norms(trajectory, mesh.reference.trajectory);
      run.total_error = error_norms(trajectory, meshes_.back().reference.trajectory);
    }
    run.foreseen_seconds = trajectory.foreseen_seconds;
    time_run(run, trajectory.processor_seconds);
    return run;
  }

  WorkPrecisionRun make_run(const MethodSpec& method, const Mesh& mesh) {
    return runner_.once<WorkPrecisionRun>("runs", {key(method, mesh), [&] { return made_run(method, mesh); }},
                                          [this](const WorkPrecisionRun& known) { return will_do(known); });
  }

  /// Of a run that may be another study's: what was out of time may be in time where more is allowed, and
  /// what was timed once may be worth more.
  bool will_do(const WorkPrecisionRun& known) const {
    if (known.outcome == Outcome::out_of_time)
      return known.seconds.front() >= 0.9 * extent_.time_limit ||
             CostForecast::is_too_long(known.seconds.front(), known.foreseen_seconds, extent_.time_limit);
    return !known.completed() || is_timed(known.seconds, extent_.repeats);
  }

  /// Why a curve should have no further run, or nothing. `next` is the run that would come.
  std::string ending(const std::vector<WorkPrecisionRun>& runs, const Mesh& mesh,
                     const MethodSpec& next) const {
    const WorkPrecisionRun& last = runs.back();
    if (last.outcome == Outcome::out_of_time) return "a run was out of time, and finer ones take longer";
    if (!last.completed() || last.time_error.tip_max < 0 || runs.size() < 2) return {};
    const WorkPrecisionRun& before = runs[runs.size() - 2];
    const double error = last.time_error.tip_max, floor = 10 * mesh.reference.certificate.agreement;
    if (error < floor) return "the floor of the reference is reached";
    if (!before.completed()) return {};
    // With a margin, as the guess is only good to a factor.
    constexpr double margin = 3, steepest = 9, near = 1e4;
    const auto setting = [](const MethodSpec& method) { return method.step ? *method.step : *method.rtol; };
    const double slope =
        std::log(before.time_error.tip_max / error) / std::log(setting(before.method) / setting(last.method));
    const double expected =
        error * std::pow(setting(next) / setting(last.method), std::clamp(slope, 0.0, steepest));
    if (expected < margin * floor && error < near * floor)
      return "the next run would be below the floor of the reference";
    constexpr double negligible = 0.02;
    const auto mesh_alone = [&](const WorkPrecisionRun& run) {
      return run.time_error.tip_max <= negligible * run.total_error.tip_max;
    };
    if (mesh.elements != fixed_elements() && mesh_alone(last) && mesh_alone(before))
      return "the mesh alone errs";
    return {};
  }

  void make_curves() {
    plans_ = study_curves(what_, extent_, spec_.time.output_interval, quick_);
    std::vector<StudyPoint<CurveRuns>> points;
    for (std::size_t m = 0; m + 1 < meshes_.size(); ++m)
      for (const CurvePlan& plan : plans_) {
        tasks_.push_back({&plan, &meshes_[m], {}});
        const CurveTask task = tasks_.back();
        points.push_back(
            {fmt::format("{}, {} elements, {}", plan.label, task.mesh->elements, quick_ ? "quick" : "full"),
             [this, task] { return made_curve(*task.plan, *task.mesh); },
             static_cast<double>(points.size())});
      }
    // A run that must be timed alone might as well be made once, alone.
    std::vector<CurveRuns> curves = runner_.run({"errors", company_of_timed(slowdown_)}, points);
    for (std::size_t k = 0; k < tasks_.size(); ++k) tasks_[k].made = std::move(curves[k]);
  }

  CurveRuns made_curve(const CurvePlan& plan, const Mesh& mesh) {
    CurveRuns curve;
    for (const MethodSpec& method : plan.points) {
      if (!curve.runs.empty()) curve.ending = ending(curve.runs, mesh, method);
      if (!curve.ending.empty()) break;
      curve.runs.push_back(make_run(method, mesh));
    }
    return curve;
  }

  WorkPrecision collect() {
    WorkPrecision study;
    study.title = spec_.title;
    study.quick = quick_;
    study.fixed_elements = fixed_elements();
    study.end = spec_.time.end;
    study.length = spec_.cable.length;
    study.fastest_frequency = fastest_frequency_at_start(spec_);
    for (CurveTask& task : tasks_) {
      MethodCurve& curve = study.curves.emplace_back();
      curve.label = task.plan->label;
      curve.method = task.plan->method->name;
      curve.family = task.plan->method->family;
      curve.elements = task.mesh->elements;
      curve.stated_order = task.plan->stated_order;
      curve.ending = task.made.ending;
      for (WorkPrecisionRun& run : task.made.runs) {
        curve.runs.push_back(study.runs.size());
        study.runs.push_back(std::move(run));
      }
    }
    for (std::size_t m = 0; m + 1 < meshes_.size(); ++m)
      study.mesh_references.push_back(meshes_[m].reference.certificate);
    study.converged_reference = meshes_.back().reference.certificate;
    study.given_curves =
        given_curves(spec_, given_, reference_of(fixed_elements()), meshes_.back().reference.trajectory);
    study.mesh = mesh_convergence();
    if (study.mesh) study.converged_mesh_error = study.mesh->extrapolated_error;
    return study;
  }

  /// Without outputs where the mesh is not among those of the study.
  Trajectory reference_of(int elements) const {
    for (std::size_t m = 0; m + 1 < meshes_.size(); ++m)
      if (meshes_[m].elements == elements) return meshes_[m].reference.trajectory;
    return {};
  }

  std::optional<MeshConvergence> mesh_convergence() const {
    MeshConvergence result;
    std::vector<const Trajectory*> exact;
    for (const Mesh& mesh : meshes_)
      if (!mesh.reference.trajectory.times.empty()) {
        result.elements.push_back(mesh.elements);
        exact.push_back(&mesh.reference.trajectory);
      }
    constexpr std::size_t fewest = 3;
    const std::size_t n = exact.size();
    if (n < fewest || result.elements.back() != meshes_.back().elements) return {};
    for (std::size_t k = 0; k < n; ++k)
      result.distance.push_back(error_norms(*exact[k], *exact.back()).tip_max);
    for (std::size_t k = 0; k + 1 < n; ++k)
      result.change.push_back(error_norms(*exact[k], *exact[k + 1]).tip_max);
    const auto ratio = [&](std::size_t fine) {
      return static_cast<double>(result.elements[fine]) / result.elements[fine - 1];
    };
    const GridConvergence found = grid_convergence(result.change[n - 2], result.change[n - 3], ratio(n - 1),
                                                   ratio(n - 2), result.safety_factor);
    result.observed_order = found.order;
    result.extrapolated_error = found.error;
    result.grid_convergence_index = found.index;
    result.standard = grid_convergence_standard;
    return result;
  }

  double processor_time_of(const WorkPrecisionRun& run) const {
    Case spec = on_mesh(run.elements);
    spec.method = run.method;
    return integrate(spec).processor_seconds;
  }

  /// The time that it took, and those of repeats. One that did not complete has no time that anything is read
  /// from.
  void time_run(WorkPrecisionRun& run, double first) const {
    run.seconds = {first};
    while (run.completed() && !is_timed(run.seconds, extent_.repeats))
      run.seconds.push_back(processor_time_of(run));
  }

  /// Where a curve of another machine has one to be held against, s; else -1.
  double take_yardstick() {
    std::vector<StudyPoint<double>> points;
    if (std::any_of(spec_.given_runs.begin(), spec_.given_runs.end(),
                    [](const GivenRunSpec& run) { return run.yardstick > 0; }))
      points.push_back({fmt::format("yardstick {}", yardstick_version), [] { return yardstick().seconds; }});
    const std::vector<double> seconds = runner_.run({"yardstick", Company::alone}, points);
    return seconds.empty() ? -1 : seconds.front();
  }

  Case spec_;
  std::span<const GivenRun> given_;
  WorkPrecisionSpec what_;
  StudyExtent extent_;
  bool quick_;
  Runner& runner_;
  double slowdown_ = 1;       // of runs beside one another
  std::vector<Mesh> meshes_;  // the last one is that of the converged solution
  std::vector<CurvePlan> plans_;
  std::vector<CurveTask> tasks_;
};

}  // namespace

WorkPrecision run_work_precision(const Case& spec, bool quick, Runner& runner,
                                 std::span<const GivenRun> given) {
  return Computation(spec, quick, runner, given).make();
}

}  // namespace plumb
