#pragma once

#include <vector>

#include "engine/study/work_precision/pareto.h"
#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// For each power of ten below `ceiling` (m) that a run stays under, the run that does so with the least
/// work: from the greatest down to the last one that is reached and not below `floor`. `labels` names the
/// runs' curves.
std::vector<CheapestRun> cheapest_runs(const WorkPrecision& study, const std::vector<std::string>& labels,
                                       const std::vector<WorkError>& points, double floor, double ceiling);

/// "0.41 ms", "1.2 s": seconds for people.
std::string duration_in_words(double seconds);

}  // namespace plumb
