#include <fmt/format.h>

#include <filesystem>

#include "engine/errors.h"
#include "engine/study/run_work_precision.h"
#include "report/program/study_work.h"
#include "report/program/verbs.h"

namespace plumb {

namespace fs = std::filesystem;

ExitStatus study_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  const LoadedCase loaded = load(options, talk);
  const std::string path = options.output.empty() ? output_path(options, loaded) + "_study" : options.output;
  OutputFolder folder(path);
  StudyJournal journal(folder.path() + ".unfinished.jsonl", study_identity(loaded.source, false));
  if (journal.found() > 0) talk.line("going on with the study that " + journal.path() + " holds");
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
