#include "render/scene/ground.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/gl/shaders.h"

namespace plumb {

namespace {

constexpr int shadow_size = 512;  // texels a side
constexpr std::array<int, 2> piece_components = {4, 3};

void set3(const GlProgram& program, const char* name, const Vec3& v) {
  program.set(name, static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()));
}

}  // namespace

Ground::Ground(const GlContext& context, const Surroundings& surroundings, double cable_radius, double length,
               double line_width, Color grid, Color shadow)
    : context_(context.make_current()),
      surroundings_(surroundings),
      cable_radius_(cable_radius),
      shadow_reach_(1.15 * std::max(surroundings.reach, 0.05 * length) + 10 * cable_radius),
      grid_(context, ground_vert, ground_frag),
      shadow_(context, ground_vert, ground_shadow_frag),
      shadow_map_piece_(context, shadow_vert, shadow_frag),
      pieces_(context, piece_components, VertexBuffer::Step::instance),
      no_attributes_(context),
      shadow_map_(context),
      shadow_framebuffer_(context) {
  const Eigen::Vector2f middle = surroundings.middle.cast<float>();
  for (const GlProgram* program : {&grid_, &shadow_}) {
    program->use();
    set3(*program, "origin", surroundings.origin);
    set3(*program, "across", surroundings.across);
    set3(*program, "forward", surroundings.forward);
    program->set("middle", middle.x(), middle.y());
    program->set("radius",
                 static_cast<float>(program == &grid_ ? surroundings.ground_radius : shadow_reach_));
    program->set("ink", program == &grid_ ? grid : shadow);
  }
  grid_.use();
  grid_.set("grid", static_cast<float>(surroundings.grid));
  grid_.set("line_width", static_cast<float>(line_width));
  shadow_map_piece_.use();
  shadow_map_piece_.set("middle", middle.x(), middle.y());
  shadow_map_piece_.set("reach", static_cast<float>(shadow_reach_));

  const Gl& gl = context.gl();
  gl.BindTexture(GL_TEXTURE_2D, shadow_map_.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, shadow_size, shadow_size, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer_.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shadow_map_.id(), 0);
}

void Ground::look(const Camera& camera) {
  camera_ = &camera;
  const Eigen::Matrix4f matrix = camera.matrix().cast<float>();
  for (const GlProgram* program : {&grid_, &shadow_}) {
    program->use();
    program->set_matrix("view", matrix.data());
  }
}

void Ground::set_tile(Color tile) const {
  for (const GlProgram* program : {&grid_, &shadow_}) {
    program->use();
    program->set("tile", tile);
  }
}

bool Ground::is_seen() const {
  return !camera_->is_parallel() || std::abs(camera_->back().dot(surroundings_.up)) > 1e-6;
}

void Ground::draw_grid() const {
  if (!is_seen()) return;
  context_.gl().BindVertexArray(no_attributes_.id());
  grid_.use();
  context_.gl().DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Ground::cast_shadow(std::span<const std::vector<CurvePoint>> curves) {
  const Gl& gl = context_.gl();
  const double texel = 2 * shadow_reach_ / shadow_size;
  std::vector<float> pieces;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL), high = -low;
  const auto add = [&](const CurvePoint& from, const CurvePoint& to) {
    const Eigen::Vector2d a = surroundings_.ground_coordinates(from.position);
    const Eigen::Vector2d b = surroundings_.ground_coordinates(to.position);
    const double height =
        std::max(0.0, (surroundings_.height(from.position) + surroundings_.height(to.position)) / 2);
    // A wide light: the higher the cable, the softer and fainter.
    const double blur = cable_radius_ + 0.035 * height;
    const double strength = 0.15 + 0.85 * std::sqrt(cable_radius_ / blur);
    for (const double value :
         {a.x(), a.y(), b.x(), b.y(), std::max(cable_radius_, texel), std::max(blur, texel), strength})
      pieces.push_back(static_cast<float>(value));
    const double around = std::max(cable_radius_, texel) + 2 * std::max(blur, texel) + texel;
    low = low.cwiseMin((a.cwiseMin(b).array() - around).matrix());
    high = high.cwiseMax((a.cwiseMax(b).array() + around).matrix());
  };
  for (const std::vector<CurvePoint>& curve : curves)
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) add(curve[i], curve[i + 1]);
  shadowed_ = in_picture(low, high);
  gl.BindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer_.id());
  gl.Viewport(0, 0, shadow_size, shadow_size);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MAX);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  shadow_map_piece_.use();
  pieces_.upload(pieces);
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, pieces_.count());
}

std::optional<Rect> Ground::in_picture(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
  Rect rect{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const double x : {low.x(), high.x()})
    for (const double y : {low.y(), high.y()}) {
      const Point p =
          camera_->pixel(surroundings_.origin + x * surroundings_.across + y * surroundings_.forward);
      if (!p.allFinite()) return {};
      rect.left = std::min(rect.left, p.x());
      rect.right = std::max(rect.right, p.x());
      rect.top = std::min(rect.top, p.y());
      rect.bottom = std::max(rect.bottom, p.y());
    }
  return rect;
}

void Ground::draw_shadow(const Canvas& canvas) const {
  if (!is_seen()) return;
  const Gl& gl = context_.gl();
  if (shadowed_) {
    // A box far outside the picture is more than OpenGL's whole numbers hold.
    const auto whole = [](double pixel) { return static_cast<int>(std::clamp(pixel, -1e6, 1e6)); };
    const int left = whole(std::floor(shadowed_->left)), right = whole(std::ceil(shadowed_->right));
    const int top = whole(std::floor(shadowed_->top)), bottom = whole(std::ceil(shadowed_->bottom));
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(left - canvas.left(), canvas.height() - (bottom - canvas.top()), right - left, bottom - top);
  }
  gl.BindVertexArray(no_attributes_.id());
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, shadow_map_.id());
  shadow_.use();
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl.Disable(GL_SCISSOR_TEST);
}

}  // namespace plumb
