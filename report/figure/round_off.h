#pragma once

#include "render/plot/plot.h"

namespace plumb {

/// Shows values that are no more than rounding makes as what they are: where no |y| of the panel is above
/// `round_off` (> 0), its axis is drawn so wide that they look like nothing, with the band of that height
/// marked. Otherwise does nothing.
void mark_round_off(Panel& panel, double round_off);

}  // namespace plumb
