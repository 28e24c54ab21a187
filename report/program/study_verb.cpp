#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/study/study_record.h"
#include "report/program/kept_points.h"
#include "report/program/limits.h"
#include "report/program/output_use.h"
#include "report/program/run_pipeline.h"
#include "report/program/scene_choice.h"
#include "report/program/study_end.h"
#include "report/program/study_kinds.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

ExitStatus do_study(const Options& options, Console& console) {
  Stages stages;
  stages.begin("reading");
  LoadedCase loaded = load(options, console, options.kind.empty() ? use_all : uses_of_study(options.kind));
  refuse_without_method(loaded);
  const StudyKind& kind = chosen_study_kind(options, loaded.spec);
  const std::string path =
      options.output.empty() ? output_path(options, loaded) + kind.folder : options.output;
  check_estimate(loaded.spec, {.draws = true, .study = kind.estimate, .frames = 0}, loaded.source.file.name,
                 path, options, console);
  // What a scene needs is the question of that study, and the answer to start from for others.
  if (loaded.spec.method.name == scene_method && !kind.asks_what_a_scene_needs)
    loaded = as_the_scene_needs(loaded, output_path(options, loaded), options, console);
  if (loaded.spec.cable.model == CableModel::rigid && !kind.takes_rigid)
    throw InputError(loaded.source.file.name +
                     ": cable.model = \"rigid\": a rigid rod has no methods or meshes to study");
  OutputFolder folder(path, folder_for(loaded, options, console));
  try_drawing();
  KeptPoints points(folder.path(), loaded.source, console);
  points.take_over_from_run(output_path(options, loaded));
  std::string stage;
  Runner runner(points.journal(), [&](const std::string& part, double share) {
    if (part != stage) stages.begin(stage = part);
    console.progress(part, share);
  });
  try {
    const std::unique_ptr<MadeStudy> made = kind.make(loaded, runner);
    console.end_progress();
    const ExitStatus status = report_on(*made, folder, stages, options, console);
    points.remove();
    return status;
  } catch (const Interrupted&) {
    points.say_kept(console);
    throw;
  } catch (const WriteError&) {
    throw;
  } catch (const OutputError& error) {
    // What was computed is worth more than its pictures.
    if (!folder.holds("study.h5") && !folder.holds(study_json_name)) throw;
    folder.commit();
    throw OutputError(fmt::format("{}; the study is kept: plumb report {}", error.what(), folder.path()));
  }
}

}  // namespace

Verb study_verb() {
  return {.name = "study",
          .summary = "vary a case: work against precision, where methods fail",
          .act = do_study,
          .input = "CASE",
          .takes_overrides = true,
          .takes_output = true,
          .takes_kind = true,
          .is_estimated = true,
          .uses_renderer = true};
}

}  // namespace plumb
