#pragma once

#include <vector>

#include "report/figure/figures.h"

namespace plumb {

/// What happens along the cable: the range of the tension and of the curvature over time, and the axial
/// strain over time and place. A chain has no curvature. What has no finite value, or for the map fewer than
/// two outputs, has no figure.
std::vector<Figure> field_figures(const Run& run);

}  // namespace plumb
