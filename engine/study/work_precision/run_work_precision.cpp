#include "engine/study/work_precision/run_work_precision.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "engine/study/reference/grid_convergence.h"
#include "engine/study/reference/method_curves.h"

namespace plumb {
namespace {

/// A mesh of the study with what its runs are held against.
struct Mesh {
  int elements;
  StudyReference reference;
};

/// One curve on one mesh, with the runs that were made of it.
struct Task {
  const CurvePlan* plan;
  const Mesh* mesh;
  std::vector<StudyRun> runs;
  std::string ending;
};

class Computation {
 public:
  Computation(const Case& spec, bool quick, StudyJournal& journal, const StudyProgress& progress)
      : spec_(spec),
        what_(work_precision_of(spec)),
        extent_(quick ? what_.quick : what_.full),
        quick_(quick),
        journal_(journal),
        progress_(progress) {
    spec_.time.end = what_.end;
    spec_.work_precision.reset();
  }

  WorkPrecision make() {
    make_references();
    make_curves();
    WorkPrecision study = collect();
    time_runs(study);
    evaluate(study);
    study.provenance = provenance_now();
    return study;
  }

 private:
  int fixed_elements() const { return spec_.cable.elements; }

  Case on_mesh(int elements) const {
    Case spec = spec_;
    spec.cable.elements = elements;
    return spec;
  }

  void say(const std::string& part, std::size_t done, std::size_t all) {
    if (!progress_) return;
    const std::lock_guard lock(saying_);
    progress_(part, all > 0 ? static_cast<double>(done) / static_cast<double>(all) : 1);
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
    std::atomic<std::size_t> done = 0;
    say("references", 0, meshes_.size());
    for_each_in_parallel(meshes_.size(), [&](std::size_t k) {
      // The finest mesh takes longest and begins first.
      Mesh& mesh = meshes_[meshes_.size() - 1 - k];
      const Case spec = on_mesh(mesh.elements);
      if (const auto known = journal_.find_reference(mesh.elements)) {
        mesh.reference = *known;
        Case with = spec;
        with.method = known->method;
        if (!with.method.name.empty()) mesh.reference.trajectory = integrate(with);
      } else {
        mesh.reference = make_reference(spec, target(mesh.elements), time_limit);
        journal_.add_reference(mesh.reference);
      }
      say("references", ++done, meshes_.size());
    });
  }

  StudyRun make_run(const MethodSpec& method, const Mesh& mesh) {
    if (const auto known = journal_.find_run(method, mesh.elements)) return *known;
    Case spec = on_mesh(mesh.elements);
    spec.method = method;
    const Trajectory trajectory = integrate(spec, {}, extent_.time_limit);
    StudyRun run;
    run.method = method;
    run.elements = mesh.elements;
    run.outcome = trajectory.outcome;
    run.message = trajectory.message;
    run.counters = trajectory.counters;
    if (run.completed()) {
      run.time_error = error_norms(trajectory, mesh.reference.trajectory);
      run.total_error = error_norms(trajectory, meshes_.back().reference.trajectory);
    } else if (run.outcome == Outcome::out_of_time) {
      run.seconds = {trajectory.solve_seconds};
    }
    journal_.add_run(run);
    if (!run.seconds.empty()) journal_.add_seconds(run);
    return run;
  }

  /// Why a curve should have no further run, or nothing. `next` is the run that would come.
  std::string ending(const std::vector<StudyRun>& runs, const Mesh& mesh, const MethodSpec& next) const {
    const StudyRun& last = runs.back();
    if (last.outcome == Outcome::out_of_time) return "a run was out of time, and finer ones take longer";
    if (!last.completed() || last.time_error.tip_max < 0 || runs.size() < 2) return {};
    const StudyRun& before = runs[runs.size() - 2];
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
    const auto mesh_alone = [&](const StudyRun& run) {
      return run.time_error.tip_max <= negligible * run.total_error.tip_max;
    };
    if (mesh.elements != fixed_elements() && mesh_alone(last) && mesh_alone(before))
      return "the mesh alone errs";
    return {};
  }

