#pragma once

#include <functional>

#include "engine/study/reference/classify_outcome.h"
#include "engine/study/runner.h"
#include "engine/study/sweep/sweep.h"

namespace plumb {

/// The sweep of a case: what its table says, or the defaults where it has none.
SweepSpec sweep_of(const Case& spec);

/// What judges the runs of a sweep: classify_outcome(), or something else to try whether the sweep would
/// notice.
using OutcomeClassifier = std::function<Judgement(const Trajectory& run, const Trajectory& reference,
                                                  double tolerance, double horizon)>;

/// Makes random cases near the one of the file and runs each, in processes of their own, so that one that
/// crashes or hangs is told rather than the end of all. A run that completes is judged by the Nyström pair of
/// order 8 on its own mesh, and held against the Gauss method of order 6; it is judged up to the time to
/// which these two agree to a tenth of the tolerance. Throws InputError where the file's case cannot be
/// varied, Interrupted if the user stops it.
Sweep run_sweep(const LoadedCase& loaded, Runner& runner,
                const OutcomeClassifier& judged_by = classify_outcome);

/// Case k of a sweep alone, judged in the same way in this process.
SweepRun run_of_sweep(const LoadedCase& loaded, const SweepSpec& spec, long number);

}  // namespace plumb
