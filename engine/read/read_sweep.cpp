#include "engine/read/case_sections.h"

namespace plumb {

SweepSpec read_sweep(TableReader table, const CableSpec& cable) {
  constexpr int most_cases = 1000000;
  constexpr double greatest_seed = 1e15;
  SweepSpec spec = default_sweep(cable);
  spec.cases = table.whole("cases", 1, most_cases, spec.cases);
  spec.seed = static_cast<long>(
      table.number("seed", Range::whole_between(0, greatest_seed), static_cast<double>(spec.seed)));
  spec.tolerance = read_accuracy(table, cable, spec.tolerance);
  spec.time_limit = table.number("time_limit", Range::positive("s"), spec.time_limit);
  table.finish();
  return spec;
}

SweepSpec default_sweep(const CableSpec& cable) {
  constexpr double share_of_length = 1e-3;
  return {.cases = 2000, .seed = 1, .tolerance = share_of_length * cable.length, .time_limit = 0.5};
}

}  // namespace plumb
