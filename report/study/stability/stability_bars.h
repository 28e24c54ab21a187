#pragma once

#include <string>

#include "engine/study/stability/stability.h"

namespace plumb {

/// One bar a method over the step, or the tolerance, on a logarithmic axis, in the colours of the outcomes,
/// with the predicted limit and the critical step that was found: for the case's own value first, and for up
/// to eleven others of the same axis, that a reader switches to without scripts. HTML.
std::string stability_bars(const Stability& study);

/// What shows the value that is chosen. CSS.
std::string stability_bars_css(const Stability& study);

}  // namespace plumb
