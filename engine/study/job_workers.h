#pragma once

#include <map>

#include "engine/base/job.h"
#include "engine/study/workers.h"

namespace plumb {

/// The processes of a job: that of rank 0 hands out tasks, those of most work first, computes beside the
/// others, and has the journal; each other one computes one task after another and asks for the next before
/// it is done, so that none waits. What is to be timed is computed by rank 0 while the others rest: times
/// are those of one machine. Tasks apart are handed out by their groups. All processes must plan the same
/// points.
class JobWorkers : public Workers {
 public:
  explicit JobWorkers(Job& job) : job_(job) {}

  bool is_job() const override { return true; }
  bool serves() const override { return job_.rank() > 0; }
  /// Throws OutputError where another process failed, saying which and why.
  void compute(const std::vector<Task>& tasks, Company company, const Take& take) override;
  void spread(std::vector<std::string>& lines) override;

 private:
  void hand_out(const std::vector<Task>& tasks, Company company, const Take& take);
  void serve(const std::vector<Task>& tasks, Company company);
  std::string next_order();
  void tell_all(const std::string& text);

  Job& job_;
  long phase_ = 0;
  std::map<int, Machine> machines_;  // by rank
};

/// Sends the others home, whatever they are at; for rank 0, when it has done.
void end_job(Job& job);

/// Tells rank 0 that this process failed and why, and waits for it to end the job.
void fail_in_job(Job& job, const std::string& why);

}  // namespace plumb
