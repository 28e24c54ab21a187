#pragma once

#include <string>
#include <vector>

#include "report/document/document.h"

namespace plumb {

/// Under which key a study that stands among reports has all of its own results.
inline constexpr const char* study_results_key = "study_results";

/// The results.json of a study, as an index takes reports: with how it ended, with `figures` of the pictures
/// that lie beside it ("figures/sweep.png"), and without probes, errors and energies, which a study as a
/// whole has not. Throws nlohmann's exceptions where it is not as output/README.md says.
Document study_as_report(const Document& study, const std::vector<std::string>& pictures);

}  // namespace plumb
