#pragma once

#include "engine/case/case_source.h"
#include "engine/study/runner.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// Makes the stability study of a case: references, maps of outcomes, critical steps, energies over time,
/// amplification of one vibration, and how fast neighbours part. The parameter is varied by reading the case
/// again. Throws InputError where the case is not valid at one of its values, and Interrupted if the user
/// stops it.
Stability run_stability(const LoadedCase& loaded, Runner& runner);

}  // namespace plumb
