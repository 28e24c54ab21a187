#include "engine/read/case_sections.h"

namespace plumb {

SweepSpec read_sweep(TableReader table, const CableSpec& cable) {
  SweepSpec spec = default_sweep(cable);
  table.read(spec);
  table.finish();
  check_accuracy(table, spec.tolerance, cable);
  return spec;
}

SweepSpec default_sweep(const CableSpec& cable) {
  constexpr double share_of_length = 1e-3;
  return {.cases = 2000, .seed = 1, .tolerance = share_of_length * cable.length, .time_limit = 0.5};
}

}  // namespace plumb
