#pragma once

#include "engine/study/economy/economy.h"
#include "report/figure/figures.h"

namespace plumb {

/// Picture error against cost of all candidates that were tried, with the scene's tolerance and the chosen
/// one.
Figure economy_figure(const Economy& economy);

}  // namespace plumb
