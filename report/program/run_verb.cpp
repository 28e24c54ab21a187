#include "report/program/economy_work.h"
#include "report/program/study_work.h"
#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus run_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  LoadedCase loaded = load(options, talk);
  OutputFolder folder(output_path(options, loaded));
  std::optional<Economy> economy;
  if (is_left_to_scene(loaded, options)) {
    stages.begin("choosing");
    SceneChoice choice = choose_for_scene(loaded, folder.path(), options, talk);
    write_choice(choice, folder);
    loaded = std::move(choice.loaded);
    economy = std::move(choice.economy);
  } else {
    folder.keep("choice.json");
  }
  stages.begin("solving");
  const Run run = solve(loaded, talk);
  // A start that is not finite leaves nothing to draw or report; the line about it has been said.
  if (run.trajectory.times.empty()) return ExitStatus::solver_failed;
  stages.begin("run file");
  write_run(run, folder);
  std::optional<Study> study;
  // A rigid rod has no methods and meshes to compare.
  if (loaded.spec.work_precision && loaded.spec.cable.model != CableModel::rigid) {
    stages.begin("study");
    study = quick_study(loaded, talk);
    write_study(*study, folder);
  }
  return draw_and_report(run, folder, stages, options, talk, study ? &*study : nullptr,
                         economy ? &*economy : nullptr);
}

}  // namespace plumb
