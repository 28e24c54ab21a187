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
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

void stop_if_interrupted() {
  if (stop_requested.load(std::memory_order_relaxed)) throw Interrupted();
}

}  // namespace plumb
