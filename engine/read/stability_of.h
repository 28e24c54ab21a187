#pragma once

#include "engine/case/case.h"

namespace plumb {

/// The stability study of a case: what its table says, or the defaults where it has none.
StabilitySpec stability_of(const Case& spec);

}  // namespace plumb
