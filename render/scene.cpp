#include "render/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/errors.h"
#include "render/axis_ticks.h"
#include "render/ground.h"
#include "render/painter.h"
#include "render/shaders.h"
#include "render/stage.h"
#include "render/trail.h"
#include "render/tube.h"
#include "render/visible_curve.h"

namespace plumb {

namespace {

constexpr Color cable_color = Color::hex(0x1F6FB2);
constexpr Color support_color = Color::hex(0x4A515B);
constexpr Color trail_color = Color::hex(0xD55E00);
constexpr Color ink = Color::hex(0x2B3038);
constexpr Color quiet_ink = Color::hex(0x5A626E);

constexpr double curve_tolerance = 0.25;  // of the drawn centre line, pixels
constexpr double trail_frames = 32;       // how many frames ago the trail has faded out
constexpr int trail_pieces = 8;           // of the trail, a frame
constexpr double thinnest = 1.0 / 150;    // radius as drawn, in cable lengths
constexpr double support_reach = 5;       // of a support around the cable's end, in its radii
constexpr double end_tolerance = 1e-6;    // of a frame: the last output may be short of it by rounding

constexpr std::array<int, 2> mesh_components = {3, 3};
constexpr std::array<int, 2> trail_components = {4, 1};

double drawn_radius(const SceneInput& input) {
  if (input.spec.cable_radius > 0) return input.spec.cable_radius;
  return std::max(input.radius, thinnest * input.length);
}

// Decimals that tell the times of frames apart.
int decimals(double interval) {
  int n = 0;
  for (double scaled = interval; n < 6 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled; scaled *= 10)
    ++n;
  return n;
}

const SceneInput& checked(const SceneInput& input) {
  if (!(input.length > 0) || !(input.spec.frame_rate > 0))
    throw OutputError(fmt::format("scene: a cable of {} m at {} frames a second: both must be greater than 0",
                                  input.length, input.spec.frame_rate));
  return input;
}

}  // namespace

class SceneRenderer::Drawing {
 public:
  Drawing(const GlContext& context, const Trajectory& trajectory, const SceneInput& input)
      : context_(context),
        input_(checked(input)),
        motion_(trajectory),
        radius_(drawn_radius(input)),
        canvas_(context, input.spec.size[0], input.spec.size[1], input.spec.supersampling),
        stage_(make_stage(motion_, input.length, radius_, input.gravity, input.spec.camera,
                          static_cast<double>(canvas_.width()) / canvas_.height())),
        camera_(stage_.camera, canvas_.width(), canvas_.height(), stage_.center, stage_.radius),
        painter_(context),
        background_(context, fullscreen_vert, background_frag),
        ground_(context, stage_, camera_, radius_, input.length, canvas_.layer_scale()),
        tube_(context, tube_vert, tube_frag),
        trail_(context, trail_vert, trail_frag),
        mesh_(context, mesh_components),
        support_mesh_(context, mesh_components),
        trail_ribbon_(context, trail_components),
        no_attributes_(context) {
    choose_sides();
    make_trail();
    set_constants();
    make_backdrop();
  }

  const SceneSpec& spec() const { return input_.spec; }
  const Motion& motion() const { return motion_; }
  const Camera& camera() const { return camera_; }

  Image draw(double time) {
    context_.make_current();
    const Eigen::VectorXd state = motion_.state(time);
    const std::vector<CurvePoint> curve = visible_curve(motion_, state, camera_, curve_tolerance);
    const std::vector<Vec3> trail = trail_places(time);
    ground_.cast_shadow(curve);
    canvas_.restore();
    ground_.draw_shadow(canvas_.height());
    canvas_.begin_geometry(region(curve, trail));
    draw_cable(curve);
    draw_supports(curve);
    draw_trail(trail);
    canvas_.resolve();
    draw_texts(time);
    return canvas_.read();
  }

 private:
  // As many sides as it takes for none to show: a polygon around a circle of r pixels is inside it by
  // r (1 - cos(π/n)), which is kept to a twelfth of a pixel.
  void choose_sides() {
    double pixels = 0;
    for (std::size_t i = 0; i < motion_.output_count();
         i += std::max<std::size_t>(1, motion_.output_count() / 64))
      for (const CurvePoint& point : visible_curve(motion_, motion_.output(i), camera_, 1)) {
        const double seen = radius_ * camera_.pixels_per_metre(point.position);
        if (std::isfinite(seen)) pixels = std::max(pixels, seen);
      }
    const double sides = std::numbers::pi / std::sqrt(2 * 0.08 / std::max(pixels, 1.0));
    sides_ = static_cast<int>(std::clamp(std::ceil(sides / 4) * 4, 12.0, 64.0));
  }

