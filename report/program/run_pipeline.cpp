#include "report/program/run_pipeline.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <filesystem>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/integrate/integrate.h"
#include "engine/read/given_probes.h"
#include "engine/run/mode_table.h"
#include "engine/run/plausibility.h"
#include "engine/run/run_file.h"
#include "report/document/given_json.h"
#include "report/figure/run_figures.h"
#include "report/page/page.h"
#include "report/program/earlier_report.h"
#include "report/program/history_file.h"
#include "report/program/output_use.h"
#include "report/program/printed_page.h"
#include "report/program/run_sections.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr const char* run_file_name = "run.h5";

}  // namespace

void say_report(const Document& document, const std::string& folder, const Options& options,
                Console& console) {
  say_verdicts(verdicts_of(document), console);
  for (const std::string& distance : distances_in_words(document)) console.line("  " + distance);
  for (const Document& note : document.at("animation").value("notes", Document::array()))
    console.line("animation: " + note.get<std::string>());
  console.line(document.at("headline").get<std::string>());
  for (const PageSection& section : page_sections())
    if (section.line && document.contains(section.key)) console.line(section.line(document.at(section.key)));
  console.line("report: " + folder + "/index.html");
  if (options.json) write_to_standard_output(to_json(document));
}

ExitStatus status_of(const Document& document) {
  // An external run that failed was not solved here.
  if (!document.at("complete").get<bool>())
    return document.contains("computed_by") ? ExitStatus::criterion_not_met : ExitStatus::solver_failed;
  return all_passed(verdicts_of(document)) ? ExitStatus::done : ExitStatus::criterion_not_met;
}

void say_verdicts(const std::vector<Verdict>& verdicts, Console& console) {
  for (const Verdict& verdict : verdicts) {
    const std::string status = fmt::format("{:<7}", word(verdict.status));
    console.line(fmt::format("  {} {:<12} {:<18} {}",
                             verdict.status == VerdictStatus::passed          ? console.good(status)
                             : verdict.status == VerdictStatus::another_model ? status
                                                                              : console.bad(status),
                             word(verdict.kind), verdict.name, verdict.message));
  }
}

LoadedCase load(const Options& options, Console& console, const SectionUse& uses) {
  LoadedCase loaded = load_case(options.input, options.overrides, uses);
  refuse_names_of_run_figures(loaded);
  for (const std::string& remark : loaded.remarks) console.remark(remark);
  return loaded;
}

void remark_on_inputs(const Case& spec, Console& console) {
  for (const std::string& remark : implausible_inputs(spec)) console.remark(remark);
}

Run solve_or_take(const LoadedCase& loaded, Console& console) {
  if (!reports_given_run(loaded.spec)) return solve(loaded, console);
  Run run = reported_run(loaded, provenance_now());
  console.line(fmt::format("{}: not solved, given by {}: {} from {:.4g} to {:.4g} s", loaded.spec.title,
                           computed_by(loaded.spec.given_runs.front()),
                           counted(std::ssize(run.probes.times), "output", "outputs"),
                           run.probes.times.front(), run.probes.times.back()));
  return run;
}

void refuse_without_method(const LoadedCase& loaded) {
  if (!reports_given_run(loaded.spec)) return;
  throw UsageError(
      fmt::format("{} has no [method], so there is nothing to solve: plumb run reports on its given "
                  "run {}",
                  loaded.source.file.name, loaded.spec.given_runs.front().name));
}

Run solve(const LoadedCase& loaded, Console& console) {
  const double end = loaded.spec.time.end;
  Trajectory trajectory = integrate(loaded.spec, [&](double t) { console.progress("solving", t / end); });
  console.end_progress();
  ProbeTable probes = probe(loaded.spec, trajectory);
  ProbeTable modes = mode_table(loaded.spec, trajectory);
  if (find_method(loaded.spec.method.name)->timeless)
    console.line(fmt::format("{}: {} of {}{}, {:.3g} s", loaded.spec.title,
                             fmt::format("{} mode{}", modes.times.size(), modes.times.size() == 1 ? "" : "s"),
                             counted(trajectory.elements, "element", "elements"),
                             modes.times.empty() ? ""
                                                 : fmt::format(", the last of {:.6g} Hz",
                                                               trajectory.vibrations.modes.back().frequency),
                             trajectory.solve_seconds));
  else
    console.line(fmt::format("{}: {} with {} to {:.4g} s in {}, {:.3g} s", loaded.spec.title,
                             loaded.spec.method.name, counted(trajectory.elements, "element", "elements"),
                             trajectory.end_time, counted(trajectory.counters.steps, "step", "steps"),
                             trajectory.solve_seconds));
  if (const std::string cuts = step_cuts(trajectory.counters.rejected_steps, trajectory.shortest_cut);
      !cuts.empty())
    console.line("its step was " + cuts);
  if (const std::string remark = trajectory.remark(); !remark.empty()) console.line(remark);
  for (const auto& find : {implausible_stress, held_back_by_stability})
    if (const std::string remark = find(loaded.spec, trajectory); !remark.empty()) console.remark(remark);
  if (trajectory.outcome != Outcome::completed)
    console.line(console.bad(std::string(word(trajectory.outcome))) + ": " + trajectory.message);
  return {loaded, std::move(trajectory), std::move(probes), provenance_now(), std::move(modes)};
}

