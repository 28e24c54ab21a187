#include <fmt/format.h>

#include "engine/input/case_sections.h"

namespace plumb {

SweepSpec read_sweep(TableReader table, const CableSpec& cable) {
  constexpr int most_cases = 1000000;
  constexpr double greatest_seed = 1e15;
  SweepSpec spec = default_sweep(cable);
  spec.cases = table.whole("cases", 1, most_cases, spec.cases);
  spec.seed = static_cast<long>(
      table.number("seed", Range::whole_between(0, greatest_seed), static_cast<double>(spec.seed)));
  spec.tolerance = table.number("tolerance", Range::positive("m"), spec.tolerance);
  spec.time_limit = table.number("time_limit", Range::positive("s"), spec.time_limit);
  table.finish();
  // Hardly any run is further off than that.
  if (spec.tolerance > cable.length)
    table.refuse_value("tolerance",
                       fmt::format("must be at most the length of the cable, {:g} m", cable.length));
  return spec;
}

SweepSpec default_sweep(const CableSpec& cable) {
  constexpr double share_of_length = 1e-3;
  return {.cases = 2000, .seed = 1, .tolerance = share_of_length * cable.length, .time_limit = 0.5};
}

}  // namespace plumb
