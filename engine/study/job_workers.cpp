#include "engine/study/job_workers.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "engine/study/runner.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int units_ahead = 2;  // with a process, so that it need not wait for the next

// Orders of rank 0, by "do": "compute" with the `ids` of tasks, "end" of a phase, "take" of lines, "go" home.
// What others say, by "is": "free" for a unit, in a phase, "done" with a task, "failed".

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Tasks that one process computes one after another.
using Unit = std::vector<std::size_t>;

std::vector<Unit> units_of(const std::vector<Task>& tasks, Company company) {
  std::vector<Unit> units;
  if (company == Company::apart) {
    std::map<std::size_t, std::size_t> of_group;
    for (std::size_t k = 0; k < tasks.size(); ++k) {
      const auto [unit, is_new] = of_group.try_emplace(tasks[k].group, units.size());
      if (is_new) units.emplace_back();
      units[unit->second].push_back(k);
    }
    return units;
  }
  for (const std::size_t k : most_work_first(tasks)) units.push_back({k});
  return units;
}

std::vector<Task> tasks_of(const Unit& unit, const std::vector<Task>& tasks) {
  std::vector<Task> some;
  for (const std::size_t k : unit) some.push_back(tasks[k]);
  return some;
}

/// What rank 0 computes itself beside handing out.
class Beside {
 public:
  /// `next` gives a unit, or none where no more are left.
  Beside(const std::vector<Task>& tasks, std::function<std::optional<Unit>()> next)
      : thread_([this, &tasks, next = std::move(next)] {
          try {
            while (const std::optional<Unit> unit = next())
              for (const std::size_t k : *unit) {
                TaskEnd end{tasks[k].compute(), {}};
                const std::lock_guard lock(guard_);
                ends_.emplace_back(k, std::move(end));
              }
          } catch (...) {
            const std::lock_guard lock(guard_);
            fault_ = std::current_exception();
          }
        }) {}
  ~Beside() { thread_.join(); }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  /// The ends that came since it was last asked. Throws what a task threw.
  std::deque<std::pair<std::size_t, TaskEnd>> ends() {
    const std::lock_guard lock(guard_);
    if (fault_) std::rethrow_exception(fault_);
    return std::exchange(ends_, {});
  }

 private:
  std::mutex guard_;
  std::deque<std::pair<std::size_t, TaskEnd>> ends_;
  std::exception_ptr fault_;
  std::thread thread_;
};

}  // namespace

void JobWorkers::tell_all(const std::string& text) {
  for (int rank = 1; rank < job_.size(); ++rank) job_.send(rank, text);
}

void JobWorkers::compute(const std::vector<Task>& tasks, Company company, const Take& take) {
  ++phase_;
  if (serves()) return serve(tasks, company);
  if (company == Company::alone)
    LocalWorkers().compute(tasks, company, take);
  else
    hand_out(tasks, company, take);
  tell_all(text_of({{"do", "end"}, {"phase", phase_}}));
}

void JobWorkers::hand_out(const std::vector<Task>& tasks, Company company, const Take& take) {
  const std::vector<Unit> units = units_of(tasks, company);
  std::mutex guard;
  std::size_t given = 0, left = tasks.size();
  bool stopped = false;
  const auto next = [&]() -> std::optional<Unit> {
    const std::lock_guard lock(guard);
    if (stopped || given == units.size()) return {};
    return units[given++];
  };
  std::map<std::size_t, std::size_t> of_id;
  for (std::size_t k = 0; k < tasks.size(); ++k) of_id[tasks[k].id] = k;
  const auto hear = [&](const Job::Message& message) {
    const Json said = Json::parse(message.text);
    const std::string is = said.at("is");
    if (is == "failed")
      throw OutputError(
          fmt::format("process {} of the job failed: {}", message.from, said.at("why").get<std::string>()));
    if (is == "free") {
      machines_[message.from] = {said.at("host"), said.at("processor"), said.at("revision")};
      if (said.at("phase") != phase_) return;
      const std::optional<Unit> unit = next();
      if (!unit) return;
      Json ids = Json::array();
      for (const std::size_t k : *unit) ids.push_back(tasks[k].id);
      job_.send(message.from, text_of({{"do", "compute"}, {"ids", ids}}));
    } else {
      --left;
      take(of_id.at(said.at("id")), {said.at("line"), said.at("fault"), machines_.at(message.from)});
    }
  };
  std::optional<Beside> beside;
  if (company == Company::together) beside.emplace(tasks, next);
  try {
    while (left > 0) {
      stop_if_interrupted();
      constexpr double look_every = 0.005;  // s
      if (const auto message = job_.receive(look_every)) hear(*message);
      if (!beside) continue;
      for (const auto& [k, end] : beside->ends()) {
        --left;
        take(k, end);
      }
    }
  } catch (...) {
    const std::lock_guard lock(guard);
    stopped = true;
    throw;
  }
}

std::string JobWorkers::next_order() {
  for (;;) {
    stop_if_interrupted();
    constexpr double look_every = 0.1;  // s
    if (auto message = job_.receive(look_every)) return std::move(message->text);
  }
}

void JobWorkers::serve(const std::vector<Task>& tasks, Company company) {
  std::map<std::size_t, std::size_t> of_id;
  for (std::size_t k = 0; k < tasks.size(); ++k) of_id[tasks[k].id] = k;
  const auto say_free = [&] {
    const Machine& here = this_machine();
    job_.send(0, text_of({{"is", "free"},
                          {"phase", phase_},
                          {"host", here.host},
                          {"processor", here.processor},
                          {"revision", here.revision}}));
  };
  const auto say_done = [&](std::size_t id, const TaskEnd& end) {
    job_.send(0, text_of({{"is", "done"}, {"id", id}, {"line", end.line}, {"fault", end.fault}}));
  };
  for (int k = 0; k < units_ahead; ++k) say_free();
  for (;;) {
    const Json order = Json::parse(next_order());
    if (order.at("do") == "go") throw NotWhole();
    if (order.at("do") == "end") return;
    Unit unit;
    for (const Json& id : order.at("ids")) unit.push_back(of_id.at(id));
    const std::vector<Task> some = tasks_of(unit, tasks);
    if (company == Company::apart)
      LocalWorkers().compute(some, company,
                             [&](std::size_t k, const TaskEnd& end) { say_done(some[k].id, end); });
    else
      for (const Task& task : some) say_done(task.id, {task.compute(), {}});
    say_free();
  }
}

void JobWorkers::spread(std::vector<std::string>& lines) {
  if (!serves()) return tell_all(text_of({{"do", "take"}, {"lines", lines}}));
  const Json order = Json::parse(next_order());
  if (order.at("do") == "go") throw NotWhole();
  lines = order.at("lines").get<std::vector<std::string>>();
}

void end_job(Job& job) {
  for (int rank = 1; rank < job.size(); ++rank) job.send(rank, text_of({{"do", "go"}}));
}

void fail_in_job(Job& job, const std::string& why) {
  constexpr double patience = 10, look_every = 0.1;  // s
  job.send(0, text_of({{"is", "failed"}, {"why", why}}));
  for (double waited = 0; waited < patience && !is_interrupted(); waited += look_every)
    if (const auto message = job.receive(look_every))
      if (Json::parse(message->text).at("do") == "go") return;
}

}  // namespace plumb
