#include "engine/base/interrupt.h"

#include <pthread.h>
#include <semaphore.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <map>
#include <mutex>
#include <string_view>

#include "engine/base/errors.h"

namespace plumb {
namespace {

constexpr int interrupted_status = 130;

std::atomic<bool> stop_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

sem_t stop_asked_for;

void request_stop(int signal) {
  const int error = errno;
  stop_requested = true;
  std::signal(signal, SIG_DFL);
  ::sem_post(&stop_asked_for);
  errno = error;
}

/// What outlives every object of the program, as the watch may end it at any time.
struct Registry {
  std::recursive_mutex undivided;
  std::mutex guard;
  std::map<std::string, void (*)(const std::string&)> unfinished;
};

Registry& registry() {
  static auto* const kept = new Registry;
  return *kept;
}

void wait_a_moment(long milliseconds) {
  timespec rest{0, milliseconds * 1'000'000};
  while (::nanosleep(&rest, &rest) != 0 && errno == EINTR) {
  }
}

void remove_unfinished() {
  const std::lock_guard lock(registry().guard);
  for (const auto& [path, remove] : registry().unfinished) remove(path);
}

/// Ends a program that was asked to stop and did not.
void* watch(void*) {
  constexpr long patience = 400;
  while (::sem_wait(&stop_asked_for) != 0) {
  }
  wait_a_moment(patience);
  const std::lock_guard lock(registry().undivided);
  remove_unfinished();
  constexpr std::string_view line = "plumb: interrupted\n";
  if (may_say_interrupted() && ::write(STDERR_FILENO, line.data(), line.size()) < 0) {
    // Nobody is there to read it.
  }
  ::_exit(interrupted_status);
}

/// Without a thread to be had, work has to stop by itself.
void start_watch() {
  constexpr std::size_t stack = 256 * 1024;
  registry();
  ::sem_init(&stop_asked_for, 0, 0);
  pthread_attr_t attributes;
  if (::pthread_attr_init(&attributes) != 0) return;
  ::pthread_attr_setstacksize(&attributes, stack);
  ::pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_t thread;
  ::pthread_create(&thread, &attributes, watch, nullptr);
  ::pthread_attr_destroy(&attributes);
}

}  // namespace

void catch_interrupts() {
  static std::once_flag watching;
  std::call_once(watching, start_watch);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // Whoever started the program may have asked for a signal to be ignored (nohup does).
    if (std::signal(signal, request_stop) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  // A closed pipe and a file that may not grow are errors of a write, told by it.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void stop_if_interrupted() {
  if (is_interrupted()) throw Interrupted();
}

bool may_say_interrupted() {
  static std::atomic<bool> said = false;
  return !said.exchange(true);
}

bool is_interrupted() {
  return stop_requested.load(std::memory_order_relaxed);
}

void begin_unfinished(const std::string& path, void (*remove)(const std::string& path)) {
  const std::lock_guard lock(registry().guard);
  registry().unfinished.emplace(path, remove);
}

void end_unfinished(const std::string& path) {
  const std::lock_guard lock(registry().guard);
  registry().unfinished.erase(path);
}

Undivided::Undivided() {
  registry().undivided.lock();
}

Undivided::~Undivided() {
  registry().undivided.unlock();
}

}  // namespace plumb
