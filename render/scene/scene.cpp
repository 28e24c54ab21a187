#include "render/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>

#include "engine/base/errors.h"
#include "engine/model/cable.h"
#include "engine/run/cable_field.h"
#include "render/gl/markup.h"
#include "render/gl/painter.h"
#include "render/gl/shaders.h"
#include "render/image/color_map.h"
#include "render/image/tiles.h"
#include "render/plot/axis_ticks.h"
#include "render/scene/camera_path.h"
#include "render/scene/drawn_cable.h"
#include "render/scene/frame_texts.h"
#include "render/scene/ground.h"
#include "render/scene/scene_camera.h"
#include "render/scene/surroundings.h"
#include "render/scene/theme.h"
#include "render/scene/trail.h"
#include "render/scene/tube.h"
#include "render/scene/visible_curve.h"

namespace plumb {

namespace {

constexpr double trail_frames = 32;     // how many frames ago the trail has faded out, unless told
constexpr int trail_pieces = 8;         // of the trail, a frame
constexpr double support_reach = 5;     // of a support around the cable's end, in its radii
constexpr double point_radius = 2.3;    // of a published point's ball, in the cable's radii
constexpr double end_tolerance = 1e-6;  // of a frame: the last output may be short of it by rounding
constexpr double ghost_opacity = 0.45;  // of the latest ghost; the earliest has a quarter of it
constexpr int most_pixels_a_side = 32768;
constexpr double most_samples_at_once = 1e8;
constexpr int tile_samples =
    4096;  // a side, of a picture that needs tiles: even, as pixels are drawn in fours

constexpr std::array<int, 2> mesh_components = {3, 3};
constexpr std::array<int, 3> field_mesh_components = {3, 3, 1};
constexpr std::array<int, 2> trail_components = {4, 1};

// Decimals that tell the times of frames apart.
int decimals(double interval) {
  int n = 0;
  for (double scaled = interval; n < 6 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled; scaled *= 10)
    ++n;
  return n;
}

const SceneInput& checked(const SceneInput& input) {
  const auto refuse_size = [](double length, double rate) {
    throw OutputError(fmt::format("scene: a cable of {} m at {} frames a second: both must be greater than 0",
                                  length, rate));
  };
  const SceneSpec& spec = input.spec;
  if (!(input.length > 0) || !(spec.frame_rate > 0)) refuse_size(input.length, spec.frame_rate);
  for (const SceneRun& run : input.others) {
    if (!(run.length > 0)) refuse_size(run.length, spec.frame_rate);
    if (run.trajectory == nullptr) throw OutputError("scene: another run has no trajectory");
  }
  if (spec.color_by != ColorField::none && !input.cable)
    throw OutputError("scene: a run that is to be coloured needs its cable");
  if (spec.ghosts < 0 || (spec.ghosts > 0 && !(spec.ghost_interval > 0)))
    throw OutputError(fmt::format("scene: {} ghosts every {} s", spec.ghosts, spec.ghost_interval));
  for (const ScenePoints& points : input.points)
    if (points.times.size() != points.places.size())
      throw OutputError(
          fmt::format("scene: {} points at {} times", points.places.size(), points.times.size()));
  if (std::max(spec.size[0], spec.size[1]) > most_pixels_a_side)
    throw OutputError(fmt::format("a picture of {} x {} pixels: at most {} a side can be drawn", spec.size[0],
                                  spec.size[1], most_pixels_a_side));
  return input;
}

// How large the tiles of a picture may be, pixels a side.
int tile_limit(const GlContext& context, const SceneSpec& spec) {
  const int scale = std::max(1, spec.supersampling);
  const double samples = 1.0 * spec.size[0] * spec.size[1] * scale * scale;
  const int largest = std::max(spec.size[0], spec.size[1]);
  const bool at_once = largest <= context.info().max_size / scale && samples <= most_samples_at_once;
  return at_once ? largest : std::min(tile_samples, context.info().max_size) / scale / 2 * 2;
}

}  // namespace

class SceneRenderer::Drawing {
 public:
  Drawing(const GlContext& context, const Trajectory& trajectory, const SceneInput& input, int largest_tile)
      : context_(context),
        input_(checked(input)),
        theme_(theme(input.spec.theme)),
        width_(input.spec.size[0]),
        height_(input.spec.size[1]),
        cables_(make_cables(trajectory)),
        tiles_(tiles_of(width_, height_, largest_tile > 0 ? largest_tile : tile_limit(context, input.spec))),
        canvas_(context, tiles_.front().width, tiles_.front().height, input.spec.supersampling),
        surroundings_(
            make_surroundings(places(), input.length, main().radius(), input.gravity, is_side_by_side())),
        painter_(context),
        background_(context, fullscreen_vert, background_frag),
        ground_(context, surroundings_, main().radius(), input.length, canvas_.layer_scale(), theme_.grid,
                theme_.shadow),
        tube_(context, tube_vert, tube_frag),
        trail_(context, trail_vert, trail_frag),
        mesh_(context, mesh_components),
        field_mesh_(context, field_mesh_components),
        ball_mesh_(context, mesh_components),
        trail_ribbon_(context, trail_components),
        no_attributes_(context),
        map_(context) {
    make_labels();
    path_.emplace(input_.spec, surroundings_, main().motion(), main().radius(),
                  static_cast<double>(width_) / height_, margins_beside(texts_, width_, height_));
    choose_sides();
    for (DrawnCable& cable : cables_) cable.keep_trail(1 / (input_.spec.frame_rate * trail_pieces));
    set_constants();
    look(0);
    if (is_still()) {
      draw_backdrop(tiles_.front());
      canvas_.keep();
    }
  }

