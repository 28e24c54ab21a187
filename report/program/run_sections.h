#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/run/output_folder.h"
#include "engine/study/economy/economy.h"
#include "engine/study/journal.h"
#include "report/base/stages.h"
#include "report/page/page_section.h"
#include "report/program/console.h"

/// What the report of a run may have beside what every one has: a new section is a line in each of these.
namespace plumb {

/// How the page shows each, in its order.
std::span<const PageSection> page_sections();

/// Computes what the case of a run asks for, with a progress bar, and writes it into the folder. `journal`
/// keeps what is done, `economy` is what the scene needs, where the run was left to it. `all_timed` is called
/// once there is nothing left beside which other work would disturb a timing.
std::vector<RunSection> computed_sections(const Run& run, const std::optional<Economy>& economy,
                                          Journal& journal, OutputFolder& folder, Stages& stages,
                                          Console& console, const std::function<void()>& all_timed);

/// The same of what lies beside a run, which is written anew. Throws InputError where it cannot be used.
std::vector<RunSection> sections_beside(const std::string& run_path, const Run& run, OutputFolder& folder);

}  // namespace plumb
