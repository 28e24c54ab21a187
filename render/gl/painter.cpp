#include "render/gl/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "render/gl/dash.h"
#include "render/gl/shaders.h"

namespace plumb {

namespace {

constexpr std::array<int, 2> shape_components = {4, 3};
constexpr std::size_t shape_size = 7;

enum class Form { capsule, square, diamond, triangle_up, triangle_down, triangle_right };

void add_shape(std::vector<float>& shapes, const Point& a, const Point& b, double half_width,
               double half_stroke, Form form) {
  for (const double value : {a.x(), a.y(), b.x(), b.y(), half_width, half_stroke})
    shapes.push_back(static_cast<float>(value));
  shapes.push_back(static_cast<float>(form));
}

// Two strokes through p: across `arm` and along it.
void add_arms(std::vector<float>& shapes, const Point& p, const Point& arm, double stroke) {
  for (const Point& way : {Point(arm.y(), -arm.x()), arm})
    add_shape(shapes, p - way, p + way, std::max(stroke, 1.0) / 2, 0, Form::capsule);
}

// The whole pixels that shapes may touch, as the vertex shader has it and a little more.
Rect reach_of(std::span<const float> shapes) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Rect reach{infinite, infinite, -infinite, -infinite};
  for (std::size_t i = 0; i < shapes.size(); i += shape_size) {
    const double around = 1.5 * shapes[i + 4] + shapes[i + 5] + 2;
    for (const std::size_t end : {i, i + 2}) {
      reach.left = std::min(reach.left, std::floor(shapes[end] - around));
      reach.right = std::max(reach.right, std::ceil(shapes[end] + around));
      reach.top = std::min(reach.top, std::floor(shapes[end + 1] - around));
      reach.bottom = std::max(reach.bottom, std::ceil(shapes[end + 1] + around));
    }
  }
  return reach;
}

}  // namespace

Painter::Painter(const GlContext& context)
    : context_(context.make_current()),
      shapes_(context, shape_vert, shape_frag),
      coverage_(context, fullscreen_vert, coverage_frag),
      text_(context, text_vert, text_frag),
      instances_(context, shape_components, VertexBuffer::Step::instance),
      no_attributes_(context),
      mask_(context),
      mask_framebuffer_(context),
      glyphs_(context) {}

void Painter::begin(const Canvas& canvas) {
  canvas_ = &canvas;
  clip_.reset();
  canvas.bind_flat();
}

void Painter::clip(const Rect& rect) {
  clip_ = Rect{std::floor(rect.left), std::floor(rect.top), std::ceil(rect.right), std::ceil(rect.bottom)};
  limit_to(*clip_);
}

void Painter::clip_nothing() {
  clip_.reset();
  context_.gl().Disable(GL_SCISSOR_TEST);
}

void Painter::limit_to(const Rect& rect) {
  context_.gl().Enable(GL_SCISSOR_TEST);
  context_.gl().Scissor(static_cast<int>(rect.left) - canvas_->left(),
                        canvas_->height() - (static_cast<int>(rect.bottom) - canvas_->top()),
                        static_cast<int>(rect.width()), static_cast<int>(rect.height()));
}

void Painter::line(std::span<const Point> points, double width, Color color, Dash dash) {
  std::vector<float> shapes;
  for (const auto& [a, b] : dash_segments(points, dash, width))
    add_shape(shapes, a, b, width / 2, 0, Form::capsule);
  draw_shapes(shapes, color);
}

void Painter::markers(std::span<const Point> points, Marker marker, double diameter, double stroke,
                      Color color) {
  std::vector<float> shapes;
  const double radius = diameter / 2;
  for (const Point& p : points) {
    if (!p.allFinite()) continue;
    switch (marker) {
      case Marker::none:
        break;
      case Marker::circle:
        add_shape(shapes, p, p, radius, stroke / 2, Form::capsule);
        break;
      case Marker::square:
        add_shape(shapes, p, p, radius, stroke / 2, Form::square);
        break;
      case Marker::diamond:
        add_shape(shapes, p, p, radius, stroke / 2, Form::diamond);
        break;
      case Marker::triangle_up:
        add_shape(shapes, p, p, radius, stroke / 2, Form::triangle_up);
        break;
      case Marker::triangle_down:
        add_shape(shapes, p, p, radius, stroke / 2, Form::triangle_down);
        break;
      case Marker::triangle_right:
        add_shape(shapes, p, p, radius, stroke / 2, Form::triangle_right);
        break;
      case Marker::cross:
        add_arms(shapes, p, 0.75 * radius * Point(1, 1), stroke);
        break;
      case Marker::plus:
        add_arms(shapes, p, Point(radius, 0), stroke);
        break;
      case Marker::circled_cross:
        add_shape(shapes, p, p, 1.15 * radius, stroke / 2, Form::capsule);
        add_arms(shapes, p, 0.55 * radius * Point(1, 1), stroke);
        break;
    }
  }
  draw_shapes(shapes, color);
}

