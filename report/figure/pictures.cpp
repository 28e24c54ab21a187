#include "report/figure/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>
#include <memory>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "render/gl/gl_context.h"
#include "render/image/apng.h"
#include "render/image/png.h"
#include "render/plot/plot_renderer.h"
#include "render/scene/frame_stream.h"
#include "render/scene/scene.h"
#include "report/figure/figure_csv.h"
#include "report/figure/scene_of_run.h"

namespace plumb {
namespace {

/// The scene as the page shows it: at most this wide and this often, so that one file holds the whole report.
constexpr int page_width = 512;
constexpr double page_frame_rate = 12.5;

SceneSpec page_scene(SceneSpec spec) {
  if (spec.size[0] > page_width) {
    spec.size[1] = std::max(16, spec.size[1] * page_width / spec.size[0]);
    spec.size[0] = page_width;
  }
  spec.frame_rate = std::min(spec.frame_rate, page_frame_rate);
  return spec;
}

}  // namespace

FrameRange range_within(int frames, const std::optional<FrameRange>& asked) {
  const int last = frames - 1;
  if (!asked) return {0, last};
  const bool open = asked->last == FrameRange::open_end;
  if (asked->first > last || (!open && asked->last > last))
    throw UsageError(fmt::format("--frames: there is no frame {}; the run has frames 0 to {}",
                                 asked->first > last ? asked->first : asked->last, last));
  return {asked->first, open ? last : asked->last};
}

PngTexts picture_texts(const GlContext& context, const std::string& title) {
  return {{"Software", "Plumb"}, {"Title", title}, {renderer_keyword, context.info().fingerprint()}};
}

namespace {

/// Each in the efforts that are asked for: `small` for its file, `page` for a page.
std::vector<Picture> drawn(const std::vector<Figure>& figures, DrawingTools& tools, const std::string& title,
                           bool for_file, bool for_page) {
  const PngTexts texts = picture_texts(tools.context, title);
  // Each is encoded beside the drawing of the next.
  constexpr std::size_t waiting = 2;
  std::vector<Picture> pictures;
  struct Encoded {
    std::string png, page_png;
  };
  std::deque<std::future<Encoded>> encoding;
  const auto take_first = [&] {
    const Figure& figure = figures[pictures.size()];
    Encoded encoded = encoding.front().get();
    pictures.push_back({fmt::format("figures/{}.png", figure.name), figure.title, figure.alt,
                        figure.plot.height > figure.plot.width, std::move(encoded.png), figure.plot,
                        figure.times, std::move(encoded.page_png)});
    encoding.pop_front();
  };
  for (const Figure& figure : figures) {
    stop_if_interrupted();
    const auto encode = [image = std::make_shared<const Image>(tools.plots.draw(figure.plot)), &texts,
                         for_file, for_page] {
      return Encoded{for_file ? encode_png(*image, texts) : "",
                     for_page ? encode_png(*image, {}, PngEffort::page) : ""};
    };
    // Where no thread is to be had the picture is encoded once it is asked for.
    encoding.push_back(std::async(std::launch::async | std::launch::deferred, encode));
    if (encoding.size() > waiting) take_first();
  }
  while (!encoding.empty()) take_first();
  return pictures;
}

void write(const std::vector<Picture>& pictures, const std::vector<Figure>& figures, OutputFolder& folder) {
  for (std::size_t i = 0; i < figures.size(); ++i) {
    folder.write(pictures[i].file, pictures[i].png);
    folder.write(fmt::format("figures/{}.csv", figures[i].name), to_csv(figures[i].plot));
  }
}

}  // namespace

std::vector<Picture> drawn_figures(const std::vector<Figure>& figures, DrawingTools& tools,
                                   const std::string& title) {
  return drawn(figures, tools, title, true, false);
}

std::vector<Picture> draw_figures(const std::vector<Figure>& figures, DrawingTools& tools,
                                  const std::string& title, OutputFolder& folder, bool for_page) {
  std::vector<Picture> pictures = drawn(figures, tools, title, true, for_page);
  write(pictures, figures, folder);
  return pictures;
}

std::vector<Picture> draw_for_page(const std::vector<Figure>& figures, DrawingTools& tools,
                                   const std::string& title, OutputFolder& folder) {
  // With these a page of a study stays below 5 MB, as base64 makes four bytes of three.
  constexpr std::size_t most_bytes = 2'150'000;
  std::vector<Picture> pictures = draw_figures(figures, tools, title, folder);
  std::vector<Figure> dark = figures;
  for (Figure& figure : dark) figure.plot.theme = SceneTheme::dark;
  const std::vector<Picture> on_dark = drawn(dark, tools, title, false, true);
  std::size_t bytes = 0;
  for (const Picture& picture : pictures) bytes += picture.page_png.size();
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    bytes += on_dark[k].page_png.size();
    if (bytes > most_bytes) break;
    pictures[k].dark_png = on_dark[k].page_png;
  }
  return pictures;
}

const Picture* find_picture(const std::vector<Picture>& pictures, const std::string& name) {
  for (const Picture& picture : pictures)
    if (picture.file == fmt::format("figures/{}.png", name)) return &picture;
  return nullptr;
}

const std::vector<Picture>& Pictures::of(const std::string& key) const {
  static const std::vector<Picture> none;
  const auto found = sections.find(key);
  return key == figures_key ? figures : found == sections.end() ? none : found->second;
}

Pictures draw(const Run& run, const SceneOfRun& shown, const std::vector<SeriesError>& errors,
              const std::optional<FrameRange>& range, DrawingTools& tools, OutputFolder& folder,
              Stages& stages, const DrawingProgress& progress) {
  Pictures result;
  stages.begin("figures");
  const std::string& title = run.loaded.source.file.name;
  result.figures = draw_figures(figures(run, errors), tools, title, folder);

  const GlContext& context = tools.context;
  const PngTexts texts = picture_texts(context, title);
  result.renderer = context.info().fingerprint();
  result.animation_notes = shown.notes();
  if (shown.motion() == nullptr) {
    stages.end();
    return result;
  }

  stages.begin("frames");
  SceneInput input = shown.input();
  SceneRenderer scene(context, *shown.motion(), input);
  std::vector<std::string> frames;
  const FrameRange asked = range_within(scene.frame_count(), range);
  stream_frames(scene, asked, texts, PngEffort::quick, [&](int k, std::string png) {
    folder.write(fmt::format("frames/{:04}.png", k), png);
    frames.push_back(std::move(png));
    if (progress) progress(static_cast<double>(k + 1 - asked.first) / asked.count());
  });
  result.first_frame = asked.first;
  result.frames = asked.count();
  result.frame_rate = input.spec.frame_rate;

  stages.begin("animation");
  folder.write("animation.png", join_apng(frames, input.spec.frame_rate));
  frames.clear();
  input.spec = page_scene(input.spec);
  SceneRenderer small(context, *shown.motion(), input);
  stream_frames(small, range_within(small.frame_count(), {}), texts, PngEffort::small,
                [&](int, std::string png) { frames.push_back(std::move(png)); });
  result.page_animation = join_apng(frames, input.spec.frame_rate);
  result.page_still = split_apng(result.page_animation, player_file).back();
  folder.write(player_file, result.page_animation);
  result.player_frame_rate = input.spec.frame_rate;
  result.page_animation_width = input.spec.size[0];
  result.page_animation_height = input.spec.size[1];
  stages.end();
  return result;
}

}  // namespace plumb
