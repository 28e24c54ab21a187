#include "engine/study/work_precision/given_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/run/sampled_run.h"

namespace plumb {
namespace {

/// Sets one of the errors of a point, or why it has none.
void hold_against(const Trajectory& reference, const Case& spec, const GivenRun& run, ErrorNorms& norms,
                  std::string& why_not) {
  if (reference.times.size() < 2 || !why_not.empty()) return;
  const SampledRun sampled = sample(run, reference.times);
  if (sampled.times.size() < reference.times.size()) {
    why_not = fmt::format("it goes from {:.4g} to {:.4g} s, the study from 0 to {:.4g} s", run.times.front(),
                          run.times.back(), reference.times.back());
    return;
  }
  std::array<const std::vector<double>*, 3> tip{}, errors{};
  const std::vector<std::string> names = column_names(*tip_probe(spec));
  for (std::size_t j = 0; j < tip.size(); ++j) {
    tip[j] = &sampled.values.find(names[j])->values;
    errors[j] = &sampled.errors.find(names[j])->values;
  }
  double greatest = 0, squares = 0, interpolation = 0;
  for (std::size_t k = 0; k < reference.times.size(); ++k) {
    const Eigen::VectorXd& q = reference.q[k];
    const auto at = [k](const auto& columns) {
      return Eigen::Vector3d((*columns[0])[k], (*columns[1])[k], (*columns[2])[k]);
    };
    const double distance = (at(tip) - q.segment<3>(q.size() - 6)).norm();
    greatest = std::max(greatest, distance);
    squares += distance * distance;
    // One that is not a number stays.
    if (const double error = at(errors).norm(); !(error <= interpolation) && !std::isnan(interpolation))
      interpolation = error;
  }
  if (!bearable(interpolation, greatest)) {
    why_not = fmt::format(
        "its rows are too far apart: {}; give it a row at each output of the study, every {:.4g} s",
        std::isnan(interpolation)
            ? "what lies between them is not known"
            : fmt::format("between them the tip is known to {:.2g} m, at an error of {:.2g} m", interpolation,
                          greatest),
        spec.time.output_interval);
    return;
  }
  norms.tip_max = greatest;
  norms.tip_rms = std::sqrt(squares / static_cast<double>(reference.times.size()));
}

}  // namespace

std::vector<GivenCurve> given_curves(const Case& spec, std::span<const GivenRun> runs,
                                     const Trajectory& same_mesh, const Trajectory& converged) {
  std::vector<GivenCurve> curves;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const GivenRunSpec& given = spec.given_runs[k];
    if (!given.is_timed()) continue;
    GivenCurve curve{given.name, given.program, given.threads, given.machine, given.yardstick, {}};
    const auto add = [&](GivenPoint point, const GivenRun& run) {
      if (run.ending.failed()) point.why_not = "it failed: " + run.ending.in_words();
      hold_against(same_mesh, spec, run, point.time_error, point.why_not);
      hold_against(converged, spec, run, point.total_error, point.why_not);
      curve.points.push_back(std::move(point));
    };
    if (given.seconds > 0) add({given.name, given.file, given.seconds, {}, {}, ""}, runs[k]);
    for (std::size_t p = 0; p < given.points.size(); ++p) {
      const GivenPointSpec& point = given.points[p];
      add({point.label, point.file, point.seconds, {}, {}, ""}, runs[k].points[p]);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace plumb
