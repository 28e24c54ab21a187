#include "render/gl/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/errors.h"
#include "render/gl/shaders.h"

namespace plumb {

namespace {

// What every renderer of a core profile has to offer; more raises an error and keeps the storage as it was.
constexpr int most_samples = 4;

constexpr int samples_of(int supersampling) {
  return supersampling % 2 == 0 ? most_samples : 1;
}

constexpr int layer_scale_of(int supersampling) {
  return supersampling % 2 == 0 ? supersampling / 2 : supersampling;
}

// Checked before any member takes something from OpenGL.
const GlContext& ready(const GlContext& context, int width, int height, int supersampling) {
  context.check_size(width, height, layer_scale_of(supersampling));
  return context.make_current();
}

void check_complete(const GlContext& context, int width, int height) {
  const GLenum status = context.gl().CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw OutputError(fmt::format("OpenGL: no framebuffer of {} x {} pixels can be had (status {:#x})", width,
                                  height, status));
}

}  // namespace

Canvas::Geometry::Geometry(const GlContext& context, int width, int height, int samples)
    : color(context), depth(context), framebuffer(context) {
  const Gl& gl = context.gl();
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, color.id());
  gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_RGBA8, width, height, GL_TRUE);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, depth.id());
  gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_DEPTH_COMPONENT24, width, height, GL_TRUE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, color.id(), 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, depth.id(), 0);
  check_complete(context, width, height);
}

Canvas::Layer::Layer(const GlContext& context, int width, int height) : color(context), framebuffer(context) {
  const Gl& gl = context.gl();
  gl.BindTexture(GL_TEXTURE_2D, color.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color.id(), 0);
  check_complete(context, width, height);
}

Canvas::Canvas(const GlContext& context, int width, int height, int supersampling)
    : context_(ready(context, width, height, supersampling)),
      width_(width),
      height_(height),
      samples_(samples_of(supersampling)),
      layer_scale_(layer_scale_of(supersampling)),
      flat_(context, width, height),
      no_attributes_(context) {
  context.check("making a canvas");
}

void Canvas::clip(int scale) const {
  const auto left = static_cast<int>(region_.left);
  const auto bottom = static_cast<int>(region_.bottom);
  context_.gl().Enable(GL_SCISSOR_TEST);
  context_.gl().Scissor(scale * left, scale * (height_ - bottom),
                        scale * (static_cast<int>(region_.right) - left),
                        scale * (bottom - static_cast<int>(region_.top)));
}

void Canvas::place_at(int left, int top) {
  left_ = left;
  top_ = top;
}

bool Canvas::begin_geometry(const Rect& region) {
  const Gl& gl = context_.gl();
  const auto inside = [](double pixel, int limit) {
    return std::clamp(pixel, 0.0, static_cast<double>(limit));
  };
  region_.left = std::floor(inside(region.left - left_, width_));
  region_.top = std::floor(inside(region.top - top_, height_));
  region_.right = std::ceil(inside(region.right - left_, width_));
  region_.bottom = std::ceil(inside(region.bottom - top_, height_));
  if (!(region_.width() > 0 && region_.height() > 0)) return false;
  if (!geometry_) geometry_.emplace(context_, width_ * layer_scale_, height_ * layer_scale_, samples_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, geometry_->framebuffer.id());
  gl.Viewport(0, 0, width_ * layer_scale_, height_ * layer_scale_);
  clip(layer_scale_);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return true;
}

void Canvas::resolve(double opacity) {
  const Gl& gl = context_.gl();
  if (!resolver_) resolver_.emplace(context_, fullscreen_vert, resolve_frag);
  bind_flat();
  clip(1);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, geometry_->color.id());
  resolver_->use();
  resolver_->set("scale", layer_scale_);
  resolver_->set("samples", samples_);
  resolver_->set("opacity", static_cast<float>(opacity));
  gl.BindVertexArray(no_attributes_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  bind_flat();
}

void Canvas::begin_flat(Color background) {
  bind_flat();
  opaque_ = background.a >= 1;
  context_.gl().ClearColor(background.a * background.r, background.a * background.g,
                           background.a * background.b, background.a);
  context_.gl().Clear(GL_COLOR_BUFFER_BIT);
}

void Canvas::bind_flat_framebuffer() const {
  context_.gl().BindFramebuffer(GL_FRAMEBUFFER, flat_.framebuffer.id());
  context_.gl().Viewport(0, 0, width_, height_);
}

void Canvas::bind_flat() const {
  const Gl& gl = context_.gl();
  bind_flat_framebuffer();
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  // The picture's colours are multiplied by its opacity, those that are drawn are not.
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void Canvas::copy(const Layer& from, const Layer& to) const {
  const Gl& gl = context_.gl();
  gl.Disable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer.id());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer.id());
  gl.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Canvas::keep() {
  if (!kept_) kept_.emplace(context_, width_, height_);
  copy(flat_, *kept_);
}

void Canvas::restore() const {
  copy(*kept_, flat_);
  bind_flat();
}

Image Canvas::read() const {
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  Image image{width_, height_, std::vector<std::uint8_t>(3 * pixels), {}};
  if (!opaque_) image.alpha.resize(pixels);
  read_into(image);
  return image;
}

void Canvas::read_into(Image& picture) const {
  const Gl& gl = context_.gl();
  const auto stride = static_cast<std::size_t>(width_);
  rgba_.resize(4 * stride * static_cast<std::size_t>(height_));
  gl.BindFramebuffer(GL_FRAMEBUFFER, flat_.framebuffer.id());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
  context_.check("drawing a picture");

  // A canvas placed in a larger picture may reach beyond it.
  const bool larger = picture.width != width_ || picture.height != height_;
  const int left = larger ? left_ : 0, top = larger ? top_ : 0;
  const auto columns = static_cast<std::size_t>(std::clamp(picture.width - left, 0, width_));
  const auto rows = static_cast<std::size_t>(std::clamp(picture.height - top, 0, height_));
  for (std::size_t row = 0; row < rows; ++row) {
    // OpenGL counts rows from the bottom.
    const std::uint8_t* from = &rgba_[4 * stride * (static_cast<std::size_t>(height_) - 1 - row)];
    const std::size_t first =
        (static_cast<std::size_t>(top) + row) * static_cast<std::size_t>(picture.width) +
        static_cast<std::size_t>(left);
    std::uint8_t* to = &picture.rgb[3 * first];
    if (picture.alpha.empty()) {
      for (std::size_t column = 0; column < columns; ++column)
        for (std::size_t c = 0; c < 3; ++c) to[3 * column + c] = from[4 * column + c];
    } else {
      for (std::size_t column = 0; column < columns; ++column) {
        const unsigned alpha = from[4 * column + 3];
        for (std::size_t c = 0; c < 3; ++c)
          to[3 * column + c] = static_cast<std::uint8_t>(
              alpha == 0 ? 0 : std::min(255U, (255U * from[4 * column + c] + alpha / 2) / alpha));
        picture.alpha[first + column] = static_cast<std::uint8_t>(alpha);
      }
    }
  }
}

}  // namespace plumb
