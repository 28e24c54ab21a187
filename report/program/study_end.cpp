#include "report/program/study_end.h"

#include "engine/base/file_writing.h"
#include "report/program/printed_page.h"
#include "report/program/run_pipeline.h"

namespace plumb {
namespace {

void say(const Finding& finding, Console& console) {
  using Mood = Finding::Mood;
  const std::string& mark = finding.mark;
  console.line((finding.mood == Mood::good    ? console.good(mark)
                : finding.mood == Mood::bad   ? console.bad(mark)
                : finding.mood == Mood::faint ? console.faint(mark)
                                              : mark) +
               finding.text);
}

}  // namespace

ExitStatus report_on(const MadeStudy& study, OutputFolder& folder, Stages& stages, const Options& options,
                     Console& console) {
  const auto [name, bytes] = study.file();
  folder.write(name, bytes);
  stages.begin("figures");
  DrawingTools tools;
  draw_figures(study.figures_beside(), tools, study.title(), folder, false);
  const std::vector<Picture> pictures = draw_for_page(study.figures(), tools, study.title(), folder);
  stages.end();
  const StudyReport report = study.report(stages);
  stages.begin("report");
  folder.write("index.html", to_page(report, study.section(pictures)));
  const ReportContent content = content_of(report);
  write_formats(content, folder);
  add_pdf(folder, options);
  folder.commit();
  stages.end();
  for (const Finding& finding : study.findings()) say(finding, console);
  if (study.says_verdicts()) say_verdicts(report.verdicts, console);
  console.line(report.headline);
  for (const std::string* more : {&report.details, &report.counts})
    if (!more->empty()) console.line(*more);
  say_stages(stages, console);
  console.line("report: " + folder.path() + "/index.html");
  if (options.json) write_to_standard_output(to_json(content.document, false));
  if (!report.complete) return ExitStatus::solver_failed;
  return all_passed(report.verdicts) ? ExitStatus::done : ExitStatus::criterion_not_met;
}

}  // namespace plumb
