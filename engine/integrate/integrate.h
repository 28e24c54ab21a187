#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/method.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// Called now and then with the time reached, s.
using Progress = std::function<void(double)>;

inline constexpr double no_time_limit = std::numeric_limits<double>::infinity();

/// How long a time loop may take.
struct TimeLimit {
  TimeLimit(double allowed, std::vector<double> times_that_matter = {})
      : seconds(allowed), looked_at(std::move(times_that_matter)) {}

  double seconds;  ///< of the processor
  /// Times at which the run is looked at, s, rising: it ends as soon as it is foreseen to be far over the
  /// limit before it comes to the next of them (CostForecast). None: nothing is foreseen.
  std::vector<double> looked_at;
};

/// The output times of a run: 0, every multiple of the interval, and the end.
std::vector<double> output_times(const TimeSpec& time);

/// Integrates the cable of a case from its start. A failure of the method is an outcome, with what was
/// computed up to then kept; so is a time loop of more than `limit`, at which is looked every few steps, and
/// after each one that takes long. Throws Interrupted if the user stops it.
Trajectory integrate(const Case& spec, const Progress& progress = {}, TimeLimit limit = no_time_limit);

/// The same for any cable and start, e.g. a start that no case describes.
Trajectory integrate(const Cable& cable, const State& start, const MethodSpec& method, const TimeSpec& time,
                     const Progress& progress = {}, TimeLimit limit = no_time_limit);

}  // namespace plumb
