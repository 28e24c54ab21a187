#pragma once

#include <functional>
#include <string>

#include "engine/study/work_precision/journal.h"
#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// Called now and then with the part of a study that is under way ("references", "errors", "timing") and the
/// share of it that is done, 0 to 1. Never called twice at once, but from any thread.
using StudyProgress = std::function<void(const std::string& part, double share)>;

/// Makes the work-precision study of a case, or its quick form: references of every mesh; every curve, in
/// parallel over the processors; then the time of every run, one at a time. What the journal holds is not
/// done again.
///
/// A curve ends early where finer runs can show nothing: where a run was out of time; near the floor of its
/// mesh's reference; and, on other meshes than the case's own, after two runs whose time integration errs by
/// less than 2 % of the total error. Throws Interrupted if the user stops it.
WorkPrecision run_work_precision(const Case& spec, bool quick, StudyJournal& journal,
                                 const StudyProgress& progress = {});

/// Sets all that follows from runs, curves and the agreement of the references: certificates, observed
/// orders, fronts, the cheapest runs and common floors.
void evaluate(WorkPrecision& study);

}  // namespace plumb
