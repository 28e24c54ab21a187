#pragma once

#include "tests/engine/made_case.h"

namespace plumb {

/// A pendulum to make random cases of.
inline LoadedCase tiny_sweep_case(const std::vector<std::string>& overrides = {}) {
  return tiny_pendulum("0.05", R"([study.sweep]
cases = 60
seed = 1
time_limit = 0.2
)",
                       overrides);
}

}  // namespace plumb
