#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "engine/case/case_source.h"

namespace plumb {

/// A reference file made by hand: one series over time, in m.
struct MadeReference {
  std::string rows;  ///< "[0.0, 0.0], [0.5, -0.25]"
  std::string file = "known.toml";
  std::string title = "known";
  std::string kind = "published";
  std::string source = "a";
  std::string series = "y";
  double uncertainty = 0.01;
  std::string basis = "guess";
  std::string more = {};  ///< tables after that of the series

  NamedText text() const {
    return {file, fmt::format(R"(title = "{}"
kind = "{}"
source = "{}"
obtained = "by hand"
time_unit = "s"
columns = ["t", "{}"]
rows = [{}]
[[series]]
name = "{}"
description = "height"
figure = "Fig. 1"
unit = "m"
uncertainty = {}
uncertainty_basis = "{}"
{})",
                              title, kind, source, series, rows, series, uncertainty, basis, more)};
  }
};

/// [cable] of a soft one of 2 m, without its mesh.
inline constexpr const char* soft_cable = R"([cable]
length = 2
area = 1e-6
density = 1000
youngs_modulus = 1e6
)";

/// A soft pendulum of two elements that swings up to `end` (s), with `more` tables after its own.
inline LoadedCase tiny_pendulum(const std::string& end, const std::string& more,
                                const std::vector<std::string>& overrides = {}) {
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
output_interval = 0.01
end = )" + end + "\n" + more},
                              overrides,
                              {}});
}

}  // namespace plumb
