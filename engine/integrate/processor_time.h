#pragma once

#include <ctime>

namespace plumb {

/// Of this thread, s. Unlike time on the clock it does not depend on what else the machine does, so that
/// neither does the outcome of what has a time limit.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace plumb
