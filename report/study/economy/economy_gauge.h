#pragma once

#include "engine/study/economy/economy.h"

namespace plumb {

/// Holds runs of a case against each other on the pictures of its scene (ImageErrorGauge).
MakeGauge gauge_maker(const Case& spec);

}  // namespace plumb
