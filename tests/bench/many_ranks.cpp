// How well the processes of an MPI job would share a study: a model of the hand-out in
// engine/study/job_workers.cpp, fed with what each point took where it was computed.
//
//     many_ranks CASE KIND JOURNAL [RANKS]
//
// JOURNAL is the points.jsonl of `plumb study CASE KIND --share 1/1 -o DIR`. What each process does itself
// between the parts of a study, as integrating motions again, is measured here.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <queue>

#include "engine/case/case_source.h"
#include "engine/integrate/processor_time.h"
#include "engine/study/runner.h"
#include "engine/study/stability/run_stability.h"
#include "engine/study/sweep/run_sweep.h"
#include "engine/study/work_precision/run_work_precision.h"

namespace plumb {
namespace {

// Of rank 0 for a message, and on the way: more than Open MPI takes within a cluster, as a process that waits
// looks every millisecond.
constexpr double handling = 50e-6, latency = 1e-3;  // s
constexpr int units_ahead = 2;

struct Part {
  std::size_t units = 0;
  double work = 0;     ///< s, of all
  double longest = 0;  ///< s, of one unit
  double span = 0;     ///< s, until the last has ended
};

/// Hands out units, most predicted work first, to ranks that ask ahead for the next.
Part handed_out(const std::vector<double>& units, int ranks) {
  struct Message {
    double arrives;
    int from;
    bool operator>(const Message& other) const { return arrives > other.arrives; }
  };
  Part part;
  part.units = units.size();
  std::priority_queue<Message, std::vector<Message>, std::greater<>> messages;
  std::vector<double> busy_until(static_cast<std::size_t>(ranks), 0.0);
  for (int rank = 1; rank < ranks; ++rank)
    for (int k = 0; k < units_ahead; ++k) messages.push({latency, rank});
  double now = 0;
  for (const double took : units) {
    part.work += took;
    part.longest = std::max(part.longest, took);
    const Message message = messages.top();
    messages.pop();
    now = std::max(now, message.arrives) + 2 * handling;  // of the result that was sent before it, too
    double& busy = busy_until[static_cast<std::size_t>(message.from)];
    busy = std::max(busy, now + latency) + took;
    messages.push({busy + latency, message.from});
  }
  for (const double busy : busy_until) part.span = std::max(part.span, busy + latency);
  return part;
}

/// Takes each point from a journal, and notes what ranks would have made of it.
class SimulatedRanks : public Workers {
 public:
  SimulatedRanks(const Journal& measured, int ranks) : measured_(measured), ranks_(ranks) { begin(); }

  void compute(const std::vector<Task>& tasks, Company company, const Take& take) override {
    const double own = processor_seconds() - began_;
    std::map<std::size_t, double> groups;
    std::vector<double> units;
    for (const std::size_t k : most_work_first(tasks)) {
      const double took = std::max(0.0, measured_.seconds_of(tasks[k].key));
      if (company == Company::apart)
        groups[tasks[k].group] += took;
      else
        units.push_back(took);
    }
    for (const auto& [group, took] : groups) units.push_back(took);
    Part part = handed_out(units, company == Company::alone ? 2 : ranks_);
    fmt::print(
        "{:<28} {:>6} units {:>9.2f} s, longest {:>7.3f} s, done in {:>7.3f} s; before it each rank alone "
        "{:.3f} s\n",
        name_of(tasks), part.units, part.work, part.longest, part.span, own);
    work_ += part.work;
    span_ += part.span + own;
    for (std::size_t k = 0; k < tasks.size(); ++k) take(k, {"0 " + *measured_.find(tasks[k].key), {}});
    begin();
  }

  void conclude() const {
    fmt::print("{} ranks: {:.2f} s of work in {:.3f} s: efficiency {:.2f}\n", ranks_, work_, span_,
               work_ / (ranks_ * span_));
  }

 private:
  void begin() { began_ = processor_seconds(); }

  static std::string name_of(const std::vector<Task>& tasks) {
    std::set<std::string> parts;
    for (const Task& task : tasks) parts.insert(task.key.substr(0, task.key.find(':')));
    std::string name;
    for (const std::string& part : parts) name += (name.empty() ? "" : ", ") + part;
    return name;
  }

  const Journal& measured_;
  int ranks_;
  double began_ = 0;
  double work_ = 0;
  double span_ = 0;
};

/// Whatever program measured.
std::string program_of(const std::string& journal) {
  std::ifstream file(journal);
  std::string heading;
  std::getline(file, heading);
  return nlohmann::json::parse(heading).at("program");
}

int simulate(const std::string& case_file, const std::string& kind, const std::string& journal, int ranks) {
  const LoadedCase loaded = load_case(case_file, std::vector<std::string>{});
  Journal measured;
  measured.merge(journal, {study_identity(loaded.source).of_case, study_identity(loaded.source).case_name,
                           program_of(journal)});
  Journal own;
  SimulatedRanks workers(measured, ranks);
  Runner runner(own, {}, workers);
  if (kind == "stability")
    run_stability(loaded, runner);
  else if (kind == "sweep")
    run_sweep(loaded, runner);
  else
    run_work_precision(loaded.spec, false, runner);
  workers.conclude();
  return 0;
}

}  // namespace
}  // namespace plumb

int main(int count, char** arguments) {
  if (count < 4) {
    std::fputs("many_ranks CASE stability|sweep|work-precision JOURNAL [RANKS]\n", stderr);
    return 2;
  }
  try {
    return plumb::simulate(arguments[1], arguments[2], arguments[3],
                           count > 4 ? std::atoi(arguments[4]) : 1000);
  } catch (const std::exception& error) {
    fmt::print(stderr, "many_ranks: {}\n", error.what());
    return 1;
  }
}
