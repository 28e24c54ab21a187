#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>

namespace plumb {

/// What a confined process may use.
struct Confinement {
  std::uint64_t memory = 0;  ///< beyond what the process has when it starts, bytes
  int seconds = 0;           ///< of processor time for one answer; as a time of waiting five times as much
  std::uint64_t longest_answer = 0;  ///< bytes
};

/// A copy of this process that answers questions by code which is not trusted with what it reads. It may
/// compute and answer, no more: it opens no files, has no network, starts no processes and leaves no core
/// file. It ends with this object, or with the process that made it.
class ConfinedProcess {
 public:
  /// Gives the answer to a question; runs in the confined process. A std::runtime_error that it throws is
  /// thrown by `ask`.
  using Answer = std::function<std::string(const std::string& question)>;

  /// Throws std::runtime_error where no process can be started.
  ConfinedProcess(const Confinement& limits, Answer answer);
  ~ConfinedProcess();
  ConfinedProcess(const ConfinedProcess&) = delete;
  ConfinedProcess& operator=(const ConfinedProcess&) = delete;

  /// Throws std::runtime_error with the reason where there is no answer: "it is damaged or hostile (reading
  /// it ended by SIGSEGV)". Throws Interrupted.
  std::string ask(const std::string& question);

 private:
  [[noreturn]] void serve(const Answer& answer, int socket) const;
  void read(void* to, std::size_t count, std::int64_t until);
  [[noreturn]] void give_up(const std::string& why);
  std::string ending();

  Confinement limits_;
  pid_t pid_ = -1;
  int socket_ = -1;
};

}  // namespace plumb
