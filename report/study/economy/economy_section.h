#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/study/economy/economy.h"

namespace plumb {

/// What results.json says of the choice for a scene: keys as in output/README.md.
nlohmann::ordered_json economy_document(const Economy& economy, const SceneSpec& scene);

/// The section of the page that says what the scene needs, from that. Throws nlohmann's exceptions where it
/// is not what economy_document made.
std::string economy_section(const nlohmann::ordered_json& document);

}  // namespace plumb
