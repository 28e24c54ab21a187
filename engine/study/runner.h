#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/codec.h"
#include "engine/study/journal.h"

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
};

/// What became of a task: its line, or why there is none ("crashed (signal 11)"), which only those apart can
/// have.
struct TaskEnd {
  std::string line;
  std::string fault;
};

/// Who computes. An implementation may leave tasks out that others compute; it hands over each end as it
/// comes, from any thread, never two at once. It ends with the first exception of a task, and with
/// Interrupted if the user stops it.
class Workers {
 public:
  using Take = std::function<void(std::size_t task, const TaskEnd& end)>;

  virtual ~Workers() = default;
  virtual void compute(const std::vector<Task>& tasks, Company company, const Take& take) = 0;
};

/// The threads and processes of this machine.
class LocalWorkers : public Workers {
 public:
  void compute(const std::vector<Task>& tasks, Company company, const Take& take) override;
};

/// Called now and then with the part of a study that is under way ("references", "errors", "timing") and the
/// share of it that is done, 0 to 1. Never called twice at once, but from any thread.
using StudyProgress = std::function<void(const std::string& part, double share)>;

/// A piece of a study that can be computed by itself.
template <class Result>
struct StudyPoint {
  std::string key;  ///< all that its result depends on, beside what the journal's identity has
  std::function<Result()> compute;
  double work = 1;        ///< as of a Task
  std::size_t group = 0;  ///< as of a Task
  double patience = 60;   ///< as of a Task
};

/// Runs the points of a study. What the journal holds is not computed again; each other result is written
/// down as soon as it is there, and read back from what was written, so that a study that was interrupted
/// gives what one gives that was not.
class Runner {
 public:
  explicit Runner(Journal& journal, StudyProgress progress = {});
  Runner(Journal& journal, StudyProgress progress, Workers& workers);

  /// The results of points, in their order. `lost` makes the result of one whose process left none, and is
  /// needed for those apart.
  template <class Result>
  std::vector<Result> run(const std::string& part, const std::vector<StudyPoint<Result>>& points,
                          Company company = Company::together,
                          const std::function<Result(std::size_t, const std::string& fault)>& lost = {}) {
    std::vector<Result> results(points.size());
    std::vector<Task> tasks;
    std::vector<std::size_t> of_task;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (find(part, points[k], results[k])) continue;
      tasks.push_back({[&point = points[k]] { return text_of(encode(point.compute())); }, points[k].work,
                       points[k].group, points[k].patience});
      of_task.push_back(k);
    }
    compute(part, tasks, points.size(), company, [&](std::size_t task, const TaskEnd& end) {
      const std::size_t k = of_task[task];
      const std::string line = end.fault.empty() ? end.line : text_of(encode(lost(k, end.fault)));
      journal_.add(full_key(part, points[k].key), line);
      results[k] = read<Result>(line);
    });
    return results;
  }

  /// The result of one point, found or computed by the caller: a part of another point, which is worth
  /// keeping where that one is interrupted. What the journal has is taken if it is `good`.
  template <class Result>
  Result once(const std::string& part, const StudyPoint<Result>& point,
              const std::function<bool(const Result&)>& good = {}) {
    Result result{};
    if (find(part, point, result) && (!good || good(result))) return result;
    const std::string line = text_of(encode(point.compute()));
    journal_.add(full_key(part, point.key), line);
    return read<Result>(line);
  }

  void say(const std::string& part, double share);

 private:
  static std::string full_key(const std::string& part, const std::string& key) { return part + ": " + key; }
  static std::string text_of(const nlohmann::ordered_json& json);
  void compute(const std::string& part, const std::vector<Task>& tasks, std::size_t points, Company company,
               const Workers::Take& take);

  template <class Result>
  static Result read(const std::string& line) {
    return decoded<Result>(nlohmann::ordered_json::parse(line));
  }

  template <class Result>
  bool find(const std::string& part, const StudyPoint<Result>& point, Result& result) const {
    const auto line = journal_.find(full_key(part, point.key));
    if (!line) return false;
    try {
      result = read<Result>(*line);
    } catch (const std::exception&) {  // of another version
      return false;
    }
    return true;
  }

  Journal& journal_;
  StudyProgress progress_;
  LocalWorkers own_;
  Workers* workers_;
  std::mutex saying_;
};

}  // namespace plumb
