#include <optional>

#include "engine/base/errors.h"
#include "engine/base/job_runs.h"
#include "report/document/case_json.h"
#include "report/document/regression.h"
#include "report/program/earlier_report.h"
#include "report/program/history_file.h"
#include "report/program/kept_points.h"
#include "report/program/limits.h"
#include "report/program/many_reports.h"
#include "report/program/output_use.h"
#include "report/program/run_pipeline.h"
#include "report/program/run_sections.h"
#include "report/program/scene_choice.h"
#include "report/program/verbs.h"
#include "report/study/economy/economy_section.h"

namespace plumb {

ExitStatus run_one(const Options& options, Console& console) {
  Stages stages;
  stages.begin("reading");
  LoadedCase loaded = load(options, console);
  // Before any work: a baseline that is not there would be found out too late.
  std::optional<Document> baseline;
  if (!options.baseline.empty()) baseline = find_baseline(options.baseline);
  if (!options.history.empty()) check_history(options.history, console);
  check_estimate(loaded.spec, work_of_run(loaded.spec), loaded.source.file.name, output_path(options, loaded),
                 options, console);
  remark_on_inputs(loaded.spec, console);
  OutputFolder folder(output_path(options, loaded), folder_for(loaded, options, console));
  if (!options.history.empty())
    refuse_to_overwrite("--history", options.history, files_read(loaded, options), folder.path());
  const std::string renderer = try_drawing();
  std::optional<Economy> economy;
  if (is_left_to_scene(loaded, options)) {
    stages.begin("choosing");
    SceneChoice choice = choose_for_scene(loaded, folder.path(), options, console);
    write_choice(choice, folder);
    loaded = std::move(choice.loaded);
    economy = std::move(choice.economy);
  } else {
    folder.keep("choice.json");
  }
  if (baseline) refuse_other_case(*baseline, options.baseline, Document::parse(to_json(case_json(loaded))));
  stages.begin(reports_given_run(loaded.spec) ? "taking the external run" : solving_stage);
  Run run = solve_or_take(loaded, console);
  // A start that is not finite leaves nothing to draw or report; the line about it has been said.
  if (run.trajectory.times.empty()) return ExitStatus::solver_failed;
  stages.begin("run file");
  note_renderer(run, renderer);
  if (economy) run.provenance.emplace_back(left_to_scene, "as choice.json says");
  write_run(run, folder);
  KeptPoints points(folder.path(), loaded.source, console);
  std::optional<DrawingBeside> drawing;
  const std::vector<RunSection> sections = computed_sections(run, economy, points.journal(), folder, stages,
                                                             console, [&] { drawing.emplace(run, folder); });
  if (!points.journal().empty()) points.write(folder);
  const ExitStatus status = draw_and_report(run, sections, folder, stages, options, console, &*drawing);
  points.remove();
  return status;
}

namespace {

ExitStatus do_run(const Options& options, Console& console) {
  if (Job* job = job_of_process(); job != nullptr && job->rank() > 0) {
    serve_own_runs(*job);
    return ExitStatus::done;
  }
  const CaseList cases = cases_named(options.inputs);
  if (cases.paths.size() == 1 && cases.folder.empty() && !options.share.empty())
    throw UsageError(
        "--share is for several cases, and there is but one; the points of a study have shares of their own: "
        "plumb study");
  if (cases.paths.size() > 1 || !cases.folder.empty()) return run_many(cases, options, console);
  Options one = options;
  one.input = cases.paths.front();
  return run_one(one, console);
}

}  // namespace

Verb run_verb() {
  return {.name = "run",
          .summary = "the whole way: solve, draw, compare, report",
          .act = do_run,
          .input = "CASE",
          .takes_many = true,
          .takes_baseline = true,
          .takes_history = true,
          .takes_overrides = true,
          .takes_output = true,
          .takes_share = true,
          .chooses = true,
          .is_estimated = true,
          .works_in_job = true,
          .uses_renderer = true};
}

}  // namespace plumb
