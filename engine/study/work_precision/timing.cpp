#include "engine/study/work_precision/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

#include "engine/base/parallel.h"

namespace plumb {
namespace {

constexpr double long_run = 0.1, short_run = 0.01;  // s
constexpr double enough_agreement = 0.02;
constexpr int short_runs_as_often = 4;

constexpr int pieces_to_time = 4;

}  // namespace

double slowdown_in_company(const std::function<double()>& piece) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  if (cores == 1) return 1;
  const auto least_of = [&](const std::function<bool(int)>& goes_on) {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; goes_on(k); ++k) {
      const double seconds = piece();
      if (k < pieces_to_time) least = std::min(least, seconds);
    }
    return least;
  };
  const double alone = least_of([](int k) { return k < pieces_to_time; });
  // Each goes on while others are being timed, but not for ever, as there may be fewer threads than cores.
  constexpr int most_pieces = 4 * pieces_to_time;
  std::atomic<std::size_t> timed = 0;
  std::vector<double> beside(cores);
  for_each_in_parallel(cores, [&](std::size_t core) {
    beside[core] = least_of([&](int k) {
      if (k == pieces_to_time) ++timed;
      return k < pieces_to_time || (timed < cores && k < most_pieces);
    });
  });
  return *std::max_element(beside.begin(), beside.end()) / alone;
}

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
