#pragma once

#include "engine/case/case_source.h"
#include "engine/study/work_precision/run_work_precision.h"

namespace plumb {

/// A pendulum whose study takes well under a second: two methods on one mesh for a twentieth of a second.
inline LoadedCase tiny_study_case(const std::string& more = "") {
  return load_case(CaseSource{{"tiny.toml", R"(title = "Tiny"
[cable]
length = 1.0
area = 25e-6
density = 320
youngs_modulus = 1.6e6
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
end = 0.05
output_interval = 0.01
[study.work_precision]
elements = [2, 4]
methods = ["rk4", "generalized-alpha"]
points = 5
largest_step = 5e-3
smallest_step = 1e-4
tightest_tolerance = 1e-8
repeats = 2
)" + more},
                              {},
                              {}});
}

}  // namespace plumb
