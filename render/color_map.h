#pragma once

#include "render/color.h"

namespace plumb {

/// The colour of a value from 0 to 1: viridis (van der Walt, Smith and Firing 2015), whose lightness grows
/// evenly and which people with any of the common colour blindnesses read alike. Values outside are the
/// ends'.
Color map_color(double value);

}  // namespace plumb
