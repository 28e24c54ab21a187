#include "engine/study/work_precision/timing.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {
namespace {

constexpr double long_run = 0.1, short_run = 0.01;  // s
constexpr double enough_agreement = 0.02;
constexpr int short_runs_as_often = 4;

}  // namespace

bool is_timed(const std::vector<double>& seconds, int repeats) {
  if (seconds.empty()) return false;
  std::vector<double> least = seconds;
  std::sort(least.begin(), least.end());
  const double time = least.front();
  if (time >= long_run) return true;
  if (std::ssize(seconds) >= (time < short_run ? short_runs_as_often * repeats : repeats)) return true;
  return seconds.size() > 1 && least[1] <= (1 + enough_agreement) * time;
}

std::string timing_rule() {
  return fmt::format(
      "runs of {:g} s or more are timed once, shorter ones until their two least times agree to {:g} %, or "
      "as "
      "often as the case says",
      long_run, 100 * enough_agreement);
}

}  // namespace plumb
