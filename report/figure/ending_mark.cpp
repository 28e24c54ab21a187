#include "report/figure/ending_mark.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {

void mark_ending(const Run& run, Panel& panel) {
  const Trajectory& trajectory = run.trajectory;
  if (trajectory.outcome == Outcome::completed) return;
  // No more than half is left to what is missing, so that a run that failed at once can be read.
  const double whole = run.loaded.spec.time.end;
  const double end = trajectory.end_time > 0 ? std::min(whole, 2 * trajectory.end_time) : whole;
  panel.x.range = {0, end};
  Rule missing;
  missing.upright = true;
  missing.from = std::min(trajectory.end_time, end);
  missing.to = end;
  missing.label =
      fmt::format("{} at {:.3g} s of {:.3g} s", word(trajectory.outcome), trajectory.end_time, whole);
  missing.color = Color::hex(0xA3210F);
  panel.rules.push_back(std::move(missing));
}

std::string title_of(const Run& run, const std::string& title) {
  const Trajectory& trajectory = run.trajectory;
  if (trajectory.outcome == Outcome::completed) return title;
  return fmt::format("{} – only to {:.3g} s: {}", title, trajectory.end_time, word(trajectory.outcome));
}

}  // namespace plumb
