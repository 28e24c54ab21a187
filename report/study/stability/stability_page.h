#pragma once

#include <string>
#include <vector>

#include "report/figure/pictures.h"
#include "report/study/stability/stability_results.h"

namespace plumb {

/// The page of a stability study: one file that opens offline. `pictures` are those of draw_stability.
std::string to_stability_page(const StabilityResults& results, const std::vector<Picture>& pictures);

}  // namespace plumb