  const SceneSpec& spec() const { return input_.spec; }
  const Motion& motion() const { return main().motion(); }
  Camera camera_at(double time) const {
    return {path_->at(time), width_, height_, surroundings_.center, surroundings_.radius};
  }

  void draw(double time, Image& picture) {
    context_.make_current();
    if (path_->moves()) look(time);
    texts_.time = input_.in_place_of_time.empty()
                      ? fmt::format("t = {:.{}f} s", time, decimals(1 / spec().frame_rate))
                      : input_.in_place_of_time;
    Layers layers = prepare(time);
    ground_.cast_shadow(layers.shadows);
    const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    picture.width = width_;
    picture.height = height_;
    picture.rgb.resize(3 * pixels);
    picture.alpha.resize(spec().background == SceneBackground::transparent ? pixels : 0);
    for (const Tile& tile : tiles_) {
      draw_tile(tile, layers);
      canvas_.read_into(picture);
    }
  }

 private:
  // A mesh and what it is drawn with.
  struct Part {
    TubeMesh mesh;
    VertexBuffer* buffer;
    Color color;
    bool colored = false;
  };
  // What is laid over the picture at once.
  struct Layer {
    Rect region;
    double opacity = 1;
    std::vector<Part> parts;
    std::vector<std::pair<std::vector<float>, Color>> trails;
  };
  struct Layers {
    std::vector<std::vector<CurvePoint>> shadows;
    std::vector<Layer> layers;
  };

  const DrawnCable& main() const { return cables_.front(); }

  std::deque<DrawnCable> make_cables(const Trajectory& trajectory) const {
    std::deque<DrawnCable> cables;
    const auto add = [&](const SceneRun& run) {
      cables.emplace_back(run, drawn_radius(spec(), run.length, run.radius), spec().color_by);
    };
    add({&trajectory,
         input_.length,
         input_.radius,
         input_.supports,
         input_.label,
         {},
         {0, 0, 0},
         input_.cable});
    for (const SceneRun& run : input_.others) add(run);
    return cables;
  }

  bool is_side_by_side() const {
    return std::any_of(input_.others.begin(), input_.others.end(),
                       [](const SceneRun& run) { return !run.offset.isZero(); });
  }

  // All that is to be seen.
  std::vector<Vec3> places() const {
    std::vector<Vec3> all;
    for (const DrawnCable& cable : cables_) {
      const std::vector<Vec3> covered = covered_places(cable.motion());
      all.insert(all.end(), covered.begin(), covered.end());
    }
    for (const ScenePoints& points : input_.points)
      all.insert(all.end(), points.places.begin(), points.places.end());
    for (const Vec3& place : all)
      if (!place.allFinite()) throw OutputError("scene: a point is not finite");
    return all;
  }

