#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/verdict/results.h"

namespace plumb {

/// `given_runs` of results.json: what each external run is, how it was read, and how far it is from the run
/// that is reported.
nlohmann::ordered_json given_runs_json(const Results& results);

/// The same of a case, without the distances.
nlohmann::ordered_json given_runs_json(const LoadedCase& loaded);

/// "distance of chrono to Plumb: tip.x 0.0123 m at 1.42 s (RMS 0.004 m)", one a column, from a document.
std::vector<std::string> distances_in_words(const nlohmann::ordered_json& document);

}  // namespace plumb
