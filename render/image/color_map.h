#pragma once

#include "render/image/color.h"

namespace plumb {

/// The colour of a value from 0 to 1: viridis (van der Walt, Smith and Firing 2015), whose lightness grows
/// evenly and which people with any of the common colour blindnesses read alike. Values outside are the
/// ends'.
Color map_color(double value);

/// The colour of a value from 0 to 1 that is judged by how far it is from 0.5: blue over near white to a
/// reddish brown. Lightness falls evenly and alike to either side (steps are straight lines in B. Ottosson's
/// Oklab, 2020). Values outside are the ends'.
Color diverging_map_color(double value);

}  // namespace plumb
