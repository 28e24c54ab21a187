#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <list>
#include <thread>
#include <vector>

#include "engine/base/job.h"

extern char** environ;

namespace plumb {
namespace {

class MpiJob : public Job {
 public:
  MpiJob() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    forget_variables();
  }

  ~MpiJob() override {
    for (Sending& sending : sent_) MPI_Request_free(&sending.request);
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void send(int to, std::string_view text) override {
    Sending& sending = sent_.emplace_back();
    sending.text = text;
    MPI_Isend(sending.text.data(), static_cast<int>(sending.text.size()), MPI_CHAR, to, 0, MPI_COMM_WORLD,
              &sending.request);
    clear_sent();
  }

  std::optional<Message> receive(double seconds) override {
    using Clock = std::chrono::steady_clock;
    const auto until = Clock::now() + std::chrono::duration<double>(seconds);
    std::chrono::microseconds pause(20);
    constexpr std::chrono::microseconds longest(1000);
    for (;;) {
      int there = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
      clear_sent();
      if (there != 0) {
        int size = 0;
        MPI_Get_count(&status, MPI_CHAR, &size);
        Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
        MPI_Recv(message.text.data(), size, MPI_CHAR, status.MPI_SOURCE, 0, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        return message;
      }
      if (Clock::now() >= until) return {};
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, longest);
    }
  }

 private:
  struct Sending {
    std::string text;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void clear_sent() {
    sent_.remove_if([](Sending& sending) {
      int done = 0;
      MPI_Test(&sending.request, &done, MPI_STATUS_IGNORE);
      return done != 0;
    });
  }

  /// So that a process that this one starts does not take itself for one of the job.
  static void forget_variables() {
    std::vector<std::string> names;
    for (char** entry = environ; *entry != nullptr; ++entry) {
      const std::string_view text = *entry;
      if (text.starts_with("OMPI_") || text.starts_with("PMIX_"))
        names.emplace_back(text.substr(0, text.find('=')));
    }
    for (const std::string& name : names) ::unsetenv(name.c_str());
  }

  int rank_ = 0;
  int size_ = 1;
  std::list<Sending> sent_;
};

}  // namespace
}  // namespace plumb

/// Found by its name when a process belongs to a job.
extern "C" plumb::Job* plumb_open_job() {
  return new plumb::MpiJob();
}
