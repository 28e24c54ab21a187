#pragma once

#include "engine/study/sensitivity/sensitivity.h"
#include "report/figure/figures.h"

namespace plumb {

/// Bars of the smallest change of each number that each criterion notices, up or down.
Figure sensitivity_figure(const Sensitivity& found);

}  // namespace plumb
