#include <cstdio>

#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus run_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  const LoadedCase loaded = load(options, talk);
  OutputFolder folder(output_path(options, loaded));
  stages.begin("solving");
  const Run run = solve(loaded, talk);
  stages.begin("run file");
  write_run(run, folder);
  const Pictures pictures = draw_pictures(run, folder, stages, talk);
  const Results results = evaluate(run, stages);
  stages.begin("report");
  const std::string json = write_report(results, pictures, folder);
  folder.commit();
  stages.end();
  say_verdicts(results, talk);
  talk.line(headline(results));
  say_stages(stages, talk);
  talk.line("report: " + folder.path() + "/index.html");
  if (options.json) std::fputs(json.c_str(), stdout);
  return status_of(results);
}

}  // namespace plumb
