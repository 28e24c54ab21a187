#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace plumb {

/// This program once more, in a process of its own, with other arguments.
struct OwnRun {
  std::vector<std::string> arguments;  ///< without the program's name
  double memory = 0;                   ///< that it will take, bytes
  bool alone = false;                  ///< nothing may run beside it
};

/// How one ended.
struct OwnRunEnd {
  int status = -1;     ///< exit status; -1: see `fault`
  std::string fault;   ///< "crashed (signal 11)", "could not be started: …"; empty: none
  std::string errors;  ///< what it wrote to standard error, of a long text the end
  double seconds = 0;  ///< by the clock
};

/// How many run side by side where none is to run alone: as many as there are processors.
std::size_t side_by_side();

/// Runs this program many times over, as many at once as there are processors and as `memory` bytes have room
/// for; at least one. They begin in their order, those that are to be alone after all others, one after
/// another. `take` is told of each as it ends. Standard output of theirs goes nowhere. One that crashes takes
/// no other with it. Throws Interrupted if the user stops it: `stopping` is called, those under way are asked
/// to stop as well, and are waited for. None outlives the call, nor this process, unless it is made to ignore
/// SIGHUP. Throws OutputError where no process can be started.
void run_side_by_side(const std::vector<OwnRun>& runs, double memory,
                      const std::function<void(std::size_t run, const OwnRunEnd& end)>& take,
                      const std::function<void()>& stopping);

}  // namespace plumb
