#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/job.h"
#include "report/document/report_formats.h"
#include "report/exports/export_formats.h"
#include "report/figure/scene_of_run.h"
#include "report/program/drawing_options.h"
#include "report/program/limits.h"
#include "report/program/output_use.h"
#include "report/program/print_json.h"
#include "report/program/run_pipeline.h"
#include "report/program/verbs.h"
#include "report/program/video.h"

namespace plumb {
namespace {

/// Frames as PNG files one after another on standard output, for an encoder.
ExitStatus stream_to_standard_output(const Run& run, const SceneOfRun& shown,
                                     const std::optional<FrameRange>& frames, Console& console) {
  if (shown.motion() == nullptr) throw OutputError("there are no frames: " + shown.notes().front());
  const GlContext context;
  SceneRenderer scene(context, *shown.motion(), shown.input());
  const FrameRange range = range_within(scene.frame_count(), frames);
  stream_frames(scene, range, picture_texts(context, run.loaded.source.file.name), PngEffort::quick,
                [&](int k, const std::string& png) {
                  write_to_standard_output(png);
                  console.progress("drawing", static_cast<double>(k + 1 - range.first) / range.count());
                });
  console.end_progress();
  console.line(counted(range.count(), "frame", "frames") + " on standard output");
  return ExitStatus::done;
}

ExitStatus do_render(const Options& options, Console& console) {
  const bool to_standard_output = options.output == "-";
  if (to_standard_output && (options.json || !options.video.empty()))
    throw UsageError("-o - has standard output for the frames: neither --json nor --video goes with it");
  Stages stages;
  stages.begin("reading");
  std::optional<FrameRange> frames = asked_frames(options);
  Share share = asked_share(options);
  if (const Job* job = job_of_process(); job != nullptr && options.share.empty())
    share = {static_cast<std::size_t>(job->rank()) + 1, static_cast<std::size_t>(job->size())};
  Run run = find_run(options.input);
  run.loaded = with_asked_scene(run.loaded, options);
  const std::string path =
      to_standard_output ? ""
                         : output_path_of_run(options) +
                               (options.output.empty() || options.share.empty() ? suffix_of(share) : "");
  check_estimate(
      run.loaded.spec,
      {.writes_run = !to_standard_output, .draws = true, .frames = frames ? 1.0 * frames->count() : -1},
      options.input, to_standard_output ? "." : path, options, console);
  std::vector<OtherRun> others;
  SceneOfRun scene(run, options.mode);
  add_asked(scene, run, options, others, console);
  // Before any work.
  if (scene.motion() != nullptr) {
    const int count = frame_count(scene.motion()->times.back(), run.loaded.spec.scene.frame_rate);
    const FrameRange own = frames_of_share(share, count, frames);
    if (frames || !share.is_all()) frames = own;
  }
  if (to_standard_output) return stream_to_standard_output(run, scene, frames, console);
  FolderUse use = folder_from(options.input, console);
  use.content = FolderContent::pictures;
  for (const std::vector<std::string>* paths : {&options.over, &options.beside})
    for (const std::string& other : *paths) use.reads.push_back(file_in(other, "run.h5"));
  OutputFolder folder(path, use);
  std::unique_ptr<Video> video;
  if (!options.video.empty()) {
    use.reads.insert(use.reads.end(), use.sources.begin(), use.sources.end());
    refuse_to_overwrite("--video", options.video, use.reads, folder.path());
    video = std::make_unique<Video>(options.video, run.loaded.spec.scene.frame_rate);
  }
  note_renderer(run, try_drawing());
  write_run(run, folder);
  for (const ReportFormat& format : report_formats()) folder.keep(std::string(format.file));
  for (const char* beside : {"index.html", "study.h5", "assessment.json", "choice.json"}) folder.keep(beside);
  keep_exports(folder);
  DrawingTools tools;
  const Pictures pictures = draw_pictures(run, scene, frames, tools, folder, stages, console);
  if (video) {
    stages.begin("video");
    for (int k = pictures.first_frame; k < pictures.first_frame + pictures.frames; ++k)
      video->add(folder.read(fmt::format("frames/{:04}.png", k)));
    if (!pictures.animated()) throw OutputError("there is no video: " + pictures.animation_notes.front());
    stages.end();
  }
  folder.commit();
  if (video) video->finish();
  console.line(fmt::format("{} and {}: {}", counted(std::ssize(pictures.figures), "figure", "figures"),
                           counted(pictures.frames, "frame", "frames"), folder.path()));
  if (video) console.line("video: " + options.video);
  say_stages(stages, console);
  if (options.json) {
    nlohmann::ordered_json json{
        {"folder", folder.path()}, {"frames", pictures.frames}, {"figures", nlohmann::ordered_json::array()}};
    for (const Picture& picture : pictures.figures) json["figures"].push_back(picture.file);
    print_json(json);
  }
  return ExitStatus::done;
}

}  // namespace

Verb render_verb() {
  return {.name = "render",
          .summary = "frames, figures and animation from a finished run",
          .act = do_render,
          .input = "RUN",
          .takes_overrides = true,
          .takes_output = true,
          .takes_share = true,
          .draws = true,
          .is_estimated = true,
          .works_in_job = true,
          .uses_renderer = true};
}

}  // namespace plumb