void Painter::fill(const Rect& rect, Color color) {
  const Gl& gl = context_.gl();
  const auto left = static_cast<float>(std::round(rect.left) - canvas_->left());
  const auto top = static_cast<float>(std::round(rect.top) - canvas_->top());
  text_.use();
  text_.set("size", static_cast<float>(canvas_->width()), static_cast<float>(canvas_->height()));
  text_.set("box", Color{left, top, static_cast<float>(std::round(rect.right) - canvas_->left()) - left,
                         static_cast<float>(std::round(rect.bottom) - canvas_->top()) - top});
  text_.set("ink", color);
  text_.set("solid", 1);
  gl.BindVertexArray(no_attributes_.id());
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Painter::frame(const Rect& rect, int width, Color color) {
  fill({rect.left, rect.top, rect.right, rect.top + width}, color);
  fill({rect.left, rect.bottom - width, rect.right, rect.bottom}, color);
  fill({rect.left, rect.top + width, rect.left + width, rect.bottom - width}, color);
  fill({rect.right - width, rect.top + width, rect.right, rect.bottom - width}, color);
}

void Painter::text(std::string_view text, TextStyle style, double x, double y, Align align, Color color) {
  if (text.empty()) return;
  const double width = font_.measure(text, style).width;
  if (align == Align::center) x -= width / 2;
  if (align == Align::right) x -= width;
  stamp(font_.draw(text, style), x, y, color);
}

void Painter::turned_text(std::string_view text, TextStyle style, double x, double y, Align align,
                          Color color) {
  if (text.empty()) return;
  const double width = font_.measure(text, style).width;
  if (align == Align::center) y += width / 2;
  if (align == Align::right) y += width;
  stamp(turned(font_.draw(text, style)), x, y, color);
}

void Painter::stamp(const TextBitmap& bitmap, double x, double y, Color color) {
  const Gl& gl = context_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, glyphs_.id());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, bitmap.width, bitmap.height, 0, GL_RED, GL_UNSIGNED_BYTE,
                bitmap.coverage.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  text_.use();
  text_.set("size", static_cast<float>(canvas_->width()), static_cast<float>(canvas_->height()));
  text_.set("box", Color{static_cast<float>(std::round(x) - bitmap.left - canvas_->left()),
                         static_cast<float>(std::round(y) - bitmap.base - canvas_->top()),
                         static_cast<float>(bitmap.width), static_cast<float>(bitmap.height)});
  text_.set("ink", color);
  text_.set("solid", 0);
  gl.BindVertexArray(no_attributes_.id());
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Painter::picture(const ColorBitmap& bitmap, double left, double top) {
  if (bitmap.width <= 0 || bitmap.height <= 0) return;
  const Gl& gl = context_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, glyphs_.id());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, bitmap.width, bitmap.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                bitmap.rgba.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  text_.use();
  text_.set("size", static_cast<float>(canvas_->width()), static_cast<float>(canvas_->height()));
  text_.set("box", Color{static_cast<float>(std::round(left) - canvas_->left()),
                         static_cast<float>(std::round(top) - canvas_->top()),
                         static_cast<float>(bitmap.width), static_cast<float>(bitmap.height)});
  text_.set("solid", 2);
  gl.BindVertexArray(no_attributes_.id());
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Painter::size_mask() {
  if (mask_width_ == canvas_->width() && mask_height_ == canvas_->height()) return;
  mask_width_ = canvas_->width();
  mask_height_ = canvas_->height();
  const Gl& gl = context_.gl();
  gl.BindTexture(GL_TEXTURE_2D, mask_.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, mask_width_, mask_height_, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, mask_framebuffer_.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, mask_.id(), 0);
}

void Painter::draw_shapes(std::span<const float> shapes, Color color) {
  if (shapes.empty()) return;
  const Gl& gl = context_.gl();
  size_mask();
  // Only where the shapes are and the clip allows, as most are small.
  Rect reach = reach_of(shapes);
  const Rect limit = clip_.value_or(canvas_->whole());
  reach = {std::max(reach.left, limit.left), std::max(reach.top, limit.top),
           std::min(reach.right, limit.right), std::min(reach.bottom, limit.bottom)};
  if (!(reach.width() > 0 && reach.height() > 0)) return;
  limit_to(reach);
  gl.BindFramebuffer(GL_FRAMEBUFFER, mask_framebuffer_.id());
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BlendEquation(GL_MAX);
  shapes_.use();
  shapes_.set("size", static_cast<float>(mask_width_), static_cast<float>(mask_height_));
  shapes_.set("corner_of_canvas", static_cast<float>(canvas_->left()), static_cast<float>(canvas_->top()));
  instances_.upload(shapes);
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances_.count());

  // Not canvas_->bind_flat(), which would lift the clip.
  gl.BlendEquation(GL_FUNC_ADD);
  canvas_->bind_flat_framebuffer();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, mask_.id());
  coverage_.use();
  coverage_.set("ink", color);
  gl.BindVertexArray(no_attributes_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  if (clip_)
    limit_to(*clip_);
  else
    gl.Disable(GL_SCISSOR_TEST);
}

}  // namespace plumb
