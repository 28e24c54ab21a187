#include <fmt/format.h>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "report/exports/export_formats.h"
#include "report/figure/scene_of_run.h"
#include "report/program/history_file.h"
#include "report/program/limits.h"
#include "report/program/many_reports.h"
#include "report/program/output_use.h"
#include "report/program/printed_page.h"
#include "report/program/rebuild_report.h"
#include "report/program/run_pipeline.h"
#include "report/program/run_sections.h"
#include "report/program/study_end.h"
#include "report/program/study_kinds.h"
#include "report/program/verbs.h"
#include "report/program/work_precision_pipeline.h"
#include "report/study/work_precision/work_precision_study.h"

namespace plumb {
namespace {

ExitStatus do_report(const Options& options, Console& console) {
  check_pdf(options);
  if (!options.from.empty()) {
    return report_from_document(options, console);
  }
  if (options.inputs.empty()) throw UsageError("report needs a RUN, or --from results.json");
  if (options.inputs.size() > 1) return index_many(matching_paths(options.inputs), options, console);
  Stages stages;
  stages.begin("reading");
  if (!options.history.empty()) {
    if (is_study(options.input) || study_json_at(options.input))
      throw UsageError(fmt::format("--history is of runs, and {} is a study", options.input));
    check_history(options.history, console);
  }
  if (is_study(options.input)) {
    const std::unique_ptr<MadeStudy> study = made_study(find_study(options.input));
    OutputFolder folder(output_path_of_run(options), folder_from(options.input, console));
    return report_on(*study, folder, stages, options, console);
  }
  if (const auto json = study_json_at(options.input)) {
    const StudyKind& kind = kind_of_study_json(*json);
    refuse_changed_text(json->text, json->name);
    OutputFolder folder(output_path_of_run(options), folder_from(options.input, console));
    return report_on(*kind.read(json->text, json->name), folder, stages, options, console);
  }
  Run run = find_run(options.input);
  check_estimate(run.loaded.spec, {.writes_run = true, .draws = fault_of_scene(run.loaded).empty()},
                 options.input, output_path_of_run(options), options, console);
  OutputFolder folder(output_path_of_run(options), folder_from(options.input, console));
  if (!options.history.empty())
    refuse_to_overwrite("--history", options.history, source_files(options.input), folder.path());
  note_renderer(run, try_drawing());
  write_run(run, folder);
  keep_exports(folder);
  const std::vector<RunSection> sections = sections_beside(options.input, run, folder);
  return draw_and_report(run, sections, folder, stages, options, console);
}

}  // namespace

Verb report_verb() {
  return {.name = "report",
          .summary = "the report, with its pictures, from a finished run; of several runs, an index",
          .act = do_report,
          .input = "RUN",
          .takes_many = true,
          .takes_history = true,
          .takes_document = true,
          .takes_pdf = true,
          .takes_output = true,
          .is_estimated = true,
          .uses_renderer = true};
}

}  // namespace plumb
