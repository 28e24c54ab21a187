#include <plumb/plumb.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

// A cable that hangs at rest is stretched by its own weight: its end goes down by ρ g L² / 2E.

const char* const hanging = R"(
title = "A cable at rest"
cable = { length = 10, area = 1e-4, density = 7800, youngs_modulus = 2e8, elements = 4 }
start = { direction = [0, 0, -1] }
supports = { first = "pinned" }
loads = { gravity = [0, 0, -9.81] }
method = { name = "statics", step = 0.1 }
time = { end = 1, output_interval = 1 }
probe = [{ name = "end", at = 1.0 }]
)";

int main() {
  const plumb::CaseRun run = plumb::run_case({hanging, {}, {"cable.strain = \"engineering-material\""}});
  const double found = run.q.back()[run.q.back().size() - 4];  // z of the last node
  const double right = -10 - 7800 * 9.81 * 100 / (2 * 2e8);
  std::printf("%s after %ld load steps: the end is at %.12g m, %.12g m by the formula\n", run.outcome.c_str(),
              run.steps, found, right);
  if (run.outcome != "completed" || std::abs(found - right) > 1e-8) return 1;
  for (const plumb::ProbeColumn& column : run.probes)
    if (column.name == "end.z" && column.values.back() != found) return 1;

  try {
    plumb::run_case({"title = 3", {}, {}});
    return 1;  // a case that is none must not run
  } catch (const std::runtime_error& error) {
    std::printf("%s\n", error.what());
  }
}