  // The run's own colour, the k-th other's, and after these that of the points.
  Color color_of(std::size_t k) const {
    if (k == 0) return theme_.cable;
    const std::size_t other = k - 1;
    if (other < input_.others.size() && input_.others[other].color) return *input_.others[other].color;
    const std::size_t series = other - input_.others.size();
    if (other >= input_.others.size() && input_.points[series].color) return *input_.points[series].color;
    return theme_.series[other % theme_.series.size()];
  }

  Color trail_color(std::size_t k) const { return cables_.size() == 1 ? theme_.trail : color_of(k); }

  void make_labels() {
    texts_.title = literal(input_.title);
    texts_.ink = theme_.ink;
    texts_.quiet_ink = theme_.quiet_ink;
    const bool colored = spec().color_by != ColorField::none;
    if (!input_.label.empty() && !input_.others.empty() && !colored)
      texts_.labels.push_back({input_.label, color_of(0)});
    for (std::size_t k = 0; k < input_.others.size(); ++k)
      if (!input_.others[k].label.empty() && !(colored && input_.others[k].cable))
        texts_.labels.push_back({input_.others[k].label, color_of(k + 1)});
    for (std::size_t k = 0; k < input_.points.size(); ++k)
      if (!input_.points[k].label.empty())
        texts_.labels.push_back(
            {input_.points[k].label, color_of(1 + input_.others.size() + k), Marker::circle});
    if (!colored) return;
    FieldRange range = main().field_range();
    for (const DrawnCable& cable : cables_) {
      const FieldRange other = cable.field_range();
      range = {std::min(range.lo, other.lo), std::max(range.hi, other.hi)};
    }
    if (!std::isfinite(range.lo) || !std::isfinite(range.hi))
      throw OutputError(fmt::format("scene: the {} is not finite", plumb::title(spec().color_by)));
    const AxisRange drawable = fitted_range(range.lo, range.hi, 0);
    range_ = {drawable.lo, drawable.hi};
    texts_.bar = ColorBar{std::string(plumb::title(spec().color_by)), std::string(unit(spec().color_by)),
                          range_.lo, range_.hi};
  }

  // What surrounds the cable is the same in all frames, and drawn at once.
  bool is_still() const { return !path_->moves() && tiles_.size() == 1; }

  // As many sides as it takes for none to show: a polygon around a circle of r pixels is inside it by
  // r (1 - cos(π/n)), which is kept to a twelfth of a pixel.
  void choose_sides() {
    double pixels = 0;
    for (const DrawnCable& cable : cables_) {
      const Motion& motion = cable.motion();
      for (std::size_t i = 0; i < motion.output_count();
           i += std::max<std::size_t>(1, motion.output_count() / 64)) {
        const Camera camera = camera_at(motion.output_time(i));
        for (const CurvePoint& point : visible_curve(motion, motion.output(i), camera, 1)) {
          const double seen = cable.radius() * camera.pixels_per_metre(point.position);
          if (std::isfinite(seen)) pixels = std::max(pixels, seen);
        }
      }
    }
    const double sides = std::numbers::pi / std::sqrt(2 * 0.08 / std::max(pixels, 1.0));
    sides_ = static_cast<int>(std::clamp(std::ceil(sides / 4) * 4, 12.0, 64.0));
  }

  static void set3(const GlProgram& program, const char* name, const Vec3& v) {
    program.set(name, static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()));
  }

  void set_constants() {
    background_.use();
    background_.set("height", static_cast<float>(height_ * canvas_.layer_scale()));
    background_.set("below", theme_.below);
    tube_.use();
    set3(tube_, "up", surroundings_.up);
    if (spec().color_by != ColorField::none) make_map();
  }

