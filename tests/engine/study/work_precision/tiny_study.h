#pragma once

#include "engine/study/work_precision/run_work_precision.h"
#include "tests/engine/made_case.h"

namespace plumb {

/// A pendulum whose study takes well under a second: two methods on one mesh for a twentieth of a second.
inline LoadedCase tiny_study_case(const std::string& more = "") {
  return tiny_pendulum("0.05", R"([study.work_precision]
elements = [2, 4]
methods = ["rk4", "generalized-alpha"]
points = 5
largest_step = 5e-3
smallest_step = 1e-4
tightest_tolerance = 1e-8
repeats = 2
)" + more);
}

}  // namespace plumb
