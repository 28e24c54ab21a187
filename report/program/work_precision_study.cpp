#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/study/work_precision/run_work_precision.h"
#include "report/program/study_kinds.h"
#include "report/program/work_precision_pipeline.h"

namespace plumb {

ExitStatus work_precision_study(const LoadedCase& loaded, OutputFolder& folder, Stages& stages,
                                const Options& options, Talk& talk) {
  StudyJournal journal(folder.path() + ".unfinished.jsonl", study_identity(loaded.source, false));
  if (journal.found() > 0) talk.line("going on with the study that " + journal.path() + " holds");
  if (journal.damaged() > 0)
    talk.remark(fmt::format("{} has {}; what is missing is done again", journal.path(),
                            counted(static_cast<long>(journal.damaged()), "damaged line", "damaged lines")));
  Study study{loaded, {}};
  std::string stage;
  try {
    study.result =
        run_work_precision(loaded.spec, false, journal, [&](const std::string& part, double share) {
          if (part != stage) stages.begin(stage = part);
          talk.progress(part, share);
        });
  } catch (const Interrupted&) {
    talk.end_progress();
    talk.remark("what is done is kept in " + journal.path() + "; the same command goes on from there");
    throw;
  }
  talk.end_progress();
  const ExitStatus status = report_study(study, folder, stages, options, talk);
  journal.remove();
  return status;
}

}  // namespace plumb
