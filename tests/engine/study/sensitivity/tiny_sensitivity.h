#pragma once

#include <algorithm>
#include <cmath>

#include "engine/integrate/integrate.h"
#include "engine/study/sensitivity/run_sensitivity.h"
#include "tests/engine/made_case.h"

namespace plumb {

/// A tenth of a second of a pendulum, with what is asked of it.
inline LoadedCase tiny_sensitivity_case(const std::string& asked = "") {
  return tiny_pendulum("0.1", R"([[probe]]
name = "tip"
at = 1
[sensitivity]
)" + asked);
}

/// Holds the tip at the end against where that of tiny_sensitivity_case() comes to, in height and across.
inline std::vector<JudgedCriterion> judged_tip(const Run& run, double height, double across) {
  const auto last = [&](const char* column) { return run.probes.find(column)->values.back(); };
  const auto criterion = [](const char* name, double found, double limit) {
    return JudgedCriterion{name, "m", limit, found, found <= limit};
  };
  return {criterion("height", std::abs(last("tip.y") - height), 1e-3),
          criterion("across", std::abs(last("tip.z") - across), 10)};
}

/// What `judged_tip` finds of the case as it is.
inline Judge tiny_judge(const LoadedCase& loaded) {
  const Trajectory trajectory = integrate(loaded.spec);
  const ProbeTable probes = probe(loaded.spec, trajectory);
  return [height = probes.find("tip.y")->values.back(), across = probes.find("tip.z")->values.back()](
             const Run& run) { return judged_tip(run, height, across); };
}

}  // namespace plumb
