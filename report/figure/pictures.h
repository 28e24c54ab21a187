#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/run/output_folder.h"
#include "render/gl/gl_context.h"
#include "render/image/png.h"
#include "render/plot/plot_renderer.h"
#include "render/scene/frame_stream.h"
#include "report/base/stages.h"
#include "report/figure/figures.h"
#include "report/figure/scene_of_run.h"

namespace plumb {

/// A drawn figure.
struct Picture {
  std::string file;  ///< "figures/mid_height.png"
  std::string title;
  std::string alt;
  bool tall = false;  ///< higher than wide
  std::string png;
  Plot plot = {};                      ///< what was drawn; of a picture read from a file, nothing
  std::vector<PanelTimes> times = {};  ///< as in Figure
  std::string page_png = {};           ///< for a page, in few colours; empty: `png` itself
  std::string dark_png = {};           ///< the same on dark paper; empty: there is none
};

/// The key in results.json of the figures of a run; those of its sections have keys that end likewise.
inline constexpr const char* figures_key = "figures";

/// The picture of that name among those drawn, or nullptr.
const Picture* find_picture(const std::vector<Picture>& pictures, const std::string& name);

/// What was drawn of a run, as the page needs it.
struct Pictures {
  std::vector<Picture> figures;
  std::map<std::string, std::vector<Picture>> sections;  ///< of its sections, by their key in results.json
  int first_frame = 0;
  int frames = 0;
  double frame_rate = 0;          ///< 1/s
  double player_frame_rate = 0;   ///< of the animation of the page, 1/s
  int page_animation_width = 0;   ///< pixels
  int page_animation_height = 0;  ///< pixels
  std::string page_animation;     ///< animated PNG small enough for the page
  std::string page_still;         ///< its last frame, for paper
  std::string renderer;           ///< GlInfo::fingerprint() of what drew them
  /// What external runs are drawn through, or why there is no animation; a sentence each.
  std::vector<std::string> animation_notes = {};

  bool animated() const { return frames > 0; }
  /// Those of a key in results.json; none where there is no such key.
  const std::vector<Picture>& of(const std::string& key) const;
};

/// What every picture file says of itself: program, title, and what drew it.
PngTexts picture_texts(const GlContext& context, const std::string& title);

/// What figures are drawn with. To make it ready, and the first figure with it, takes longer than drawing
/// several more: one serves for all pictures of a report.
struct DrawingTools {
  GlContext context = GlContext();
  PlotRenderer plots = PlotRenderer(context);
};

/// Draws figures, with `title` in each picture file. Throws OutputError when drawing fails, Interrupted when
/// the user stops it.
std::vector<Picture> drawn_figures(const std::vector<Figure>& figures, DrawingTools& tools,
                                   const std::string& title);

/// Draws figures into a folder: figures/*.png, and their series as numbers, figures/*.csv; with what a page
/// shows of them, unless they are on none. Throws OutputError when drawing or writing fails, Interrupted when
/// the user stops it.
std::vector<Picture> draw_figures(const std::vector<Figure>& figures, DrawingTools& tools,
                                  const std::string& title, OutputFolder& folder, bool for_page = true);

/// Draws figures as draw_figures does, and for a page on light and on dark paper in few colours: those that
/// there is room for have both.
std::vector<Picture> draw_for_page(const std::vector<Figure>& figures, DrawingTools& tools,
                                   const std::string& title, OutputFolder& folder);

/// Called now and then with the share done, 0 to 1.
using DrawingProgress = std::function<void(double)>;

/// The frames that were asked for, of so many; all without a range. Throws UsageError where one of them is
/// not there.
FrameRange range_within(int frames, const std::optional<FrameRange>& asked);

/// The animation of the page, small enough to lie in it.
inline constexpr const char* player_file = "player.png";

/// Draws the figures, frames and animation of a run into a folder: figures/*.png, frames/*.png,
/// animation.png and player.png; of an external run that does not tell enough, figures alone. `scene` is what
/// the frames show. Throws OutputError when drawing or writing fails, Interrupted when the user stops it.
Pictures draw(const Run& run, const SceneOfRun& scene, const std::vector<SeriesError>& errors,
              const std::optional<FrameRange>& range, DrawingTools& tools, OutputFolder& folder,
              Stages& stages, const DrawingProgress& progress = {});

}  // namespace plumb
