#include "engine/study/workers.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

#include "engine/base/parallel.h"
#include "engine/base/worker_processes.h"

namespace plumb {
namespace {

void compute_beside_one_another(const std::vector<Task>& tasks, const Workers::Take& take) {
  const std::vector<std::size_t> order = most_work_first(tasks);
  std::mutex taking;
  for_each_in_parallel(tasks.size(), [&](std::size_t k) {
    const TaskEnd end{tasks[order[k]].compute(), {}};
    const std::lock_guard lock(taking);
    take(order[k], end);
  });
}

void compute_apart(const std::vector<Task>& tasks, const Workers::Take& take) {
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < tasks.size(); ++k) groups[tasks[k].group].push_back(k);
  std::vector<std::vector<std::size_t>> jobs_of;
  WorkerJobs jobs;
  for (auto& [group, members] : groups) {
    jobs.lines.push_back(members.size());
    jobs_of.push_back(std::move(members));
  }
  for (const Task& task : tasks) jobs.longest_silence = std::max(jobs.longest_silence, task.patience);
  jobs.work = [&](std::size_t job, std::size_t first, const TakeLine& line) {
    for (std::size_t k = first; k < jobs_of[job].size(); ++k) line(tasks[jobs_of[job][k]].compute());
  };
  jobs.take = [&](std::size_t job, std::size_t k, const JobLine& line) {
    take(jobs_of[job][k], {line.text, line.fault});
  };
  run_in_processes(jobs);
}

}  // namespace

std::vector<std::size_t> most_work_first(const std::vector<Task>& tasks) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tasks[a].work > tasks[b].work; });
  return order;
}

void LocalWorkers::compute(const std::vector<Task>& tasks, Company company, const Take& take) {
  if (company == Company::together) return compute_beside_one_another(tasks, take);
  if (company == Company::apart) return compute_apart(tasks, take);
  for (std::size_t k = 0; k < tasks.size(); ++k) take(k, {tasks[k].compute(), {}});
}

}  // namespace plumb
