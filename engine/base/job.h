#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plumb {

/// The processes that mpirun or srun started together, numbered from 0, as one of them sees them. Their
/// messages are texts, and those from one to another come in their order.
class Job {
 public:
  struct Message {
    int from = 0;
    std::string text;
  };

  virtual ~Job() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Returns at once.
  virtual void send(int to, std::string_view text) = 0;
  /// The next message, if one comes within so many seconds. Waits without taking processor time.
  virtual std::optional<Message> receive(double seconds) = 0;
};

/// The job that this process belongs to; nullptr: none of several processes. Opened at the first call. Throws
/// UsageError where it belongs to one and the part of the program that speaks MPI is not there, as each of
/// its processes would do all of the work.
Job* job_of_process();

}  // namespace plumb
