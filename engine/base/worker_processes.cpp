#include "engine/base/worker_processes.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <deque>
#include <list>
#include <system_error>
#include <thread>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"

namespace plumb {
namespace {

using Clock = std::chrono::steady_clock;

struct Part {
  std::size_t job;
  std::size_t first;  // line
};

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    // Whoever reads is gone, and with it the use of the rest.
    if (written < 0) ::_exit(1);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// A process at work on a part of the jobs. Ends it where it still runs when this goes out of scope.
class Worker {
 public:
  Worker(const WorkerJobs& jobs, const Part& part) : part_(part) {
    int ends[2];
    if (::pipe(ends) != 0) fail("a pipe to a process");
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ < 0) {
      const int error = errno;
      ::close(ends[0]);
      ::close(ends[1]);
      errno = error;
      fail("a process");
    }
    if (pid_ == 0) {
      ::close(ends[0]);
      for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
      // Whoever waits for this process may be killed.
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent) ::_exit(1);
      int status = 1;
      try {
        jobs.work(part.job, part.first, [&](const std::string& line) { write_all(ends[1], line + "\n"); });
        status = 0;
      } catch (...) {
      }
      // Nothing of the process that it was split from may be flushed or destroyed twice.
      ::_exit(status);
    }
    ::close(ends[1]);
    file_ = ends[0];
    heard();
  }
  ~Worker() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      wait();
    }
    ::close(file_);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  int file() const { return file_; }
  std::size_t job() const { return part_.job; }
  double silence() const { return std::chrono::duration<double>(Clock::now() - heard_).count(); }

  /// Reads what there is; false at its end. Whole lines go to `lines`.
  bool read(std::vector<JobLine>& lines) {
    char bytes[65536];
    const ssize_t count = ::read(file_, bytes, sizeof bytes);
    if (count < 0) return errno == EINTR || errno == EAGAIN;
    if (count == 0) return false;
    rest_.append(bytes, static_cast<std::size_t>(count));
    for (std::size_t end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
      lines.push_back({rest_.substr(0, end), ""});
      rest_.erase(0, end + 1);
      heard();
    }
    return true;
  }

  void end() { ::kill(pid_, SIGKILL); }

  /// How the process ended: empty if as it should.
  std::string wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    if (WIFSIGNALED(status)) return fmt::format("crashed (signal {})", WTERMSIG(status));
    if (WEXITSTATUS(status) != 0) return fmt::format("ended with status {}", WEXITSTATUS(status));
    return {};
  }

 private:
  void heard() { heard_ = Clock::now(); }

  Part part_;
  pid_t pid_ = -1;
  int file_ = -1;
  std::string rest_;
  Clock::time_point heard_;
};

}  // namespace

void run_in_processes(const WorkerJobs& jobs) {
  constexpr int poll_every = 50;  // ms
  std::vector<std::vector<JobLine>> lines(jobs.lines.size());
  std::vector<std::size_t> given(jobs.lines.size());
  const auto give = [&](std::size_t job) {
    for (std::size_t& k = given[job]; k < lines[job].size(); ++k) {
      jobs.take(job, k, lines[job][k]);
      lines[job][k].text.clear();
    }
  };
  std::deque<Part> waiting;
  for (std::size_t job = 0; job < jobs.lines.size(); ++job)
    if (jobs.lines[job] > 0) waiting.push_back({job, 0});
  const std::size_t at_once = std::max(1U, std::thread::hardware_concurrency());
  std::list<Worker> workers;
  const auto finished = [&](Worker& worker, bool hung) {
    std::vector<JobLine>& of_job = lines[worker.job()];
    if (hung) worker.end();
    std::string fault = worker.wait();
    if (of_job.size() >= jobs.lines[worker.job()]) return;
    if (hung) fault = fmt::format("hung: nothing for {:g} s", jobs.longest_silence);
    if (fault.empty()) fault = "ended early";
    of_job.push_back({"", fault});
    give(worker.job());
    if (of_job.size() < jobs.lines[worker.job()]) waiting.push_front({worker.job(), of_job.size()});
  };
  while (!waiting.empty() || !workers.empty()) {
    stop_if_interrupted();
    while (!waiting.empty() && workers.size() < at_once) {
      try {
        workers.emplace_back(jobs, waiting.front());
      } catch (const std::system_error& error) {
        if (!workers.empty()) break;  // fewer at once will do
        throw OutputError(fmt::format("no process can be started, {}: {}", error.code().message(),
                                      "a limit of the machine on processes, files or memory is reached"));
      }
      waiting.pop_front();
    }
    std::vector<pollfd> files;
    for (const Worker& worker : workers) files.push_back({worker.file(), POLLIN, 0});
    if (::poll(files.data(), files.size(), poll_every) < 0 && errno != EINTR) fail("waiting for processes");
    std::size_t k = 0;
    for (auto worker = workers.begin(); worker != workers.end(); ++k) {
      const bool ended = files[k].revents != 0 && !worker->read(lines[worker->job()]);
      const bool hung = !ended && worker->silence() > jobs.longest_silence;
      give(worker->job());
      if (ended || hung) {
        finished(*worker, hung);
        worker = workers.erase(worker);
      } else {
        ++worker;
      }
    }
  }
}

}  // namespace plumb
