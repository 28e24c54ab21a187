#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <sstream>

#include "engine/study/work_precision/journal.h"
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

std::string journal_heading() {
  const MemoryFile file("heading");
  StudyJournal(file.hold(""), identity);
  return file.text();
}

/// Each line with the check sum that a journal asks of it.
std::string mended(std::string_view lines) {
  std::string result;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string line(lines.substr(0, end)), summed = std::string(identity) + '\n' + line;
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(summed.data()), summed.size());
    result += fmt::format("{:08x} {}\n", sum, line);
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return result;
}

/// What a journal says that has these lines behind its heading.
bool feed_lines(const std::string& lines) {
  static const MemoryFile file("journal");
  static const std::string heading = journal_heading();
  const std::string path = file.hold(heading + lines);
  const StudyRun run = made_run();
  std::size_t found = 0;
  {
    StudyJournal journal(path, identity);
    found = journal.found();
    promise(found <= static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')),
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

/// The lines of a journal without their check sums.
bool feed(std::string_view input) {
  feed_lines(std::string(input));
  return feed_lines(mended(input));
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
  std::string seed;
  std::istringstream lines(file.text());
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) seed += line.substr(line.find(' ') + 1) + '\n';
  return {seed};
}

}  // namespace

const Target journal_target{"journal", feed, seeds};

}  // namespace plumb::fuzz
