#pragma once

#include <string>

#include "engine/run/run.h"
#include "tests/engine/made_case.h"

namespace plumb {

/// A run of three outputs made by hand: a vertical cable whose tip falls as −t², beside figures that know it.
/// `of_reference` are further tables of those.
inline Run run_with(const std::string& title, const std::string& extra = "",
                    const std::string& of_reference = "") {
  CaseSource source;
  source.file = {"made/by<hand>.toml", "title = \"" + title + "\"\n" + soft_cable + R"(elements = 1
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
  source.references = {MadeReference{.rows = "[0.0, 0.0], [0.5, -0.25], [1.0, -0.9]",
                                     .title = "known <b>",
                                     .source = "a & b",
                                     .more = of_reference}
                           .text()};
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
