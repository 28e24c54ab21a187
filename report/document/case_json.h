#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/run/run.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// What an integration did and cost, as `plumb solve --json` prints it: outcome, method, elements, end_time,
/// solve_seconds, counters, energy_drift (relative to the first kinetic energy).
nlohmann::ordered_json solve_json(const Run& run);
/// What was found of the modes of a run that looks for them, with what its probes see of each.
nlohmann::ordered_json modes_json(const Run& run);

/// A case as it was understood: every key with its value in SI units, and the text it came from.
nlohmann::ordered_json case_json(const LoadedCase& loaded);

/// Of a verdict or a distance, with the keys of `Coverage`.
nlohmann::ordered_json coverage_json(const Coverage& coverage);
nlohmann::ordered_json verdict_json(const Verdict& verdict);

}  // namespace plumb
