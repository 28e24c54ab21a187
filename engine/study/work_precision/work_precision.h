#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/method_info.h"
#include "engine/integrate/trajectory.h"
#include "engine/run/provenance.h"
#include "engine/study/reference/certified_reference.h"
#include "engine/study/reference/error_norms.h"

namespace plumb {

/// One run of a work-precision study: what was run, what it cost and how far it was off. A run that failed,
/// went wrong or ran out of time is kept with its outcome.
struct WorkPrecisionRun {
  MethodSpec method;
  int elements = 0;
  Outcome outcome = Outcome::not_run;
  std::string message;  ///< for an outcome other than completed
  Counters counters;    ///< of one run
  /// Of the processor in the time loop, one an undisturbed repeat, in the order taken. Of a run that did not
  /// complete: once, up to where it ended.
  std::vector<double> seconds = {};
  /// As of its trajectory; known while the study is made.
  double foreseen_seconds = -1;
  ErrorNorms time_error;   ///< against the same mesh integrated exactly
  ErrorNorms total_error;  ///< against the mesh-converged solution

  bool completed() const { return outcome == Outcome::completed; }
  /// The least of `seconds`; -1: not timed.
  double work_seconds() const;
  /// "step 5e-4 s", "rtol 1e-8": what was varied along the curve.
  std::string setting() const;
};

/// The order of accuracy seen along a curve: the slope of log error over log step by least squares.
struct ObservedOrder {
  double order = -1;                           ///< -1: no asymptotic part with three runs was found
  double deviation = 0;                        ///< standard deviation of the slope
  double largest_step = 0, smallest_step = 0;  ///< the part that was used, s
};

/// A method with its variant on one mesh, over a range of steps or tolerances.
struct MethodCurve {
  std::string label;  ///< "generalized-alpha, ρ∞ = 0.5"; the same on every mesh
  std::string method;
  MethodFamily family = MethodFamily::explicit_one_step;
  int elements = 0;
  std::vector<std::size_t> runs;  ///< indices into WorkPrecision::runs, from the largest step or tolerance
  std::string stated_order;
  ObservedOrder observed;    ///< of time_error.tip_max over the mean step
  std::string ending = {};   ///< why the curve has no finer runs, in words; empty: it has all that were asked
  bool conspicuous = false;  ///< the errors flatten together with those of two or more other curves
};

/// Three or more curves that stop at one error: the reference or something they share is the reason.
struct CommonFloor {
  double error = 0;  ///< m
  std::vector<std::size_t> curves;
};

/// What the mesh alone does: Richardson extrapolation and the grid convergence index.
struct MeshConvergence {
  std::vector<int> elements;  ///< coarse to fine
  std::vector<double>
      distance;  ///< of each mesh, integrated exactly, to the finest: tip, greatest over time, m
  /// Of each mesh to the next finer one, m: one less than `elements`. The last three meshes give the figures
  /// below.
  std::vector<double> change;
  double observed_order = -1;          ///< -1: the changes do not fall from mesh to mesh
  double extrapolated_error = -1;      ///< Richardson's estimate of the finest mesh's own error, m
  double grid_convergence_index = -1;  ///< of the finest mesh, m, with the safety factor below
  double safety_factor = 1.25;
  std::string standard;  ///< whose formula: "ASME V&V 20-2009, section 2-4"
};

/// The cheapest run below an error, for one decade of error.
struct CheapestRun {
  double error = 0;      ///< 10^k, m
  std::size_t run = 0;   ///< index into WorkPrecision::runs
  std::string in_words;  ///< "below 1e-4 m: rk4 with 4 elements, step 5e-4 s, 0.41 ms"
};

/// A run of another program in a study: the time that the case states for it, and the errors that its file
/// has.
struct GivenPoint {
  std::string label;  ///< "24 links"
  std::string file;
  double seconds = 0;      ///< s, where it ran
  ErrorNorms time_error;   ///< against the mesh of the case integrated exactly, of the tip alone
  ErrorNorms total_error;  ///< against the mesh-converged solution, of the tip alone
  std::string why_not;     ///< it has no error; empty: it has, where there is a reference
};

/// The points of a [[run]] with a time, or with several.
struct GivenCurve {
  std::string name;     ///< of the [[run]]
  std::string program;  ///< may be empty
  int threads = 1;
  std::string machine;    ///< empty, and without a yardstick: this one
  double yardstick = -1;  ///< s, there; -1: not stated
  std::vector<GivenPoint> points;

  bool is_elsewhere() const { return !machine.empty() || yardstick > 0; }
};

/// A work-precision study of one case. Two questions are kept apart: how well time is integrated on the mesh
/// of the case (`time_front`), and how close to the continuum method and mesh together come (`total_front`).
struct WorkPrecision {
  std::string title;
  bool quick = false;      ///< the short form that `plumb run` makes
  int fixed_elements = 0;  ///< the mesh of the first question
  double end = 0;          ///< s
  double length = 0;       ///< of the cable, m
  /// Of the fastest vibration of the case's mesh at the start, rad/s; 0: none.
  double fastest_frequency = 0;
  /// False where its runs were computed on unlike machines, so that they have no times and work is counted.
  bool timed = true;
  std::vector<WorkPrecisionRun> runs;
  std::vector<MethodCurve> curves;
  std::vector<CertifiedReference> mesh_references;  ///< one a mesh
  CertifiedReference converged_reference;
  /// Richardson's estimate of the mesh error of the converged reference itself, m; -1: not known.
  double converged_mesh_error = -1;
  /// Pareto front of work and time_error.tip_max on the fixed mesh, of the runs that are not wrong.
  std::vector<std::size_t> time_front;
  std::vector<std::size_t> total_front;  ///< of work and total_error.tip_max over all meshes
  std::vector<CheapestRun> time_cheapest;
  std::vector<CheapestRun> total_cheapest;
  std::vector<CommonFloor> common_floors;
  std::optional<MeshConvergence> mesh;
  std::vector<GivenCurve> given_curves;  ///< of other programs; fronts and cheapest runs are without them
  double yardstick = -1;                 ///< here, s; -1: not measured, as no curve asks for it
  Provenance provenance;

  /// Whether any run has a time, or none completed: what `timed` is of a finished study.
  bool has_times() const;
  /// What a run cost: seconds of the time loop where the study is timed, and force evaluations otherwise; -1:
  /// not known.
  double work(const WorkPrecisionRun& run) const;
  /// The same of a point of another program, whose seconds are multiplied by the ratio of the yardsticks here
  /// and there where both are known; -1 where the study is not timed.
  double work(const GivenCurve& curve, const GivenPoint& point) const;
  /// Whether the times of a curve are scaled to this machine.
  bool is_scaled(const GivenCurve& curve) const { return curve.yardstick > 0 && yardstick > 0; }
  /// "0.41 ms", "1.2 s"; "1520 force evaluations".
  std::string work_in_words(double work) const;
  /// "time loop [s]", "force evaluations"
  std::string work_axis() const { return timed ? "time loop [s]" : "force evaluations"; }
};

/// A completed run that is further off than this share of the length is stable but wrong.
inline constexpr double wrong_beyond = 0.1;

}  // namespace plumb
