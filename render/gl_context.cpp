#include "render/gl_context.h"

#include "render/gl.h"
// After gl.h: the core-profile header has to declare its types before GL/gl.h declares fewer.
#include <GL/osmesa.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "engine/errors.h"

namespace plumb {

namespace {

constexpr int window_size = 16;

template <typename Function>
void load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(OSMesaGetProcAddress(name));
  if (function == nullptr) throw OutputError(fmt::format("OpenGL: the driver has no {}", name));
}

void refuse_crashing_environment() {
  // The driver would leave a cache of compiled shaders in the home folder.
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  const char* width = std::getenv("LP_NATIVE_VECTOR_WIDTH");
  if (width != nullptr && std::strtol(width, nullptr, 10) >= 512)
    throw OutputError(fmt::format(
        "LP_NATIVE_VECTOR_WIDTH={}: the software renderer crashes with it; unset it or use 256", width));
}

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "an unknown error";
  }
}

}  // namespace

void GlContext::Release::operator()(void* context) const {
  OSMesaDestroyContext(static_cast<OSMesaContext>(context));
}

GlContext::GlContext() : window_(std::size_t{4} * window_size * window_size) {
  refuse_crashing_environment();
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            0,
                            OSMESA_STENCIL_BITS,
                            0,
                            OSMESA_ACCUM_BITS,
                            0,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0,
                            0};
  context_.reset(OSMesaCreateContextAttribs(attributes, nullptr));
  if (!context_) throw OutputError("OpenGL: OSMesa gives no core profile of version 3.3 or above");
  make_current();

  gl_ = std::make_unique<Gl>();
#define PLUMB_GL_LOAD(type, name) load(gl_->name, "gl" #name);
  PLUMB_GL_FUNCTIONS(PLUMB_GL_LOAD)
#undef PLUMB_GL_LOAD

  info_.renderer = reinterpret_cast<const char*>(gl_->GetString(GL_RENDERER));
  info_.version = reinterpret_cast<const char*>(gl_->GetString(GL_VERSION));
  GLint texture = 0;
  GLint renderbuffer = 0;
  GLint viewport[2] = {0, 0};
  gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  gl_->GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  gl_->GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  info_.max_size = std::min({texture, renderbuffer, viewport[0], viewport[1]});
  gl_->GetIntegerv(GL_MAX_SAMPLES, &info_.max_samples);
  check("reading the limits");
}

GlContext::~GlContext() = default;

bool GlContext::try_current() const noexcept {
  const auto context = static_cast<OSMesaContext>(context_.get());
  return OSMesaGetCurrentContext() == context ||
         OSMesaMakeCurrent(context, window_.data(), GL_UNSIGNED_BYTE, window_size, window_size) == GL_TRUE;
}

const GlContext& GlContext::make_current() const {
  if (!try_current()) throw OutputError("OpenGL: OSMesa cannot make its context current");
  return *this;
}

void GlContext::check(const std::string& task) const {
  const GLenum error = gl_->GetError();
  if (error != GL_NO_ERROR) throw OutputError(fmt::format("OpenGL: {} while {}", error_name(error), task));
}

void GlContext::check_size(int width, int height, int supersampling) const {
  if (width < 1 || height < 1 || supersampling < 1)
    throw OutputError(fmt::format("a picture of {} x {} pixels with {} x {} samples: all must be at least 1",
                                  width, height, supersampling, supersampling));
  // Divided rather than multiplied, so that no product overflows.
  const int limit = info_.max_size / supersampling;
  if (width > limit || height > limit)
    throw OutputError(
        fmt::format("a picture of {} x {} pixels with {} x {} samples: at most {} pixels a side can be drawn",
                    width, height, supersampling, supersampling, limit));
}

}  // namespace plumb
