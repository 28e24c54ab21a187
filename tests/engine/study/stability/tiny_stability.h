#pragma once

#include "engine/case/case_source.h"
#include "engine/study/stability/run_stability.h"
#include "engine/study/stability/stability_file.h"
#include "tests/engine/study/in_memory.h"

namespace plumb {

/// A pendulum whose stability study takes well under a second.
inline LoadedCase tiny_stability_case(const std::string& more = "") {
  return load_case(CaseSource{{"tiny.toml", R"(title = "Tiny"
[parameters]
f = 5
[cable]
length = 1.0
area = "1e-6 * f^2"
density = "8000 / f^2"
youngs_modulus = "1e9 / f^4"
elements = 2
[start]
angular_velocity = [0, 4, 0]
[supports]
first = "pinned"
[loads]
gravity = [0, -9.81, 0]
[method]
name = "rk4"
step = 1e-3
[time]
end = 0.1
output_interval = 0.01
[study.stability]
parameter_values = [2, 5]
elements = [1, 2]
durations = [0.05, 0.1, 0.2]
methods = ["velocity-verlet", "rk4", "trapezoidal", "generalized-alpha", "arkode-erk"]
steps = 5
largest_step = 0.02
smallest_step = 2e-4
tightest_tolerance = 1e-6
limit_methods = ["velocity-verlet"]
)" + more},
                              {},
                              {}});
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
