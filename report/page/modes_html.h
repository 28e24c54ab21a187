#pragma once

#include "engine/run/run.h"
#include "report/page/page_section.h"
#include "report/verdict/run_section.h"

namespace plumb {

/// The table of a run's modes.
RunSection modes_section(const Run& run);
PageSection modes_on_page();

}  // namespace plumb
