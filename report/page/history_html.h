#pragma once

#include "report/page/page_section.h"

namespace plumb {

/// How the page of a run shows its history: what each criterion found, and what the time loop took, over the
/// runs of the case.
PageSection history_on_page();

/// The style of the charts of a history.
extern const std::string_view history_css;

/// Two charts over the same runs of one case: the criterion that uses most of what it is allowed, as a share
/// of that, and the seconds of the time loop. `runs` is as in results.json, the latest last.
std::string history_in_small(const Document& runs);

}  // namespace plumb
