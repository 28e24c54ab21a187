#pragma once

#include <functional>
#include <vector>

#include "engine/base/job.h"
#include "engine/base/side_by_side.h"

namespace plumb {

/// As run_side_by_side(), by the processes of a job, each of which runs one at a time: rank 0, which calls
/// this, hands them out, and runs itself those that are to be alone when all others have ended.
void run_in_job(Job& job, const std::vector<OwnRun>& runs,
                const std::function<void(std::size_t run, const OwnRunEnd& end)>& take,
                const std::function<void()>& stopping);

/// What the others do until rank 0 ends the job. Throws Interrupted if the user stops it.
void serve_own_runs(Job& job);

}  // namespace plumb
