#pragma once

#include <span>

#include "engine/case/given_run.h"
#include "engine/study/runner.h"
#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// Makes the work-precision study of a case, or its quick form: references of every mesh; every curve, in
/// parallel over the processors; then the time of every run, one at a time.
///
/// A curve ends early where finer runs can show nothing: where a run was out of time; near the floor of its
/// mesh's reference; and, on other meshes than the case's own, after two runs whose time integration errs by
/// less than 2 % of the total error. `given` are the external runs of the case; those with a time get a curve
/// of their own. Throws Interrupted if the user stops it.
WorkPrecision run_work_precision(const Case& spec, bool quick, Runner& runner,
                                 std::span<const GivenRun> given = {});

/// Sets all that follows from runs, curves and the agreement of the references: certificates, observed
/// orders, fronts, the cheapest runs and common floors.
void evaluate(WorkPrecision& study);

}  // namespace plumb