  // The tip's way through the whole run, so that a frame only takes its stretch of it.
  void make_trail() {
    trail_interval_ = 1 / (input_.spec.frame_rate * trail_pieces);
    const double count = std::min(std::floor(motion_.end() / trail_interval_), 1e6);
    for (double k = 0; k <= count; k += 1)
      tip_path_.push_back(motion_.tip(motion_.state(k * trail_interval_)));
  }

  void set_constants() {
    const Eigen::Matrix4f matrix = camera_.matrix().cast<float>();
    const auto set3 = [](const GlProgram& program, const char* name, const Vec3& v) {
      program.set(name, static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()));
    };
    background_.use();
    background_.set("height", static_cast<float>(canvas_.height() * canvas_.layer_scale()));
    tube_.use();
    tube_.set_matrix("view", matrix.data());
    set3(tube_, "eye", camera_.eye());
    set3(tube_, "up", stage_.up);
    set3(tube_, "light", (1.1 * stage_.up - 0.55 * camera_.right() + 0.7 * camera_.back()).normalized());
    trail_.use();
    trail_.set("ink", trail_color);
  }

  // What no frame changes: background and grid.
  void make_backdrop() {
    const Gl& gl = context_.gl();
    canvas_.begin_flat(Color{});
    canvas_.begin_geometry(canvas_.whole());
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(no_attributes_.id());
    background_.use();
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    ground_.draw_grid();
    canvas_.resolve();
    canvas_.keep();
  }

  // Where cable, supports and trail are in the picture; all of it when some of them is behind the camera.
  Rect region(const std::vector<CurvePoint>& curve, const std::vector<Vec3>& trail) const {
    Rect rect = canvas_.whole();
    std::swap(rect.left, rect.right);
    std::swap(rect.top, rect.bottom);
    bool visible = true;
    const auto add = [&](const Vec3& place, double around) {
      const Point p = camera_.pixel(place);
      visible = visible && p.allFinite();
      rect.left = std::min(rect.left, p.x() - around);
      rect.right = std::max(rect.right, p.x() + around);
      rect.top = std::min(rect.top, p.y() - around);
      rect.bottom = std::max(rect.bottom, p.y() + around);
    };
    // A ball seen from near by looks larger than its radius at its middle's distance: twice is ample.
    for (const CurvePoint& point : curve)
      add(point.position, 2 + 2 * support_reach * radius_ * camera_.pixels_per_metre(point.position));
    for (const Vec3& place : trail) add(place, 2 + trail_width());
    return visible ? rect : canvas_.whole();
  }

  void draw_mesh(VertexBuffer& buffer, const TubeMesh& mesh, Color color) {
    tube_.use();
    tube_.set("color", color);
    buffer.upload(mesh.vertices);
    if (buffer.index_count() != static_cast<int>(mesh.indices.size())) buffer.upload_indices(mesh.indices);
    context_.gl().DrawElements(GL_TRIANGLES, buffer.index_count(), GL_UNSIGNED_INT, nullptr);
  }

  void draw_cable(const std::vector<CurvePoint>& curve) {
    draw_mesh(mesh_, tube_mesh(curve, radius_, sides_), cable_color);
  }

  void draw_supports(const std::vector<CurvePoint>& curve) {
    draw_support(input_.supports.first, curve.front());
    draw_support(input_.supports.last, curve.back());
  }

  // A ball for a joint, a sleeve for a clamp.
  void draw_support(Support support, const CurvePoint& end) {
    if (support == Support::free) return;
    std::vector<CurvePoint> core = {end};
    double radius = 2.1 * radius_;
    if (support == Support::clamped) {
      radius = 1.9 * radius_;
      core = {{end.position - 3 * radius_ * end.tangent, end.tangent},
              {end.position + 3 * radius_ * end.tangent, end.tangent}};
    }
    draw_mesh(support_mesh_, tube_mesh(core, radius, 2 * sides_), support_color);
  }

  double trail_width() const { return std::max(1.6, canvas_.height() / 190.0); }

