#include "engine/base/confined_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "engine/base/interrupt.h"
#include "engine/base/message.h"

namespace plumb {
namespace {

constexpr std::size_t bytes_a_read = 1 << 20;
/// A machine that others use as well gives a process a part of its time.
constexpr int waiting_factor = 5;

/// False where nobody listens any more.
bool send_all(int file, const void* bytes, std::size_t count) {
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = ::send(file, at, count, MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

bool read_all(int file, void* bytes, std::size_t count) {
  char* at = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = ::read(file, at, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

std::int64_t milliseconds() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void limit(int what, rlim_t most) {
  rlimit now{};
  ::getrlimit(static_cast<__rlimit_resource>(what), &now);
  now.rlim_max = std::min(now.rlim_max, most);
  now.rlim_cur = std::min(now.rlim_cur, now.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource>(what), &now);
}

/// Of this process, bytes.
std::uint64_t memory_now() {
  long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(file, "%ld", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Address space, as it may be limited, means nothing under AddressSanitizer, which reserves terabytes.
constexpr bool limits_memory =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
    false;
#else
    true;
#endif
#else
    true;
#endif

/// Refuses all but what computing and answering take. Where the kernel has no such filter, the limits are
/// what there is: without a file to be had there are no sockets either.
void filter_calls() {
  const scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (filter == nullptr) return;
  for (const char* name :
       {"read",           "sendto", "mmap",          "munmap",       "mremap",       "mprotect",
        "madvise",        "brk",    "exit",          "exit_group",   "rt_sigreturn", "rt_sigaction",
        "rt_sigprocmask", "futex",  "clock_gettime", "gettimeofday", "time",         "getrandom",
        "getpid",         "gettid", "sched_yield",   "getrusage",    "setrlimit",    "prlimit64",
        "sigaltstack"}) {
    const int call = ::seccomp_syscall_resolve_name(name);
    if (call != __NR_SCMP_ERROR) ::seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0);
  }
  ::seccomp_load(filter);
  ::seccomp_release(filter);
}

void confine(int seconds, pid_t parent) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU})
    std::signal(signal, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  ::prctl(PR_SET_DUMPABLE, 0);
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  // Of all answers together.
  limit(RLIMIT_CPU, static_cast<rlim_t>(4 * seconds));
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NOFILE, 0);
  limit(RLIMIT_NPROC, 0);
  filter_calls();
}

/// The processor time that is left for the next answer.
void allow_seconds(int seconds) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  rlimit now{};
  ::getrlimit(RLIMIT_CPU, &now);
  const auto end = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + seconds + 1);
  now.rlim_cur = std::min(now.rlim_max, end);
  ::setrlimit(RLIMIT_CPU, &now);
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", signal);
}

void close_file(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

}  // namespace

ConfinedProcess::ConfinedProcess(const Confinement& limits, Answer answer) : limits_(limits) {
  int ends[2] = {-1, -1};
  const pid_t parent = ::getpid();
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0) pid_ = ::fork();
  if (pid_ == 0) {
    // What the parent has open is none of its business, nor may it say anything but answers.
    if (::dup2(ends[1], 0) != 0 || ::close_range(1, ~0U, 0) != 0) ::_exit(1);
    // Memory first: to know how much there is takes a file.
    if (limits_memory) limit(RLIMIT_AS, memory_now() + limits_.memory);
    confine(limits_.seconds, parent);
    serve(answer, 0);
  }
  const int error = errno;
  close_file(ends[1]);
  socket_ = ends[0];
  if (pid_ > 0) return;
  close_file(socket_);
  throw std::runtime_error(
      fmt::format("there is no process to be had to read it in: {}", std::strerror(error)));
}

ConfinedProcess::~ConfinedProcess() {
  close_file(socket_);
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  ending();
}

void ConfinedProcess::serve(const Answer& answer, int socket) const {
  // Nothing of the process that this one was split from may be flushed or destroyed twice.
  for (;;) {
    std::uint64_t length = 0;
    if (!read_all(socket, &length, sizeof length)) ::_exit(0);
    std::string text;
    unsigned char good = 0;
    try {
      std::string question(length, '\0');
      if (!read_all(socket, question.data(), length)) ::_exit(0);
      allow_seconds(limits_.seconds);
      text = answer(question);
      good = 1;
    } catch (const std::bad_alloc&) {
      text = "it asks for more memory than it may have";
    } catch (const std::length_error&) {
      text = "it asks for more memory than it may have";
    } catch (const std::exception& error) {
      text = reason(error);
    }
    length = text.size();
    if (!send_all(socket, &good, 1) || !send_all(socket, &length, sizeof length) ||
        !send_all(socket, text.data(), text.size()))
      ::_exit(1);
  }
}

std::string ConfinedProcess::ask(const std::string& question) {
  if (pid_ <= 0) throw std::runtime_error("it is damaged or hostile");
  const std::uint64_t asked = question.size();
  if (!send_all(socket_, &asked, sizeof asked) || !send_all(socket_, question.data(), question.size()))
    give_up("");
  const std::int64_t until = milliseconds() + 1000LL * waiting_factor * limits_.seconds;
  unsigned char good = 0;
  std::uint64_t length = 0;
  read(&good, 1, until);
  read(&length, sizeof length, until);
  // Memory is taken for what has come, not for what is said to come.
  if (length > limits_.longest_answer) give_up("what is in it is longer than it can be");
  std::string text;
  for (std::size_t from = 0; from < length; from = text.size()) {
    text.resize(from + std::min<std::size_t>(bytes_a_read, length - from));
    read(text.data() + from, text.size() - from, until);
  }
  if (good != 1) throw std::runtime_error(one_line(text));
  return text;
}

void ConfinedProcess::read(void* to, std::size_t count, std::int64_t until) {
  constexpr int look_every = 50;  // ms
  char* at = static_cast<char*>(to);
  while (count > 0) {
    stop_if_interrupted();
    if (milliseconds() > until)
      give_up(fmt::format("reading it did not end within {} s", waiting_factor * limits_.seconds));
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, look_every) <= 0) continue;
    const ssize_t got = ::read(socket_, at, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) give_up("");
    at += got;
    count -= static_cast<std::size_t>(got);
  }
}

void ConfinedProcess::give_up(const std::string& why) {
  if (!why.empty()) ::kill(pid_, SIGKILL);
  const std::string how = ending();
  throw std::runtime_error(fmt::format("it is damaged or hostile ({})", why.empty() ? how : why));
}

std::string ConfinedProcess::ending() {
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return fmt::format("reading it took more than {} s of computing", limits_.seconds);
  if (WIFSIGNALED(status)) return fmt::format("reading it ended by {}", signal_name(WTERMSIG(status)));
  return "reading it ended early";
}

}  // namespace plumb
