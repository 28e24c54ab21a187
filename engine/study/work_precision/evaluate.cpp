#include <algorithm>
#include <cmath>

#include "engine/study/reference/certified_reference.h"
#include "engine/study/work_precision/cheapest.h"
#include "engine/study/work_precision/common_floors.h"
#include "engine/study/work_precision/observed_order.h"
#include "engine/study/work_precision/pareto.h"
#include "engine/study/work_precision/run_work_precision.h"

namespace plumb {
namespace {

double smallest(const WorkPrecision& study, ErrorNorms WorkPrecisionRun::*error,
                ErrorNorms GivenPoint::*given, int elements = 0) {
  double least = -1;
  for (const WorkPrecisionRun& run : study.runs) {
    const double e = (run.*error).tip_max;
    if (run.completed() && e >= 0 && (elements == 0 || run.elements == elements) && (least < 0 || e < least))
      least = e;
  }
  const bool same_mesh = elements == 0 || elements == study.fixed_elements;
  for (const GivenCurve& curve : study.given_curves)
    for (const GivenPoint& point : curve.points)
      if (const double e = (point.*given).tip_max; same_mesh && e >= 0 && (least < 0 || e < least)) least = e;
  return least;
}

double floor_of(const WorkPrecision& study, int elements) {
  for (const CertifiedReference& reference : study.mesh_references)
    if (reference.elements == elements) return reference.floor;
  return 0;
}

/// The highest of the orders that a method may choose from, "1 to 5"; infinite where one is stated, which an
/// observation is held against.
double highest_choice(const std::string& stated) {
  const auto to = stated.find(" to ");
  return to == std::string::npos ? INFINITY : std::strtod(stated.c_str() + to + 4, nullptr);
}

void fit_order(const WorkPrecision& study, MethodCurve& curve) {
  std::vector<StepError> points;
  for (const std::size_t k : curve.runs) {
    const WorkPrecisionRun& run = study.runs[k];
    const bool usable = run.completed() && run.counters.steps > 0;
    points.push_back({usable ? study.end / static_cast<double>(run.counters.steps) : 0,
                      usable ? run.time_error.tip_max : -1});
  }
  // Where the error is no longer small to the cable, no order can be expected.
  constexpr double largest_share = 0.05;
  curve.observed = observed_order(points, floor_of(study, curve.elements), largest_share * study.length,
                                  highest_choice(curve.stated_order));
}

/// Cost and error of each run. An error below the floor counts as the floor, as it says no more than that; a
/// run that is stable but wrong counts as none.
std::vector<WorkError> work_errors(const WorkPrecision& study, ErrorNorms WorkPrecisionRun::*error,
                                   double floor, int elements = 0) {
  std::vector<WorkError> points;
  for (const WorkPrecisionRun& run : study.runs) {
    const double e = (run.*error).tip_max;
    if (!run.completed() || e < 0 || e > wrong_beyond * study.length ||
        (elements != 0 && run.elements != elements))
      points.push_back({});
    else
      points.push_back({study.work(run), std::max(e, floor)});
  }
  return points;
}

void find_floors(WorkPrecision& study) {
  std::vector<CurveErrors> errors;
  std::vector<std::size_t> places;
  for (std::size_t c = 0; c < study.curves.size(); ++c) {
    MethodCurve& curve = study.curves[c];
    curve.conspicuous = false;
    if (curve.elements != study.fixed_elements) continue;
    CurveErrors of_curve{curve.method, {}};
    for (const std::size_t k : curve.runs)
      of_curve.errors.push_back(study.runs[k].completed() ? study.runs[k].time_error.tip_max : -1);
    errors.push_back(std::move(of_curve));
    places.push_back(c);
  }
  study.common_floors = common_floors(errors);
  for (CommonFloor& floor : study.common_floors)
    for (std::size_t& curve : floor.curves) {
      curve = places[curve];
      study.curves[curve].conspicuous = true;
    }
}

}  // namespace

void evaluate(WorkPrecision& study) {
  study.timed = study.has_times();
  for (CertifiedReference& reference : study.mesh_references)
    certify(reference,
            smallest(study, &WorkPrecisionRun::time_error, &GivenPoint::time_error, reference.elements));
  certify(study.converged_reference,
          smallest(study, &WorkPrecisionRun::total_error, &GivenPoint::total_error),
          study.converged_mesh_error);
  for (MethodCurve& curve : study.curves) fit_order(study, curve);
  find_floors(study);

  std::vector<std::string> labels(study.runs.size());
  for (const MethodCurve& curve : study.curves)
    for (const std::size_t k : curve.runs) labels[k] = curve.label;
  const double ceiling = wrong_beyond * study.length;
  const double time_floor = floor_of(study, study.fixed_elements);
  const auto time_points =
      work_errors(study, &WorkPrecisionRun::time_error, time_floor, study.fixed_elements);
  study.time_front = pareto_front(time_points);
  study.time_cheapest = cheapest_runs(study, labels, time_points, time_floor, ceiling);
  const double total_floor = study.converged_reference.floor;
  const auto total_points = work_errors(study, &WorkPrecisionRun::total_error, total_floor);
  study.total_front = pareto_front(total_points);
  study.total_cheapest = cheapest_runs(study, labels, total_points, total_floor, ceiling);
}

}  // namespace plumb