std::string output_path(const Options& options, const LoadedCase& loaded) {
  if (!options.output.empty()) return options.output;
  return (fs::path("output") / folder_name_of(loaded.source.file.name)).string();
}

Run find_run(const std::string& path) {
  std::error_code ignored;
  // A run that was solved is worth more than what is wrong in sections that solving makes no use of.
  return read_run(fs::is_directory(path, ignored) ? (fs::path(path) / run_file_name).string() : path,
                  [](std::string_view) { return false; });
}

std::string output_path_of_run(const Options& options) {
  if (!options.output.empty()) return options.output;
  std::error_code ignored;
  const fs::path path = options.input;
  if (fs::is_directory(path, ignored)) return path.string();
  if (path.filename() != run_file_name && path.filename() != "study.h5" && path.filename() != "study.json")
    throw UsageError(options.input + " is not named run.h5: name the output folder with -o");
  return fs::absolute(path).parent_path().string();
}

void note_renderer(Run& run, const std::string& fingerprint) {
  const std::string name = "renderer";
  for (auto& [known, value] : run.provenance)
    if (known == name) {
      value = fingerprint;
      return;
    }
  run.provenance.emplace_back(name, fingerprint);
}

void write_run(const Run& run, OutputFolder& folder) {
  folder.write(run_file_name, encode_run(run));
  folder.write("probes.csv", to_csv(run.probes));
  if (has_modes(run)) folder.write(std::string(modes_file), modes_csv(run.trajectory, run.modes));
}

Pictures draw_pictures(const Run& run, const SceneOfRun& scene, const std::optional<FrameRange>& range,
                       DrawingTools& tools, OutputFolder& folder, Stages& stages, Console& console) {
  Pictures pictures = draw(run, scene, series_errors(run), range, tools, folder, stages,
                           [&](double share) { console.progress("drawing", share); });
  console.end_progress();
  return pictures;
}

void say_stages(const Stages& stages, Console& console) {
  std::string text;
  for (const auto& [name, seconds] : stages.all())
    text += fmt::format("{}{} {:.2f} s", text.empty() ? "" : ", ", name, seconds);
  if (stages.any_beside()) text += ", some beside others";
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  console.line(console.faint(fmt::format("time: {}; {:.2f} s in all; peak memory {} MB", text,
                                         stages.elapsed(), usage.ru_maxrss / 1024)));
}

ExitStatus draw_and_report(const Run& run, const std::vector<RunSection>& sections, OutputFolder& folder,
                           Stages& stages, const Options& options, Console& console, DrawingBeside* begun) {
  Pictures pictures;
  std::string failure;
  try {
    if (begun != nullptr) {
      stages.begin("waiting for the pictures");
      pictures = begun->finish(sections);
      stages.end();
    } else {
      std::promise<const std::vector<RunSection>*> known;
      known.set_value(&sections);
      pictures = draw_all(run, known.get_future().share(), folder, stages,
                          [&](double share) { console.progress("drawing", share); });
      console.end_progress();
    }
  } catch (const WriteError&) {
    throw;
  } catch (const OutputError& error) {
    // What was solved is worth more than its pictures.
    console.end_progress();
    stages.end();
    failure = error.what();
    pictures.animation_notes = {"the pictures could not be drawn: " + failure};
  }
  if (begun != nullptr) stages.add_beside(begun->stages());
  Document document = document_of(evaluate(run, stages, sections), pictures);
  hold_against_earlier(document, run, pictures, options, folder.path());
  if (!options.history.empty()) add_history(document, options.history);
  stages.begin("report");
  write_report(document, pictures, page_sections(), folder);
  add_pdf(folder, options);
  folder.commit();
  if (!options.history.empty()) append_history(options.history, history_entry(document));
  stages.end();
  if (!failure.empty())
    throw OutputError(
        fmt::format("{}; the run and its report without pictures are in {}", failure, folder.path()));
  say_report(document, folder.path(), options, console);
  say_stages(stages, console);
  return status_of(document);
}

}  // namespace plumb
