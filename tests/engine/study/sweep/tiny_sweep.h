#pragma once

#include "engine/case/case_source.h"

namespace plumb {

/// A pendulum to make random cases of.
inline LoadedCase tiny_sweep_case(const std::vector<std::string>& overrides = {}) {
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
end = 0.05
output_interval = 0.01
[study.sweep]
cases = 60
seed = 1
time_limit = 0.2
)"},
                              overrides,
                              {}});
}

}  // namespace plumb
