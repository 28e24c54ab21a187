#include "engine/study/work_precision/run_work_precision.h"
#include "report/program/study_kinds.h"
#include "report/program/work_precision_pipeline.h"

namespace plumb {

ExitStatus work_precision_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder,
                                Stages& stages, const Options& options, Talk& talk) {
  const Study study{loaded, run_work_precision(loaded.spec, false, runner)};
  talk.end_progress();
  return report_study(study, folder, stages, options, talk);
}

}  // namespace plumb
