#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace plumb {

/// Takes a line of a job's result; the line itself has no line break.
using TakeLine = std::function<void(const std::string&)>;

/// What a line of a job became: its text, or why there is none.
struct JobLine {
  std::string text;
  std::string fault;  ///< "crashed (signal 11)", "hung: nothing for 30 s", "ended with status 1"; empty: none
};

/// Does jobs in processes of their own, as many at once as there are processors, so that one that crashes or
/// hangs takes no other with it.
struct WorkerJobs {
  std::vector<std::size_t> lines;  ///< how many lines each job gives
  /// Gives the lines of a job from the `first` one on, in order. Runs in the job's own process.
  std::function<void(std::size_t job, std::size_t first, const TakeLine& take)> work;
  double longest_silence = 0;  ///< a job that gives no line for this long hangs and is ended, s
  /// Takes each line as it comes, those of a job in their order.
  std::function<void(std::size_t job, std::size_t line, const JobLine& what)> take;
};

/// Does the jobs. Where a process crashes, hangs or ends early, that line has the fault and another process
/// goes on with the next. Throws Interrupted if the user stops it, and OutputError where not
/// even one process can be started; no process outlives the call. To be called where no other thread runs.
void run_in_processes(const WorkerJobs& jobs);

}  // namespace plumb
