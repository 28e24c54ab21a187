#pragma once

#include <string>

#include "engine/case/case_source.h"

namespace plumb {

/// A case without [method] whose run is `file` as "chrono.csv", held against y = −t² at the tip.
inline CaseSource given_case(const std::string& file, const std::string& run_keys = "",
                             const std::string& extra = "") {
  CaseSource source;
  source.file = {"case.toml", R"(title = "Given"
[[run]]
file = "chrono.csv"
)" + run_keys + R"(
[cable]
length = 2
area = 1e-6
density = 1000
youngs_modulus = 1e6
[[probe]]
name = "tip"
at = 1.0
[[probe]]
name = "strain"
at = 0.5
quantity = "axial-strain"
[[reference]]
name = "known"
file = "known.toml"
compare = { y = "tip.y" }
tolerance = 0.125
)" + extra};
  source.references = {{"known.toml", R"(title = "known"
kind = "published"
source = "a"
obtained = "by hand"
time_unit = "s"
columns = ["t", "y"]
rows = [[0.0, 0.0], [0.5, -0.25], [1.0, -1.0]]
[[series]]
name = "y"
description = "height"
figure = "Fig. 1"
unit = "m"
uncertainty = 0.01
uncertainty_basis = "guess"
)"}};
  source.given_runs = {{"chrono.csv", file}};
  return source;
}

}  // namespace plumb
