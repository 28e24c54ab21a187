#include "engine/interrupt.h"

#include <atomic>
#include <csignal>

#include "engine/errors.h"

namespace plumb {
namespace {

std::atomic<bool> stop_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void request_stop(int signal) {
  stop_requested = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // Whoever started the program may have asked for a signal to be ignored (nohup does).
    if (std::signal(signal, request_stop) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  // A closed pipe and a file that may not grow are errors of a write, told by it.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void stop_if_interrupted() {
  if (stop_requested.load(std::memory_order_relaxed)) throw Interrupted();
}

}  // namespace plumb
