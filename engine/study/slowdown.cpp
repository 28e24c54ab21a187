#include "engine/study/slowdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/straight_frequency.h"

namespace plumb {
namespace {

constexpr int pieces_to_time = 4;

/// Of some milliseconds.
double seconds_of_motion(const Case& spec) {
  constexpr double share_of_limit = 0.25, limit = 2.828;
  constexpr int steps_of_elements = 25000;
  Case piece = spec;
  piece.method = plain_method(classical_explicit());
  piece.method.step = share_of_limit * limit / straight_frequency(spec.cable);
  piece.time.end = std::min(spec.time.end, *piece.method.step * steps_of_elements / spec.cable.elements);
  piece.time.output_interval = piece.time.end;
  return integrate(piece).processor_seconds;
}

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

double slowdown_in_company(const Case& spec, Runner& runner) {
  // What else the machine does for a moment looks like it, but not every time.
  constexpr int most_looks = 5;
  const auto least_of_some = [&] {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_looks && least > undisturbed; ++k)
      least = std::min(least, slowdown_in_company([&] { return seconds_of_motion(spec); }));
    return least;
  };
  return runner.run<double>({"slowdown", Company::alone, Division::shared}, {{"in company", least_of_some}})
      .front();
}

std::string slowdown_in_words(double slowdown) {
  if (slowdown == 1) return "there is but one core";
  return fmt::format("{}: a run is {:.1f} % slower with another one on each other core",
                     company_of_timed(slowdown) == Company::together ? "one run a core" : "one run at a time",
                     100 * std::max(0.0, slowdown - 1));
}

}  // namespace plumb
