#include "report/program/study_end.h"

#include "engine/base/file_writing.h"
#include "report/program/run_pipeline.h"

namespace plumb {

void put_in_place(const StudyReport& report, const StudySection& section, OutputFolder& folder,
                  Stages& stages) {
  folder.write("index.html", to_page(report, section));
  write_formats(content_of(report), folder);
  folder.commit();
  stages.end();
}

ExitStatus say_end(const StudyReport& report, const OutputFolder& folder, const Stages& stages,
                   const Options& options, Talk& talk) {
  talk.line(report.headline);
  say_stages(stages, talk);
  talk.line("report: " + folder.path() + "/index.html");
  if (options.json) write_to_standard_output(to_json(content_of(report).document, false));
  if (!report.complete) return ExitStatus::solver_failed;
  return all_passed(report.verdicts) ? ExitStatus::done : ExitStatus::criterion_not_met;
}

}  // namespace plumb
