#include "engine/base/known_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

double gap_after(const std::vector<double>& outputs, std::size_t k) {
  return k + 1 < outputs.size() ? outputs[k + 1] - outputs[k] : std::numeric_limits<double>::infinity();
}

double smaller_gap_about(const std::vector<double>& outputs, std::size_t k) {
  const double after = gap_after(outputs, k);
  return k > 0 ? std::min(after, gap_after(outputs, k - 1)) : after;
}

/// Of the times of a run as it writes them: 0.3 s and 300 ms are the same time, but not the same number.
/// Never as much as a part of a gap, and of the time itself, however far away the last output is.
double rounding_at(const std::vector<double>& outputs, std::size_t k) {
  const double gap = smaller_gap_about(outputs, k);
  return std::min(1e-9 * std::max(std::abs(outputs[k]), std::isfinite(gap) ? gap : 0), 1e-3 * gap);
}

}  // namespace

std::optional<KnownTime> known_time(const std::vector<double>& outputs, double t) {
  if (outputs.empty() || std::isnan(t)) return {};
  const auto above =
      static_cast<std::size_t>(std::lower_bound(outputs.begin(), outputs.end(), t) - outputs.begin());
  const std::size_t before = above == 0 ? 0 : above - 1, after = std::min(above, outputs.size() - 1);
  const double to_before = std::abs(t - outputs[before]), to_after = std::abs(outputs[after] - t);
  const std::size_t nearest = to_after <= to_before ? after : before;
  const double distance = std::min(to_before, to_after);
  if (distance <= rounding_at(outputs, nearest)) return KnownTime{outputs[nearest], true, nearest, 0};
  if (before == after || above == outputs.size()) return {};
  return KnownTime{t, false, before, distance};
}

std::vector<std::size_t> tried_outputs(const std::vector<double>& outputs, const KnownTime& at) {
  std::vector<std::size_t> tried;
  if (at.output || outputs.size() < fewest_outputs) return tried;
  const std::size_t first = std::max<std::size_t>(at.before, 2) - 1;
  const std::size_t last = std::min(at.before + 2, outputs.size() - 2);
  for (std::size_t k = first; k <= last; ++k) tried.push_back(k);
  return tried;
}

double tried_distance(const std::vector<double>& outputs, const KnownTime& at) {
  double farthest = 0;
  for (const std::size_t k : tried_outputs(outputs, at))
    if (k == at.before || k == at.before + 1) farthest = std::max(farthest, smaller_gap_about(outputs, k));
  return farthest;
}

}  // namespace plumb
