#include "engine/study/work_precision/work_precision.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/study/work_precision/cheapest.h"

namespace plumb {

double WorkPrecisionRun::work_seconds() const {
  return seconds.empty() ? -1 : *std::min_element(seconds.begin(), seconds.end());
}

bool WorkPrecision::has_times() const {
  const auto any = [&](auto what) { return std::any_of(runs.begin(), runs.end(), what); };
  return any([](const WorkPrecisionRun& run) { return !run.seconds.empty(); }) ||
         !any([](const WorkPrecisionRun& run) { return run.completed(); });
}

double WorkPrecision::work(const WorkPrecisionRun& run) const {
  return timed ? run.work_seconds() : static_cast<double>(run.counters.force_evaluations);
}

double WorkPrecision::work(const GivenCurve& curve, const GivenPoint& point) const {
  if (!timed) return -1;
  return is_scaled(curve) ? point.seconds * (yardstick / curve.yardstick) : point.seconds;
}

std::string WorkPrecision::work_in_words(double work) const {
  return timed ? duration_in_words(work) : fmt::format("{:.0f} force evaluations", work);
}

std::string WorkPrecisionRun::setting() const {
  if (method.step) return fmt::format("step {:.4g} s", *method.step);
  return method.rtol ? fmt::format("rtol {:.3g}", *method.rtol) : "";
}

}  // namespace plumb
