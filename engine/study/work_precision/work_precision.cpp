#include "engine/study/work_precision/work_precision.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/study/work_precision/cheapest.h"

namespace plumb {

double WorkPrecisionRun::work_seconds() const {
  return seconds.empty() ? -1 : *std::min_element(seconds.begin(), seconds.end());
}

double WorkPrecision::work(const WorkPrecisionRun& run) const {
  return timed ? run.work_seconds() : static_cast<double>(run.counters.force_evaluations);
}

std::string WorkPrecision::work_in_words(double work) const {
  return timed ? duration_in_words(work) : fmt::format("{:.0f} force evaluations", work);
}

std::string WorkPrecisionRun::setting() const {
  if (method.step) return fmt::format("step {:.4g} s", *method.step);
  return method.rtol ? fmt::format("rtol {:.3g}", *method.rtol) : "";
}

}  // namespace plumb