  void make_curves() {
    plans_ = study_curves(what_, extent_, spec_.time.output_interval, quick_);
    std::size_t all = 0;
    for (std::size_t m = 0; m + 1 < meshes_.size(); ++m)
      for (const CurvePlan& plan : plans_) {
        tasks_.push_back({&plan, &meshes_[m], {}, {}});
        all += plan.points.size();
      }
    std::atomic<std::size_t> done = 0;
    say("errors", 0, all);
    for_each_in_parallel(tasks_.size(), [&](std::size_t k) {
      Task& task = tasks_[tasks_.size() - 1 - k];
      for (const MethodSpec& method : task.plan->points) {
        if (!task.runs.empty()) task.ending = ending(task.runs, *task.mesh, method);
        if (!task.ending.empty()) break;
        task.runs.push_back(make_run(method, *task.mesh));
        say("errors", ++done, all);
      }
      say("errors", done += task.plan->points.size() - task.runs.size(), all);
    });
  }

  WorkPrecision collect() {
    WorkPrecision study;
    study.title = spec_.title;
    study.quick = quick_;
    study.fixed_elements = fixed_elements();
    study.end = spec_.time.end;
    study.length = spec_.cable.length;
    study.fastest_frequency = fastest_frequency_at_start(spec_);
    for (Task& task : tasks_) {
      StudyCurve& curve = study.curves.emplace_back();
      curve.label = task.plan->label;
      curve.method = task.plan->method->name;
      curve.family = task.plan->method->family;
      curve.elements = task.mesh->elements;
      curve.stated_order = task.plan->stated_order;
      curve.ending = task.ending;
      for (StudyRun& run : task.runs) {
        curve.runs.push_back(study.runs.size());
        study.runs.push_back(std::move(run));
      }
    }
    for (std::size_t m = 0; m + 1 < meshes_.size(); ++m)
      study.mesh_references.push_back(meshes_[m].reference.certificate);
    study.converged_reference = meshes_.back().reference.certificate;
    study.mesh = mesh_convergence();
    if (study.mesh) study.converged_mesh_error = study.mesh->extrapolated_error;
    return study;
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

  /// How often a run that takes this long is timed: short ones more often, as they are disturbed more easily;
  /// long ones less often. One that did not complete has no time that anything is read from.
  int repeats(const StudyRun& run, double seconds) const {
    constexpr double is_short = 0.01, is_long = 0.5;
    if (!run.completed()) return 1;
    if (seconds < is_short) return 4 * extent_.repeats;
    return seconds < is_long ? extent_.repeats : std::min(2, extent_.repeats);
  }

  void time_runs(WorkPrecision& study) {
    std::size_t done = 0;
    for (StudyRun& run : study.runs) {
      if (run.seconds.empty()) run.seconds = journal_.find_seconds(run);
      // What was out of time once would be so again.
      if (run.seconds.empty() && run.outcome != Outcome::out_of_time) {
        Case spec = on_mesh(run.elements);
        spec.method = run.method;
        std::vector<double> seconds;
        for (int wanted = 1; std::ssize(seconds) < wanted;) {
          seconds.push_back(integrate(spec).solve_seconds);
          if (seconds.size() == 1) wanted = repeats(run, seconds.front());
        }
        run.seconds = std::move(seconds);
        journal_.add_seconds(run);
      }
      say("timing", ++done, study.runs.size());
    }
  }

  Case spec_;
  WorkPrecisionSpec what_;
  StudyExtent extent_;
  bool quick_;
  StudyJournal& journal_;
  const StudyProgress& progress_;
  std::mutex saying_;
  std::vector<Mesh> meshes_;  // the last one is that of the converged solution
  std::vector<CurvePlan> plans_;
  std::vector<Task> tasks_;
};

}  // namespace

WorkPrecision run_work_precision(const Case& spec, bool quick, StudyJournal& journal,
                                 const StudyProgress& progress) {
  return Computation(spec, quick, journal, progress).make();
}

}  // namespace plumb
