#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb {

/// The validation uncertainty of a report as HTML, from the `uncertainty` of its document. Throws nlohmann's
/// exceptions where that is not as output/README.md says.
std::string uncertainty_section(const nlohmann::ordered_json& uncertainty);

}  // namespace plumb