  void make_map() {
    constexpr int entries = 256;
    std::vector<std::uint8_t> colors;
    for (int k = 0; k < entries; ++k) {
      const Color color = map_color(k / (entries - 1.0));
      for (const float channel : {color.r, color.g, color.b, 1.0F})
        colors.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
    }
    const Gl& gl = context_.gl();
    gl.BindTexture(GL_TEXTURE_2D, map_.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, entries, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }

  // Where the camera stands at a time.
  void look(double time) {
    const CameraSpec place = path_->at(time);
    camera_.emplace(place, width_, height_, surroundings_.center, surroundings_.radius);
    // True at the depth of the camera's target, as everything nearer looks larger.
    texts_.pixels_per_metre = camera_->pixels_per_metre(place.target);
    ground_.look(*camera_);
    tube_.use();
    const Eigen::Matrix4f matrix = camera_->matrix().cast<float>();
    tube_.set_matrix("view", matrix.data());
    const Eigen::Vector3f eye = (camera_->is_parallel() ? camera_->back() : camera_->eye()).cast<float>();
    tube_.set("eye", Color{eye.x(), eye.y(), eye.z(), camera_->is_parallel() ? 0.0F : 1.0F});
    set3(tube_, "light",
         (1.1 * surroundings_.up - 0.55 * camera_->right() + 0.7 * camera_->back()).normalized());
    // Seen from straight above or below, the ground is all that there is behind.
    background_.use();
    background_.set("above",
                    std::abs(camera_->back().dot(surroundings_.up)) > 0.9 ? theme_.below : theme_.above);
  }

  // What is behind all cables.
  void draw_backdrop(const Tile& tile) {
    canvas_.place_at(tile.left, tile.top);
    const Color transform = tile_transform(tile, width_, height_);
    ground_.set_tile(transform);
    tube_.use();
    tube_.set("tile", transform);
    trail_.use();
    trail_.set("tile", transform);
    background_.use();
    background_.set("bottom", static_cast<float>((height_ - tile.top - tile.height) * canvas_.layer_scale()));
    const Gl& gl = context_.gl();
    if (spec().background != SceneBackground::scene) {
      canvas_.begin_flat(spec().background == SceneBackground::plain ? theme_.plain : Color{0, 0, 0, 0});
      return;
    }
    canvas_.begin_flat(Color{});
    canvas_.begin_geometry(canvas_.whole());
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(no_attributes_.id());
    background_.use();
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    ground_.draw_grid();
    canvas_.resolve();
    if (!ground_.is_seen()) draw_ground_line();
  }

  // The ground seen edge on.
  void draw_ground_line() {
    painter_.begin(canvas_);
    const double y = std::round(camera_->pixel(surroundings_.origin).y());
    painter_.fill({0, y, 1.0 * width_, y + std::max(1.0, std::round(height_ / 360.0))}, theme_.grid);
  }

  void draw_tile(const Tile& tile, Layers& layers) {
    if (is_still())
      canvas_.restore();
    else
      draw_backdrop(tile);
    ground_.draw_shadow(canvas_);
    for (Layer& layer : layers.layers) draw_layer(layer);
    painter_.begin(canvas_);
    draw_texts(painter_, texts_, width_, height_);
  }

  void draw_layer(Layer& layer) {
    if (!canvas_.begin_geometry(layer.region)) return;
    const Gl& gl = context_.gl();
    for (const Part& part : layer.parts) draw_part(part);
    gl.DepthMask(GL_FALSE);
    trail_.use();
    for (const auto& [ribbon, color] : layer.trails) {
      trail_.set("ink", color);
      trail_ribbon_.upload(ribbon);
      gl.DrawArrays(GL_TRIANGLES, 0, trail_ribbon_.count());
    }
    gl.DepthMask(GL_TRUE);
    canvas_.resolve(layer.opacity);
  }

  void draw_part(const Part& part) {
    const Gl& gl = context_.gl();
    tube_.use();
    tube_.set("color", part.color);
    tube_.set("colored", part.colored ? 1 : 0);
    if (part.colored) {
      gl.ActiveTexture(GL_TEXTURE0);
      gl.BindTexture(GL_TEXTURE_2D, map_.id());
    }
    part.buffer->upload(part.mesh.vertices);
    if (part.buffer->index_count() != static_cast<int>(part.mesh.indices.size()))
      part.buffer->upload_indices(part.mesh.indices);
    gl.DrawElements(GL_TRIANGLES, part.buffer->index_count(), GL_UNSIGNED_INT, nullptr);
  }

  // All that is drawn of a time, but for the texts.
  Layers prepare(double time) {
    Layers result;
    for (int k = spec().ghosts; k > 0; --k) {
      const double earlier = time - k * spec().ghost_interval;
      if (earlier < 0) continue;
      Layer& ghost = result.layers.emplace_back();
      ghost.region = nothing();
      ghost.opacity = ghost_opacity * (0.25 + 0.75 * (1 - (k - 1.0) / spec().ghosts));
      for (std::size_t i = 0; i < cables_.size(); ++i) {
        const State state = cables_[i].motion().at(earlier);
        const std::vector<CurvePoint> curve = cables_[i].curve(state, *camera_);
        add_cable(ghost, i, curve, state);
      }
      limit(ghost);
    }
    Layer& now = result.layers.emplace_back();
    now.region = nothing();
    const double trail = spec().trail.value_or(trail_frames / spec().frame_rate);
    for (std::size_t i = 0; i < cables_.size(); ++i) {
      const DrawnCable& cable = cables_[i];
      const State state = cable.motion().at(time);
      std::vector<CurvePoint> curve = cable.curve(state, *camera_);
      add_cable(now, i, curve, state);
      add_support(now, cable, cable.supports().first, curve.front());
      add_support(now, cable, cable.supports().last, curve.back());
      if (trail > 0) add_trail(now, i, cable.trail(time - trail, time, state));
      result.shadows.push_back(std::move(curve));
    }
    for (std::size_t k = 0; k < input_.points.size(); ++k) add_points(now, k, time, trail);
    limit(now);
    return result;
  }

  // A region without anything in it.
  Rect nothing() const { return {1.0 * width_, 1.0 * height_, 0, 0}; }

  // Where nothing can be told of what is in the picture, all of it is drawn.
  void limit(Layer& layer) const {
    if (!std::isfinite(layer.region.left)) layer.region = {0, 0, 1.0 * width_, 1.0 * height_};
  }

  // Widens a layer's region by a place and some pixels around it.
  void widen(Layer& layer, const Vec3& place, double around) const {
    const Point p = camera_->pixel(place);
    Rect& region = layer.region;
    if (!p.allFinite() || !std::isfinite(region.left)) {
      region.left = -std::numeric_limits<double>::infinity();  // some of it is behind the camera
      return;
    }
    region.left = std::min(region.left, p.x() - around);
    region.right = std::max(region.right, p.x() + around);
    region.top = std::min(region.top, p.y() - around);
    region.bottom = std::max(region.bottom, p.y() + around);
  }

  void add_cable(Layer& layer, std::size_t i, const std::vector<CurvePoint>& curve, const State& state) {
    const DrawnCable& cable = cables_[i];
    // A ball seen from near by looks larger than its radius at its middle's distance: twice is ample.
    for (const CurvePoint& point : curve)
      widen(layer, point.position,
            2 + 2 * support_reach * cable.radius() * camera_->pixels_per_metre(point.position));
    const std::vector<float> levels = cable.levels(curve, state, range_);
    layer.parts.push_back({tube_mesh(curve, cable.radius(), sides_, levels),
                           levels.empty() ? &mesh_ : &field_mesh_, color_of(i), !levels.empty()});
  }

  // A ball for a joint, a sleeve for what holds the direction too.
  void add_support(Layer& layer, const DrawnCable& cable, Support support, const CurvePoint& end) {
    const Hold hold = hold_of(support);
    if (hold.none()) return;
    std::vector<CurvePoint> core = {end};
    double radius = 2.1 * cable.radius();
    if (hold.direction) {
      radius = 1.9 * cable.radius();
      core = {{end.position - 3 * cable.radius() * end.tangent, end.tangent},
              {end.position + 3 * cable.radius() * end.tangent, end.tangent}};
    }
    layer.parts.push_back({tube_mesh(core, radius, 2 * sides_), &ball_mesh_, theme_.support});
  }

  double trail_width() const { return std::max(1.6, height_ / 190.0); }

  void add_trail(Layer& layer, std::size_t i, const std::vector<Vec3>& places) {
    for (const Vec3& place : places) widen(layer, place, 2 + trail_width());
    if (places.size() < 2) return;
    layer.trails.emplace_back(trail_ribbon(places, *camera_, trail_width(), width_, height_), trail_color(i));
  }

  // Those of the trail's time, or where there is none the latest; all but the latest are smaller.
  void add_points(Layer& layer, std::size_t k, double time, double trail) {
    const ScenePoints& points = input_.points[k];
    const auto end = std::upper_bound(points.times.begin(), points.times.end(), time + 1e-9);
    const auto count = static_cast<std::size_t>(end - points.times.begin());
    for (std::size_t i = 0; i < count; ++i) {
      const bool latest = i + 1 == count;
      if (!latest && points.times[i] < time - trail) continue;
      const double radius = (latest ? 1.0 : 0.7) * point_radius * main().radius();
      widen(layer, points.places[i], 2 + 2 * radius * camera_->pixels_per_metre(points.places[i]));
      layer.parts.push_back(
          {tube_mesh(std::vector<CurvePoint>{{points.places[i], surroundings_.up}}, radius, sides_),
           &ball_mesh_, color_of(1 + input_.others.size() + k)});
    }
  }

  const GlContext& context_;
  SceneInput input_;
  const Theme& theme_;
  int width_;
  int height_;
  std::deque<DrawnCable> cables_;  // the run, and others
  std::vector<Tile> tiles_;
  Canvas canvas_;
  Surroundings surroundings_;
  FrameTexts texts_;
  std::optional<CameraPath> path_;
  std::optional<Camera> camera_;  // of the frame that is drawn
  Painter painter_;
  GlProgram background_;
  Ground ground_;
  GlProgram tube_;
  GlProgram trail_;
  VertexBuffer mesh_;
  VertexBuffer field_mesh_;
  VertexBuffer ball_mesh_;
  VertexBuffer trail_ribbon_;
  GlVertexArray no_attributes_;
  GlTexture map_;
  FieldRange range_;
  int sides_ = 0;
};

SceneInput scene_input(const Case& the_case) {
  SceneInput input{
      the_case.scene,    the_case.cable.length,  std::sqrt(the_case.cable.area / std::numbers::pi),
      the_case.supports, the_case.loads.gravity, the_case.title};
  if (the_case.scene.color_by != ColorField::none) input.cable = std::make_shared<Cable>(the_case);
  return input;
}

SceneRun scene_run(const Case& the_case, const Trajectory& trajectory, std::string label) {
  return {&trajectory,
          the_case.cable.length,
          std::sqrt(the_case.cable.area / std::numbers::pi),
          the_case.supports,
          std::move(label),
          {},
          {0, 0, 0},
          std::make_shared<Cable>(the_case)};
}

SceneRenderer::SceneRenderer(const GlContext& context, const Trajectory& trajectory, const SceneInput& input,
                             int largest_tile)
    : drawing_(std::make_unique<Drawing>(context, trajectory, input, largest_tile)) {}

SceneRenderer::~SceneRenderer() = default;

int frame_count(double end, double frame_rate) {
  constexpr double most = 1e9;  // what an int holds
  return 1 + static_cast<int>(std::min(most, std::floor(end * frame_rate + end_tolerance)));
}

int SceneRenderer::frame_count() const {
  return plumb::frame_count(drawing_->motion().end(), drawing_->spec().frame_rate);
}

double SceneRenderer::frame_time(int k) const {
  return std::min(k / drawing_->spec().frame_rate, drawing_->motion().end());
}

Image SceneRenderer::frame(int k) {
  return at(frame_time(k));
}

void SceneRenderer::frame(int k, Image& picture) {
  drawing_->draw(frame_time(k), picture);
}

Image SceneRenderer::at(double time) {
  Image picture;
  drawing_->draw(std::clamp(time, 0.0, drawing_->motion().end()), picture);
  return picture;
}

Point SceneRenderer::pixel(const Vec3& place, double time) const {
  return drawing_->camera_at(time).pixel(place);
}

}  // namespace plumb
