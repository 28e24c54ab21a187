#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus report_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  const Run run = find_run(options.input);
  OutputFolder folder(output_path_of_run(options));
  write_run(run, folder);
  return draw_and_report(run, folder, stages, options, talk);
}

}  // namespace plumb
