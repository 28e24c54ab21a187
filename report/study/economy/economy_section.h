#pragma once

#include <optional>

#include "engine/run/run.h"
#include "engine/study/economy/economy.h"
#include "report/page/page_section.h"

namespace plumb {

/// What the scene of a run needs, as a section of its report with a verdict on whether the run holds for it.
/// Of a run that was left to its scene and whose choice is not at hand there is a verdict that is not run; of
/// any other without a choice, no section.
std::vector<RunSection> economy_sections(const Run& run, const std::optional<Economy>& economy);

/// How a page shows it.
PageSection economy_on_page();

/// The name, in the provenance of a run, of that its model and method were left to its scene.
inline constexpr const char* left_to_scene = "left to the scene";

}  // namespace plumb
