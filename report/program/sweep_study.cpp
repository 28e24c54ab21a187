#include "engine/study/sweep/run_sweep.h"
#include "engine/study/sweep/sweep_json.h"
#include "report/program/run_pipeline.h"
#include "report/program/study_end.h"
#include "report/program/study_kinds.h"
#include "report/study/sweep/sweep_results.h"

namespace plumb {
namespace {

/// All that follows a sweep: verdicts and report, with the folder put in place and the findings said.
ExitStatus report_on(const Sweep& sweep, OutputFolder& folder, Stages& stages, const Options& options,
                     Talk& talk) {
  folder.write(study_json_name, encode_sweep(sweep));
  stages.begin("figures");
  const std::vector<Picture> pictures = draw_figures(sweep_figures(sweep), sweep.loaded.spec.title, folder);
  stages.end();
  const StudyReport report = evaluate_sweep(sweep, stages);
  stages.begin("report");
  put_in_place(report, shown_sweep(sweep, pictures), folder, stages);
  for (const std::string& line : outcome_lines(sweep)) talk.line(line);
  for (const SweepRun& run : sweep.runs)
    if (const std::string trouble = trouble_of(run, sweep.spec.tolerance); !trouble.empty())
      talk.line(talk.bad("case " + std::to_string(run.number)) + ": " + trouble + ": " +
                command_of(sweep, run));
  say_verdicts(report.verdicts, talk);
  return say_end(report, folder, stages, options, talk);
}

}  // namespace

ExitStatus sweep_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                       const Options& options, Talk& talk) {
  const Sweep sweep = run_sweep(loaded, runner);
  talk.end_progress();
  return report_on(sweep, folder, stages, options, talk);
}

ExitStatus sweep_report(const std::string& json, OutputFolder& folder, Stages& stages, const Options& options,
                        Talk& talk) {
  return report_on(decode_sweep(json, study_json_name), folder, stages, options, talk);
}

}  // namespace plumb
