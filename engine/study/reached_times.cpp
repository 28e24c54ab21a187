#include "engine/study/reached_times.h"

#include <algorithm>

namespace plumb {

std::vector<double> reached_times(const Reference& reference, const TimeSpec& time, const Trajectory& run) {
  constexpr double rounding = 1e-9;
  std::vector<double> times;
  if (run.times.empty()) return times;
  const double last = std::min(time.end, run.times.back()) + rounding * time.end;
  for (const double t : reference.times)
    if (t <= last) times.push_back(std::min(t, run.times.back()));
  return times;
}

}  // namespace plumb