  // From the oldest that is still seen to the tip.
  std::vector<Vec3> trail_places(double time) const {
    const double oldest = time - trail_frames / input_.spec.frame_rate;
    std::vector<Vec3> places;
    const auto count = static_cast<double>(tip_path_.size());
    for (double k = std::max(0.0, std::ceil(oldest / trail_interval_));
         k < count && k * trail_interval_ < time; k += 1)
      places.push_back(tip_path_[static_cast<std::size_t>(k)]);
    places.push_back(motion_.tip(motion_.state(time)));
    return places;
  }

  void draw_trail(const std::vector<Vec3>& places) {
    if (places.size() < 2) return;
    trail_ribbon_.upload(trail_ribbon(places, camera_, trail_width(), canvas_.width(), canvas_.height()));
    const Gl& gl = context_.gl();
    gl.DepthMask(GL_FALSE);
    trail_.use();
    gl.DrawArrays(GL_TRIANGLES, 0, trail_ribbon_.count());
    gl.DepthMask(GL_TRUE);
  }

  void draw_texts(double time) {
    const double height = canvas_.height();
    const double width = canvas_.width();
    if (width < 200 || height < 120) return;  // no room that would be legible
    painter_.begin(canvas_);
    const double size = std::max(11.0, height / 27);
    const double margin = 1.1 * size;
    const double base = height - margin;
    painter_.text(fmt::format("t = {:.{}f} s", time, decimals(1 / input_.spec.frame_rate)), {size}, margin,
                  base, Align::left, ink);

    TextStyle title{1.05 * size, Weight::bold};
    const double wide = painter_.font().measure(input_.title, title).width;
    title.size *= std::min(1.0, (width - 2 * margin) / std::max(wide, 1.0));
    painter_.text(input_.title, title, margin, margin + 0.75 * title.size, Align::left, ink);

    // True at the depth of the camera's target, as everything nearer looks larger.
    const double scale = camera_.pixels_per_metre(stage_.camera.target);
    const double metres = round_step(0.08 * width / scale);
    const double length = std::round(metres * scale);
    const double right = std::round(width - margin);
    const double thick = std::max(2.0, std::round(size / 10));
    const double tick = std::round(size / 3);
    const double bar = std::round(base - 0.3 * size);
    painter_.fill({right - length, bar, right, bar + thick}, quiet_ink);
    painter_.fill({right - length, bar - tick, right - length + thick, bar}, quiet_ink);
    painter_.fill({right - thick, bar - tick, right, bar}, quiet_ink);
    painter_.text(fmt::format("{:g} m", metres), {0.85 * size}, right - length / 2, bar - tick - 0.2 * size,
                  Align::center, quiet_ink);
  }

  const GlContext& context_;
  SceneInput input_;
  Motion motion_;
  double radius_;
  Canvas canvas_;
  Stage stage_;
  Camera camera_;
  Painter painter_;
  GlProgram background_;
  Ground ground_;
  GlProgram tube_;
  GlProgram trail_;
  VertexBuffer mesh_;
  VertexBuffer support_mesh_;
  VertexBuffer trail_ribbon_;
  GlVertexArray no_attributes_;
  int sides_ = 0;
  double trail_interval_ = 0;  // s
  std::vector<Vec3> tip_path_;
};

SceneInput scene_input(const Case& the_case) {
  return {the_case.scene,    the_case.cable.length,  std::sqrt(the_case.cable.area / std::numbers::pi),
          the_case.supports, the_case.loads.gravity, the_case.title};
}

SceneRenderer::SceneRenderer(const GlContext& context, const Trajectory& trajectory, const SceneInput& input)
    : drawing_(std::make_unique<Drawing>(context, trajectory, input)) {}

SceneRenderer::~SceneRenderer() = default;

int SceneRenderer::frame_count() const {
  constexpr double most = 1e9;  // what an int holds
  return 1 + static_cast<int>(std::min(
                 most, std::floor(drawing_->motion().end() * drawing_->spec().frame_rate + end_tolerance)));
}

double SceneRenderer::frame_time(int k) const {
  return std::min(k / drawing_->spec().frame_rate, drawing_->motion().end());
}

Image SceneRenderer::frame(int k) {
  return at(frame_time(k));
}

Image SceneRenderer::at(double time) {
  return drawing_->draw(std::clamp(time, 0.0, drawing_->motion().end()));
}

Point SceneRenderer::pixel(const Vec3& place) const {
  return drawing_->camera().pixel(place);
}

}  // namespace plumb
