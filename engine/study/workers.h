#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "engine/study/study_identity.h"

namespace plumb {

/// How points that are asked for together are computed.
enum class Company {
  together,  ///< many at once, in one process
  apart,     ///< in processes of their own, so that one that crashes or hangs takes no other with it
  alone,     ///< one after another with nothing beside them, to be timed
};

/// A piece of work as those see it who compute: it gives one line of text.
struct Task {
  std::function<std::string()> compute;
  double work = 1;        ///< predicted, in any unit; the greatest begin first
  std::size_t group = 0;  ///< apart: tasks of one group follow one another in one process, in their order
  double patience = 60;   ///< apart: a process that gives nothing for this long hangs, s
  std::string key = {};   ///< of the point, with its part
  std::size_t id = 0;     ///< the same in all processes that plan the same work
};

/// What became of a task: its line, or why there is none ("crashed (signal 11)"), which only those apart can
/// have.
struct TaskEnd {
  std::string line;
  std::string fault;
  Machine on = this_machine();
};

/// The order in which tasks begin: those of most work first.
std::vector<std::size_t> most_work_first(const std::vector<Task>& tasks);

/// Who computes. An implementation may leave tasks out that others compute; it hands over each end as it
/// comes, from any thread, never two at once. It ends with the first exception of a task, and with
/// Interrupted if the user stops it.
class Workers {
 public:
  using Take = std::function<void(std::size_t task, const TaskEnd& end)>;

  virtual ~Workers() = default;
  virtual void compute(const std::vector<Task>& tasks, Company company, const Take& take) = 0;

  /// Whether several processes plan the same work and compute it together.
  virtual bool is_job() const { return false; }
  /// Whether this one of them only computes for that which has the journal: it is given all tasks, and no
  /// ends.
  virtual bool serves() const { return false; }
  /// Gives the lines that the process with the journal has to all that serve it.
  virtual void spread(std::vector<std::string>& lines) { static_cast<void>(lines); }
};

/// The threads and processes of this machine.
class LocalWorkers : public Workers {
 public:
  void compute(const std::vector<Task>& tasks, Company company, const Take& take) override;
};

}  // namespace plumb
