#include "engine/case/given_run.h"

namespace plumb {

const GivenColumn* GivenRun::find(std::string_view name) const {
  for (const GivenColumn& column : columns)
    if (column.name == name) return &column;
  return nullptr;
}

bool reports_given_run(const Case& spec) {
  return spec.method.name.empty() && !spec.given_runs.empty();
}

std::string reported_name(const Case& spec) {
  return reports_given_run(spec) ? spec.given_runs.front().name : "Plumb";
}

const ProbeSpec* tip_probe(const Case& spec) {
  for (const ProbeSpec& probe : spec.probes)
    if (probe.at == 1 && probe.quantity == Quantity::position) return &probe;
  return nullptr;
}

std::string computed_by(const GivenRunSpec& spec) {
  return spec.program.empty() ? spec.file : spec.program + " (" + spec.file + ")";
}

}  // namespace plumb
