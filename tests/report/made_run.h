#pragma once

#include <string>

#include "engine/run/run.h"

namespace plumb {

/// A run of three outputs made by hand: a vertical cable whose tip falls as −t², beside figures that know it.
inline Run run_with(const std::string& title, const std::string& extra = "") {
  CaseSource source;
  source.file = {"made/by<hand>.toml", R"(title = ")" + title + R"("
[cable]
length = 2
area = 1e-6
density = 1000
youngs_modulus = 1e6
elements = 1
[method]
name = "rk4"
step = 0.1
[time]
end = 1.0
output_interval = 0.5
[[probe]]
name = "tip"
at = 1.0
quantity = "position"
[[reference]]
name = "known"
file = "known.toml"
compare = { y = "tip.y" }
tolerance = 0.125
)" + extra};
  source.references = {{"known.toml", R"(title = "known <b>"
kind = "published"
source = "a & b"
obtained = "by hand"
time_unit = "s"
columns = ["t", "y"]
rows = [[0.0, 0.0], [0.5, -0.25], [1.0, -0.9]]
[[series]]
name = "y"
description = "height"
figure = "Fig. 1"
unit = "m"
uncertainty = 0.01
uncertainty_basis = "guess"
)"}};
  Run run;
  run.loaded = load_case(source);
  run.trajectory.outcome = Outcome::completed;
  run.trajectory.elements = 1;
  run.trajectory.element_length = 2;
  run.trajectory.end_time = 1;
  for (const double t : {0.0, 0.5, 1.0}) {
    Eigen::VectorXd q(12), v = Eigen::VectorXd::Zero(12);
    q << 0, 0, 0, 1, 0, 0, 2, -t * t, 0, 1, 0, 0;
    v[7] = -2 * t;
    run.trajectory.times.push_back(t);
    run.trajectory.q.push_back(q);
    run.trajectory.v.push_back(v);
    run.trajectory.energies.push_back({1, 0.1 * t, 0, 0});
  }
  run.probes = probe(run.loaded.spec, run.trajectory);
  return run;
}

}  // namespace plumb
