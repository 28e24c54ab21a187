#pragma once

#include <span>
#include <vector>

#include "engine/case/given_run.h"
#include "engine/integrate/trajectory.h"
#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// The curves of the external runs of a case whose times are known, in its order; of each the run itself
/// comes first where it has a time. Their tips are held against two references with the outputs of the study,
/// which may be without outputs: as error_norms() has it, but for norms that need more than the tip. An
/// output that is none of the file's own times is interpolated, where that is known to a tenth of the error.
std::vector<GivenCurve> given_curves(const Case& spec, std::span<const GivenRun> runs,
                                     const Trajectory& same_mesh, const Trajectory& converged);

}  // namespace plumb
