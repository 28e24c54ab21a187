#include "report/program/drawing_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

#include "engine/base/errors.h"
#include "report/figure/pictures.h"
#include "report/program/run_pipeline.h"
#include "report/verdict/reference_points.h"

namespace plumb {
namespace {

std::optional<int> whole(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return {};
  return value;
}

LoadedCase for_drawing(const CaseSource& source) {
  return load_case(source, [](std::string_view section) { return section == "scene"; });
}

/// Reads the case of a run with one more override, which stands for an option: a fault in it is one of that
/// option, which the user typed, and not of the override.
void check_option(const CaseSource& source, const std::string& setting, const std::string& option) {
  CaseSource with = source;
  with.overrides.push_back(setting);
  try {
    for_drawing(with);
  } catch (const InputError& error) {
    const std::string fault = error.what(), unknown_name = "--set " + setting;
    if (!fault.starts_with(unknown_name)) throw;
    throw UsageError(option + fault.substr(unknown_name.size()));
  }
}

}  // namespace

std::optional<FrameRange> asked_frames(const Options& options) {
  const std::string& text = options.frames;
  if (text.empty()) return {};
  const std::size_t colon = text.find(':');
  const auto first = whole(std::string_view(text).substr(0, colon));
  std::optional<int> last = first;
  if (colon != std::string::npos)
    last = colon + 1 == text.size() ? FrameRange::open_end : whole(text.substr(colon + 1));
  if (!first || !last || *last < *first)
    throw UsageError(fmt::format(
        "--frames {}: must be two frame numbers from 0, the lower first, as 10:20, or 10: or 10", text));
  return FrameRange{*first, *last};
}

FrameRange frames_of_share(const Share& share, int frames, const std::optional<FrameRange>& asked) {
  const FrameRange all = range_within(frames, asked);
  const auto begin_of = [&](std::size_t number) {
    return all.first + static_cast<int>((number - 1) * static_cast<std::size_t>(all.count()) / share.of);
  };
  const FrameRange own{begin_of(share.number), begin_of(share.number + 1) - 1};
  if (own.count() == 0)
    throw UsageError(
        fmt::format("--share {}/{}: of {} frames this share has none", share.number, share.of, all.count()));
  return own;
}

LoadedCase with_asked_scene(const LoadedCase& loaded, const Options& options) {
  CaseSource source = loaded.source;
  for (const std::string& set : options.overrides) {
    if (!set.starts_with("scene."))
      throw UsageError(fmt::format(
          "--set {}: the run is done; only keys of [scene] can be set, such as scene.theme=dark", set));
    source.overrides.push_back(set);
  }
  if (!options.size.empty()) {
    const std::size_t times = options.size.find('x');
    const auto width = whole(std::string_view(options.size).substr(0, times));
    const auto height = times == std::string::npos ? std::nullopt : whole(options.size.substr(times + 1));
    if (!width || !height)
      throw UsageError(
          fmt::format("--size {}: must be width and height in pixels, as 3840x2160", options.size));
    const std::string setting = fmt::format("scene.size=[{},{}]", *width, *height);
    check_option(source, setting, "--size " + options.size);
    source.overrides.push_back(setting);
  }
  if (!options.camera.empty()) {
    const std::string setting = "scene.camera=" + options.camera;
    check_option(source, setting, "--camera " + options.camera);
    source.overrides.push_back(setting);
  }
  return for_drawing(source);
}

void add_asked(SceneOfRun& scene, const Run& run, const Options& options, std::vector<OtherRun>& others,
               Console& console) {
  if (scene.motion() == nullptr) return;
  for (const std::string& path : options.over) others.push_back({path, find_run(path), false});
  for (const std::string& path : options.beside) others.push_back({path, find_run(path), true});
  add_other_runs(scene.input(), options.input, *scene.motion(), others);
  if (!options.points) return;
  ReferencePoints points = reference_points(run, *scene.motion(), scene.input());
  if (points.series.empty())
    throw UsageError(fmt::format("--points: there is none to show{}{}", points.left_out.empty() ? "" : ": ",
                                 fmt::join(points.left_out, "; ")));
  for (const std::string& reason : points.left_out) console.remark("--points: " + reason);
  scene.input().points = std::move(points.series);
}

}  // namespace plumb
