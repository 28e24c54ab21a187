#include "engine/study/work_precision/work_precision.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {

double WorkPrecisionRun::work_seconds() const {
  return seconds.empty() ? -1 : *std::min_element(seconds.begin(), seconds.end());
}

std::string WorkPrecisionRun::setting() const {
  if (method.step) return fmt::format("step {:.4g} s", *method.step);
  return method.rtol ? fmt::format("rtol {:.3g}", *method.rtol) : "";
}

}  // namespace plumb
