#include "report/program/study_kinds.h"
#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus study_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  const LoadedCase loaded = load(options, talk);
  refuse_without_method(loaded);
  const StudyKind& kind = chosen_study_kind(options, loaded.spec);
  OutputFolder folder(options.output.empty() ? output_path(options, loaded) + kind.folder : options.output);
  return kind.study(loaded, folder, stages, options, talk);
}

}  // namespace plumb
