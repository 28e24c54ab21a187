#pragma once

#include "engine/study/sensitivity/sensitivity.h"
#include "report/page/page_section.h"
#include "report/verdict/run_section.h"

namespace plumb {

/// What the criteria of a run notice, beside its report: weak ones are remarked on in their verdicts.
RunSection sensitivity_section(const Sensitivity& found);

PageSection sensitivity_on_page();

}  // namespace plumb
