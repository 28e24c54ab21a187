#pragma once

#include "engine/study/uncertainty/error_budget.h"
#include "report/page/page_section.h"

namespace plumb {

/// The error budget of a run as a section of its report.
RunSection budget_section(const ErrorBudget& budget);

/// How a page shows it.
PageSection budget_on_page();

}  // namespace plumb
