#pragma once

#include "engine/study/uncertainty/uncertainty.h"
#include "report/page/page_section.h"

namespace plumb {

/// The validation uncertainty of a run as a section of its report. To the text of each verdict it adds its
/// comparison error E where that is greatest, the validation uncertainty there, and what follows; those
/// without an estimate stay as they are. `spec` is the case of the run.
RunSection uncertainty_section(const Uncertainty& uncertainty, const Case& spec);

/// How a page shows it.
PageSection uncertainty_on_page();

}  // namespace plumb
