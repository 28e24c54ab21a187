#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/job.h"
#include "engine/study/job_workers.h"
#include "engine/study/study_record.h"
#include "report/program/limits.h"
#include "report/program/output_use.h"
#include "report/program/run_pipeline.h"
#include "report/program/scene_choice.h"
#include "report/program/study_end.h"
#include "report/program/study_kinds.h"
#include "report/program/study_shares.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

StudyProgress shown_on(Console& console, Stages& stages) {
  return [&console, &stages, stage = std::string()](const std::string& part, double share) mutable {
    if (part != stage) stages.begin(stage = part);
    console.progress(part, share);
  };
}

ExitStatus report_or_keep(const MadeStudy& made, OutputFolder& folder, Stages& stages, const Options& options,
                          Console& console) {
  try {
    console.end_progress();
    return report_on(made, folder, stages, options, console);
  } catch (const WriteError&) {
    throw;
  } catch (const OutputError& error) {
    // What was computed is worth more than its pictures.
    if (!folder.holds("study.h5") && !folder.holds(study_json_name)) throw;
    folder.commit();
    throw OutputError(fmt::format("{}; the study is kept: plumb report {}", error.what(), folder.path()));
  }
}

std::unique_ptr<Workers> workers_here() {
  if (Job* job = job_of_process()) return std::make_unique<JobWorkers>(*job);
  return std::make_unique<LocalWorkers>();
}

/// As a process of a job that only computes for rank 0.
ExitStatus serve(const LoadedCase& loaded, const StudyKind& kind, Job& job) {
  Journal journal;
  JobWorkers workers(job);
  Runner runner(journal, {}, workers);
  try {
    kind.make(loaded, runner);
  } catch (const NotWhole&) {
  }
  return ExitStatus::done;
}

ExitStatus compute(const LoadedCase& loaded, const StudyKind& kind, OutputFolder& folder, Stages& stages,
                   const Options& options, Console& console) {
  KeptPoints points(folder.path(), loaded.source, console);
  points.take_over_from(output_path(options, loaded));
  points.take_over_from(folder.path());
  const std::unique_ptr<Workers> workers = workers_here();
  Runner runner(points.journal(), shown_on(console, stages), *workers, scope_asked_for(options, points));
  try {
    std::unique_ptr<MadeStudy> made;
    try {
      made = kind.make(loaded, runner);
    } catch (const NotWhole&) {
    } catch (const OutputError&) {
      points.say_kept(console);
      throw;
    }
    console.end_progress();
    const ExitStatus status = computes_a_part(options)
                                  ? keep_part(runner, points, kind.name, folder, options, console)
                                  : report_or_keep(*made, folder, stages, options, console);
    points.remove();
    return status;
  } catch (const Interrupted&) {
    points.say_kept(console);
    throw;
  }
}

ExitStatus merge(const LoadedCase& loaded, const StudyKind& kind, OutputFolder& folder, Stages& stages,
                 const Options& options, Console& console) {
  const StudyIdentity identity = study_identity(loaded.source);
  Journal journal;
  merge_journals(options, identity, journal, console);
  LocalWorkers workers;
  Runner runner(journal, shown_on(console, stages), workers, {.computes = false});
  std::unique_ptr<MadeStudy> made;
  try {
    made = kind.make(loaded, runner);
  } catch (const NotWhole&) {
    console.end_progress();
    return say_missing(runner, identity, folder.path(), kind.name, options, console);
  }
  return report_or_keep(*made, folder, stages, options, console);
}

ExitStatus do_study(const Options& options, Console& console) {
  Stages stages;
  stages.begin("reading");
  LoadedCase loaded = load(options, console, options.kind.empty() ? use_all : uses_of_study(options.kind));
  refuse_without_method(loaded);
  const StudyKind& kind = chosen_study_kind(options, loaded.spec);
  const std::string path = options.output.empty()
                               ? output_path(options, loaded) + kind.folder + part_suffix(options)
                               : options.output;
  check_estimate(loaded.spec, {.draws = true, .study = kind.estimate, .frames = 0}, loaded.source.file.name,
                 path, options, console);
  remark_on_inputs(loaded.spec, console);
  // What a scene needs is the question of that study, and the answer to start from for others.
  if (loaded.spec.method.name == scene_method && !kind.asks_what_a_scene_needs)
    loaded = as_the_scene_needs(loaded, output_path(options, loaded), options, console);
  if (loaded.spec.cable.model == CableModel::rigid && !kind.takes_rigid)
    throw InputError(loaded.source.file.name +
                     ": cable.model = \"rigid\": a rigid rod has no methods or meshes to study");
  if (Job* job = job_of_process(); job != nullptr && job->rank() > 0) return serve(loaded, kind, *job);
  FolderUse use = folder_for(loaded, options, console);
  for (const std::string& file : journals_read(options)) use.reads.push_back(file);
  OutputFolder folder(path, use);
  if (!computes_a_part(options)) try_drawing();
  if (!options.merge.empty()) return merge(loaded, kind, folder, stages, options, console);
  return compute(loaded, kind, folder, stages, options, console);
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
          .takes_share = true,
          .takes_parts = true,
          .is_estimated = true,
          .works_in_job = true,
          .uses_renderer = true};
}

}  // namespace plumb
