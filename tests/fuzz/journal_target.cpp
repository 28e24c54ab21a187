#include <algorithm>

#include "engine/study/study_journal.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

constexpr const char* identity = "of-the-target";

StudyRun made_run() {
  StudyRun run;
  run.method.name = "rk4";
  run.method.step = 0.25;
  run.method.parameters = {{"order", 3}};
  run.elements = 4;
  run.outcome = Outcome::completed;
  run.counters.steps = 7;
  run.seconds = {0.5, 0.25};
  run.time_error = run.total_error = {0.1, 0.05, 0.025, 1e-9};
  return run;
}

/// What a journal says that has the input behind its heading.
bool feed(std::string_view input) {
  static const MemoryFile file("journal");
  static const std::string heading = [] {
    const MemoryFile fresh("heading");
    fresh.hold("");
    StudyJournal(fresh.hold(""), identity);
    return fresh.text();
  }();
  const std::string path = file.hold(heading + std::string(input));
  const StudyRun run = made_run();
  std::size_t found = 0;
  {
    StudyJournal journal(path, identity);
    found = journal.found();
    promise(found <= static_cast<std::size_t>(std::count(input.begin(), input.end(), '\n')),
            "a journal finds more than it has lines");
    promise_finite(journal.find_seconds(run), "a time of a journal");
    journal.add_run(run);
    journal.add_seconds(run);
  }
  const StudyJournal again(path, identity);
  promise(again.found() == found + 2, "a line that was added is lost, or one that was torn is back");
  const auto kept = again.find_run(run.method, run.elements);
  promise(kept && kept->method == run.method && kept->outcome == run.outcome &&
              kept->counters.steps == run.counters.steps &&
              kept->total_error.energy == run.total_error.energy && again.find_seconds(run) == run.seconds,
          "a run of a journal is another");
  return found > 0;
}

std::vector<std::string> seeds() {
  const MemoryFile file("seed");
  const std::string path = file.hold("");
  {
    StudyJournal journal(path, identity);
    journal.add_run(made_run());
    journal.add_seconds(made_run());
    StudyReference reference;
    reference.method = made_run().method;
    reference.trajectory.times = {0, 1};
    reference.certificate.elements = 4;
    reference.certificate.first = "one";
    reference.certificate.agreement = 1e-12;
    journal.add_reference(reference);
  }
  const std::string text = file.text();
  return {text.substr(text.find('\n') + 1)};
}

}  // namespace

const Target journal_target{"journal", feed, seeds};

}  // namespace plumb::fuzz
