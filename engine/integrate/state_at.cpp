#include "engine/integrate/state_at.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb {

void hermite_in_time(const State& before, const State& after, double t, State& to) {
  const double h = after.t - before.t, x = (t - before.t) / h;
  const double x2 = x * x, x3 = x2 * x;
  to.t = t;
  to.q = (1 - 3 * x2 + 2 * x3) * before.q + (3 * x2 - 2 * x3) * after.q + h * (x - 2 * x2 + x3) * before.v +
         h * (x3 - x2) * after.v;
  to.v = (6 * x - 6 * x2) / h * (after.q - before.q) + (1 - 4 * x + 3 * x2) * before.v +
         (3 * x2 - 2 * x) * after.v;
}

State state_at(const Trajectory& trajectory, double t) {
  constexpr double same_output = 1e-9;
  const auto& times = trajectory.times;
  const auto output = [&](std::size_t k) { return State{times[k], trajectory.q[k], trajectory.v[k]}; };
  if (times.empty()) throw std::out_of_range("the trajectory is empty");
  const auto above =
      static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), t) - times.begin());
  const std::size_t before = above == 0 ? 0 : above - 1, after = std::min(above, times.size() - 1);
  const double interval = after > before ? times[after] - times[before] : times.back();
  if (std::abs(times[after] - t) <= same_output * interval) return output(after);
  if (std::abs(times[before] - t) <= same_output * interval) return output(before);
  if (after == before || t > times[after])
    throw std::out_of_range(
        fmt::format("t = {} s is outside the trajectory, which ends at {} s", t, times.back()));
  State state;
  hermite_in_time(output(before), output(after), t, state);
  return state;
}

}  // namespace plumb
