#include <fmt/format.h>

#include "engine/study/stability/run_stability.h"
#include "report/program/run_pipeline.h"
#include "report/program/study_end.h"
#include "report/program/study_kinds.h"
#include "report/study/stability/stability_figures.h"
#include "report/study/stability/stability_results.h"

namespace plumb {
namespace {

void say_words(const Stability& study, Talk& talk) {
  const MapAxis axis = study.parameter.empty() ? MapAxis::elements : MapAxis::parameter;
  talk.line(fmt::format("Steps at {}, to {:g} m", place_in_words(study, MapAxis::duration), study.tolerance));
  for (const OutcomeMap& map : study.maps)
    if (map.axis == axis) talk.line(fmt::format("  {}: {}", map.label, map.in_words));
}

ExitStatus report_on(const StabilityStudyFile& study, OutputFolder& folder, Stages& stages,
                     const Options& options, Talk& talk) {
  folder.write(study_json_name, encode_stability(study));
  stages.begin("figures");
  draw_figures(method_figures(study.result), study.result.title, folder);
  const std::vector<Picture> pictures =
      draw_figures(stability_figures(study.result), study.result.title, folder);
  stages.end();
  const StudyReport report = evaluate_stability(study, stages);
  stages.begin("report");
  put_in_place(report, shown_stability(study.result, pictures), folder, stages);
  say_words(study.result, talk);
  say_verdicts(report.verdicts, talk);
  return say_end(report, folder, stages, options, talk);
}

}  // namespace

ExitStatus stability_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                           const Options& options, Talk& talk) {
  const StabilityStudyFile study{loaded, run_stability(loaded, runner)};
  talk.end_progress();
  return report_on(study, folder, stages, options, talk);
}

ExitStatus stability_report(const std::string& json, OutputFolder& folder, Stages& stages,
                            const Options& options, Talk& talk) {
  return report_on(decode_stability(json, options.input), folder, stages, options, talk);
}

}  // namespace plumb
