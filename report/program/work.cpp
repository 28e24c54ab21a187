#include "report/program/work.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <filesystem>

#include "engine/integrate/integrate.h"
#include "engine/output/file_writing.h"
#include "engine/output/run_file.h"
#include "report/page.h"

namespace plumb {

namespace fs = std::filesystem;

LoadedCase load(const Options& options, Talk& talk) {
  LoadedCase loaded = load_case(options.input, options.overrides);
  for (const std::string& remark : loaded.remarks) talk.remark(remark);
  return loaded;
}

Run solve(const LoadedCase& loaded, Talk& talk) {
  const double end = loaded.spec.time.end;
  Trajectory trajectory = integrate(loaded.spec, [&](double t) { talk.progress("solving", t / end); });
  talk.end_progress();
  ProbeTable probes = probe(loaded.spec, trajectory);
  talk.line(fmt::format("{}: {} with {} elements to {:.4g} s in {} steps, {:.3g} s", loaded.spec.title,
                        loaded.spec.method.name, trajectory.elements, trajectory.end_time,
                        trajectory.counters.steps, trajectory.solve_seconds));
  if (trajectory.outcome != Outcome::completed)
    talk.line(talk.bad(std::string(word(trajectory.outcome))) + ": " + trajectory.message);
  return {loaded, std::move(trajectory), std::move(probes), provenance_now()};
}

std::string output_path(const Options& options, const LoadedCase& loaded) {
  if (!options.output.empty()) return options.output;
  return (fs::path("output") / fs::path(loaded.source.file.name).stem()).string();
}

FoundRun find_run(const std::string& path) {
  const fs::path file = fs::is_directory(path) ? fs::path(path) / "run.h5" : fs::path(path);
  return {read_run(file.string()), fs::absolute(file).parent_path().string()};
}

void write_run(const Run& run, OutputFolder& folder) {
  write_file(folder.file("run.h5"), encode_run(run));
  write_file(folder.file("probes.csv"), to_csv(run.probes));
}

Pictures draw_pictures(const Run& run, OutputFolder& folder, Stages& stages, Talk& talk) {
  Pictures pictures =
      draw(run, series_errors(run), folder, stages, [&](double share) { talk.progress("drawing", share); });
  talk.end_progress();
  return pictures;
}

std::string write_report(const Results& results, const Pictures& pictures, OutputFolder& folder) {
  write_file(folder.file("index.html"), to_page(results, pictures));
  std::string json = to_json(results);
  write_file(folder.file("results.json"), json);
  write_file(folder.file("junit.xml"), to_junit(results));
  write_file(folder.file("summary.md"), to_summary(results));
  return json;
}

void say_verdicts(const Results& results, Talk& talk) {
  for (const Verdict& verdict : results.verdicts) {
    const std::string status = fmt::format("{:<7}", word(verdict.status));
    talk.line(fmt::format("  {} {:<12} {:<18} {}",
                          verdict.status == VerdictStatus::passed ? talk.good(status) : talk.bad(status),
                          word(verdict.kind), verdict.name, verdict.message));
  }
}

void say_stages(const Stages& stages, Talk& talk) {
  std::string text;
  double total = 0;
  for (const auto& [name, seconds] : stages.all()) {
    text += fmt::format("{}{} {:.2f} s", text.empty() ? "" : ", ", name, seconds);
    total += seconds;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  talk.line(talk.faint(
      fmt::format("time: {}; {:.2f} s in all; peak memory {} MB", text, total, usage.ru_maxrss / 1024)));
}

ExitStatus status_of(const Results& results) {
  if (!results.solved()) return ExitStatus::solver_failed;
  return all_passed(results.verdicts) ? ExitStatus::done : ExitStatus::criterion_not_met;
}

}  // namespace plumb
