#include "engine/study/economy/economy_study_json.h"
#include "engine/study/economy/run_economy.h"
#include "report/program/run_pipeline.h"
#include "report/program/study_end.h"
#include "report/program/study_kinds.h"
#include "report/study/economy/economy_gauge.h"
#include "report/study/economy/economy_results.h"

namespace plumb {
namespace {

/// All that follows the study: verdicts and report, with the folder put in place and the findings said.
ExitStatus report_on(const EconomyStudy& study, OutputFolder& folder, Stages& stages, const Options& options,
                     Talk& talk) {
  folder.write(study_json_name, encode_economy_study(study));
  stages.begin("figures");
  const std::vector<Picture> pictures =
      draw_figures(economy_study_figures(study), study.loaded.spec.title, folder);
  stages.end();
  const StudyReport report = evaluate_economy(study, stages);
  stages.begin("report");
  put_in_place(report, shown_economy(study, pictures), folder, stages);
  for (const std::string& line : need_lines(study)) talk.line(line);
  say_verdicts(report.verdicts, talk);
  return say_end(report, folder, stages, options, talk);
}

}  // namespace

ExitStatus economy_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                         const Options& options, Talk& talk) {
  const EconomyStudy study = run_economy(loaded, gauge_maker, runner);
  talk.end_progress();
  return report_on(study, folder, stages, options, talk);
}

ExitStatus economy_report(const std::string& json, OutputFolder& folder, Stages& stages,
                          const Options& options, Talk& talk) {
  return report_on(decode_economy_study(json, study_json_name), folder, stages, options, talk);
}

}  // namespace plumb
