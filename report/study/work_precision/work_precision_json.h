#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// The `work_precision` of results.json: runs, curves, fronts, cheapest runs, references, mesh and provenance
/// of a study. Keys as in output/README.md.
nlohmann::ordered_json work_precision_json(const WorkPrecision& study);

/// Reads it back, but for the title. Throws nlohmann's exceptions where something is missing or of another
/// kind.
WorkPrecision work_precision_from_json(const nlohmann::ordered_json& json);

}  // namespace plumb
