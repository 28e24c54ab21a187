#include <fmt/format.h>

#include <algorithm>

#include "engine/base/errors.h"
#include "engine/study/variants/variants_file.h"
#include "report/program/run_pipeline.h"
#include "report/program/study_end.h"
#include "report/program/study_kinds.h"
#include "report/study/variants/variants_figures.h"
#include "report/study/variants/variants_results.h"

namespace plumb {
namespace {

void say_variants(const Variants& study, Talk& talk) {
  for (const VariantResult& variant : study.variants) {
    const bool expects = variant.spec.expects_anything();
    const std::string status = fmt::format("{:<7}", !expects ? "shown" : variant.met() ? "passed" : "failed");
    talk.line(fmt::format("  {} {}: {}",
                          !expects        ? talk.faint(status)
                          : variant.met() ? talk.good(status)
                                          : talk.bad(status),
                          variant.spec.name, found_in_words(variant)));
    if (expects && !variant.met())
      talk.line(fmt::format("          expected: {}", expected_in_words(variant)));
    if (!variant.trajectory.message.empty()) talk.line("          " + variant.trajectory.message);
  }
}

ExitStatus report_variants(const VariantsStudy& study, OutputFolder& folder, Stages& stages,
                           const Options& options, Talk& talk) {
  folder.write(study_json_name, encode_variants(study));
  stages.begin("figures");
  const std::vector<Picture> pictures =
      draw_figures(variants_figures(study.result), study.result.title, folder);
  stages.end();
  const StudyReport report = evaluate_variants(study, stages);
  stages.begin("report");
  put_in_place(report, shown_variants(study.result, pictures), folder, stages);
  say_variants(study.result, talk);
  return say_end(report, folder, stages, options, talk);
}

}  // namespace

ExitStatus variants_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                          const Options& options, Talk& talk) {
  if (loaded.spec.variants.empty())
    throw InputError(loaded.source.file.name + ": has no [[study.variant]] to run");
  const VariantsStudy study = run_variants(loaded, runner);
  talk.end_progress();
  return report_variants(study, folder, stages, options, talk);
}

ExitStatus variants_report(const std::string& json, OutputFolder& folder, Stages& stages,
                           const Options& options, Talk& talk) {
  return report_variants(decode_variants(json), folder, stages, options, talk);
}

}  // namespace plumb
