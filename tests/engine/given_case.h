#pragma once

#include <string>

#include "tests/engine/made_case.h"

namespace plumb {

/// A case without [method] whose run is `file` as "chrono.csv", held against y = −t² at the tip.
inline CaseSource given_case(const std::string& file, const std::string& run_keys = "",
                             const std::string& extra = "") {
  CaseSource source;
  source.file = {"case.toml", R"(title = "Given"
[[run]]
file = "chrono.csv"
)" + run_keys + "\n" + soft_cable +
                                  R"([[probe]]
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
  source.references = {MadeReference{.rows = "[0.0, 0.0], [0.5, -0.25], [1.0, -1.0]"}.text()};
  source.given_runs = {{"chrono.csv", file}};
  return source;
}

}  // namespace plumb
