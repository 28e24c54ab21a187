#include "engine/base/side_by_side.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <list>
#include <system_error>
#include <thread>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"

namespace plumb {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int look_every = 20;  // ms
constexpr int not_started = 127;

/// One under way.
class OwnProcess {
 public:
  /// Throws std::system_error where no process can be started.
  OwnProcess(std::size_t run, const OwnRun& what) : run_(run), memory_(what.memory), alone_(what.alone) {
    std::vector<std::string> words{"plumb"};
    words.insert(words.end(), what.arguments.begin(), what.arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) {
      // A stop that a terminal asks of all of them is passed on once, as a second one would kill.
      ::setpgid(0, 0);
      ::prctl(PR_SET_PDEATHSIG, SIGHUP);
      if (::getppid() != parent) ::_exit(not_started);
      const int nowhere = ::open("/dev/null", O_RDWR);
      ::dup2(nowhere, STDIN_FILENO);
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(ends[1], STDERR_FILENO);
      if (nowhere > STDERR_FILENO) ::close(nowhere);
      ::execv("/proc/self/exe", pointers.data());
      ::_exit(not_started);
    }
    const int error = errno;
    ::close(ends[1]);
    file_ = ends[0];
    if (pid_ < 0) {
      ::close(file_);
      throw std::system_error(error, std::generic_category());
    }
    ::fcntl(file_, F_SETFL, O_NONBLOCK);
  }
  ~OwnProcess() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
    ::close(file_);
  }
  OwnProcess(const OwnProcess&) = delete;
  OwnProcess& operator=(const OwnProcess&) = delete;

  std::size_t run() const { return run_; }
  double memory() const { return memory_; }
  bool alone() const { return alone_; }
  /// To wait at; -1 once it closed its end.
  int file() const { return open_ ? file_ : -1; }

  void stop() const {
    if (pid_ > 0) ::kill(pid_, SIGTERM);
  }

  /// Takes in what it says.
  void listen() {
    constexpr std::size_t longest = 64 * 1024;
    char bytes[4096];
    for (;;) {
      const ssize_t count = ::read(file_, bytes, sizeof bytes);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) {
        open_ = count < 0;
        return;
      }
      end_.errors.append(bytes, static_cast<std::size_t>(count));
      if (end_.errors.size() > longest) end_.errors.erase(0, end_.errors.size() - longest);
    }
  }

  bool has_ended() {
    if (pid_ <= 0) return true;
    int status = 0;
    const pid_t ended = ::waitpid(pid_, &status, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
    pid_ = -1;
    listen();
    if (ended < 0)
      end_.fault = "ended unseen";
    else if (WIFSIGNALED(status))
      end_.fault = fmt::format("crashed (signal {})", WTERMSIG(status));
    else if (WEXITSTATUS(status) == not_started)
      end_.fault = "could not be started";
    else
      end_.status = WEXITSTATUS(status);
    end_.seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    return true;
  }

  const OwnRunEnd& end() const { return end_; }

 private:
  std::size_t run_;
  double memory_;
  bool alone_;
  pid_t pid_ = -1;
  int file_ = -1;
  bool open_ = true;
  OwnRunEnd end_;
  Clock::time_point began_ = Clock::now();
};

using Processes = std::list<OwnProcess>;

void wait_for_any(Processes& processes) {
  std::vector<pollfd> files;
  for (const OwnProcess& process : processes) files.push_back({process.file(), POLLIN, 0});
  ::poll(files.data(), files.size(), look_every);
  for (OwnProcess& process : processes) process.listen();
}

/// Asks all to stop and waits until they have cleared what they had begun.
void stop_all(Processes& processes) {
  for (const OwnProcess& process : processes) process.stop();
  constexpr std::chrono::seconds patience(3);
  for (const Clock::time_point until = Clock::now() + patience; Clock::now() < until && !processes.empty();) {
    wait_for_any(processes);
    processes.remove_if([](OwnProcess& process) { return process.has_ended(); });
  }
}

}  // namespace

std::size_t side_by_side() {
  return std::max(1U, std::thread::hardware_concurrency());
}

void run_side_by_side(const std::vector<OwnRun>& runs, double memory,
                      const std::function<void(std::size_t run, const OwnRunEnd& end)>& take,
                      const std::function<void()>& stopping) {
  std::vector<std::size_t> waiting;
  for (const bool alone : {false, true})
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (runs[k].alone == alone) waiting.push_back(k);
  Processes processes;
  const auto has_room = [&](const OwnRun& run) {
    if (processes.empty()) return true;
    double taken = run.memory;
    for (const OwnProcess& process : processes) taken += process.memory();
    return !run.alone && !processes.front().alone() && processes.size() < side_by_side() && taken <= memory;
  };
  auto next = waiting.begin();
  try {
    while (next != waiting.end() || !processes.empty()) {
      stop_if_interrupted();
      while (next != waiting.end() && has_room(runs[*next])) {
        try {
          processes.emplace_back(*next, runs[*next]);
        } catch (const std::system_error& error) {
          if (!processes.empty()) break;  // fewer at once will do
          throw OutputError(fmt::format("no process can be started, {}: {}", error.code().message(),
                                        "a limit of the machine on processes, files or memory is reached"));
        }
        ++next;
      }
      wait_for_any(processes);
      for (auto process = processes.begin(); process != processes.end();) {
        if (!process->has_ended()) {
          ++process;
          continue;
        }
        const std::size_t run = process->run();
        const OwnRunEnd end = process->end();
        process = processes.erase(process);
        take(run, end);
      }
    }
  } catch (...) {
    const Undivided waits;
    if (is_interrupted()) stopping();
    stop_all(processes);
    throw;
  }
}

}  // namespace plumb
