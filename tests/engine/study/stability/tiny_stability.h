#pragma once

#include "engine/study/stability/run_stability.h"
#include "engine/study/stability/stability_file.h"
#include "tests/engine/made_case.h"
#include "tests/engine/study/in_memory.h"

namespace plumb {

/// A pendulum whose stability study takes well under a second.
inline LoadedCase tiny_stability_case(const std::string& more = "") {
  return tiny_pendulum("0.1", R"([study.stability]
parameter_values = [2, 5]
elements = [1, 2]
durations = [0.05, 0.1, 0.2]
methods = ["velocity-verlet", "rk4", "trapezoidal", "generalized-alpha", "arkode-erk"]
steps = 5
largest_step = 0.02
smallest_step = 2e-4
tightest_tolerance = 1e-6
limit_methods = ["velocity-verlet"]
)" + more);
}

/// That study, made once.
inline const StabilityStudyFile& tiny_stability() {
  static const StabilityStudyFile study = [] {
    const LoadedCase loaded = tiny_stability_case();
    return StabilityStudyFile{loaded, run_stability(loaded, InMemory())};
  }();
  return study;
}

}  // namespace plumb
