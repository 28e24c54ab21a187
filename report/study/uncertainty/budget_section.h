#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/figure/pictures.h"

namespace plumb {

/// The error budget of a report as HTML, from the `error_budget` of its document and what was drawn of it.
/// Throws nlohmann's exceptions where that is not as output/README.md says.
std::string budget_section(const nlohmann::ordered_json& budget, const std::vector<Picture>& pictures);

/// What the budget comes to, in one sentence: "Error budget of published: …".
std::string budget_in_words(const nlohmann::ordered_json& budget);

}  // namespace plumb
