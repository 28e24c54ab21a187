#include "engine/base/job_runs.h"

#include <deque>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"

namespace plumb {
namespace {

constexpr double look_every_s = 0.1;

std::string one_line_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

OwnRunEnd run_one_of_several(const OwnRun& run, const std::function<void()>& stopping) {
  OwnRunEnd ended;
  run_side_by_side(
      {run}, std::numeric_limits<double>::infinity(), [&](std::size_t, const OwnRunEnd& end) { ended = end; },
      stopping);
  return ended;
}

}  // namespace

void run_in_job(Job& job, const std::vector<OwnRun>& runs,
                const std::function<void(std::size_t run, const OwnRunEnd& end)>& take,
                const std::function<void()>& stopping) {
  std::deque<std::size_t> waiting, alone;
  for (std::size_t k = 0; k < runs.size(); ++k) (runs[k].alone ? alone : waiting).push_back(k);
  std::size_t under_way = 0;
  const auto hand_to = [&](int rank) {
    if (waiting.empty()) return;
    job.send(rank,
             one_line_of(
                 {{"do", "run"}, {"run", waiting.front()}, {"arguments", runs[waiting.front()].arguments}}));
    waiting.pop_front();
    ++under_way;
  };
  for (int rank = 1; rank < job.size(); ++rank) hand_to(rank);
  while (under_way > 0) {
    if (is_interrupted()) stopping();
    stop_if_interrupted();
    const auto message = job.receive(look_every_s);
    if (!message) continue;
    const auto said = nlohmann::ordered_json::parse(message->text);
    if (said.at("is") == "failed")
      throw OutputError("process " + std::to_string(message->from) +
                        " of the job failed: " + said.at("why").get<std::string>());
    --under_way;
    hand_to(message->from);
    take(said.at("run"), {said.at("status"), said.at("fault"), said.at("errors"), said.at("seconds")});
  }
  for (const std::size_t k : alone) take(k, run_one_of_several(runs[k], stopping));
}

void serve_own_runs(Job& job) {
  for (;;) {
    stop_if_interrupted();
    const auto message = job.receive(look_every_s);
    if (!message) continue;
    const auto order = nlohmann::ordered_json::parse(message->text);
    if (order.at("do") == "go") return;
    const OwnRunEnd end = run_one_of_several({order.at("arguments"), 0, false}, [] {});
    job.send(0, one_line_of({{"is", "ended"},
                             {"run", order.at("run")},
                             {"status", end.status},
                             {"fault", end.fault},
                             {"errors", end.errors},
                             {"seconds", end.seconds}}));
  }
}

}  // namespace plumb
