#include <cstdio>

#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus report_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  const FoundRun found = find_run(options.input);
  OutputFolder folder(options.output.empty() ? found.folder : options.output);
  folder.start_from(found.folder);
  const Pictures pictures = draw_pictures(found.run, folder, stages, talk);
  const Results results = evaluate(found.run, stages);
  const std::string json = write_report(results, pictures, folder);
  folder.commit();
  say_verdicts(results, talk);
  talk.line(headline(results));
  talk.line("report: " + folder.path() + "/index.html");
  if (options.json) std::fputs(json.c_str(), stdout);
  return status_of(results);
}

}  // namespace plumb
