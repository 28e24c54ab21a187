#pragma once

#include <string>

#include "render/plot.h"

namespace plumb {

/// The series of a plot as numbers: `panel,series,x,y`, panels from 1, 17 digits; a series without a label
/// has its number in the panel.
std::string to_csv(const Plot& plot);

}  // namespace plumb
