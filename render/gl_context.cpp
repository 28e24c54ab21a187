#include "render/gl_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <future>
#include <thread>
#include <vector>

#include "engine/errors.h"
#include "render/environment.h"
#include "render/gl.h"

namespace plumb {

namespace {

/// Whether so many threads can run at once.
bool threads_can_be_had(unsigned count) {
  std::promise<void> all_there;
  const std::shared_future<void> end = all_there.get_future().share();
  std::vector<std::jthread> threads;
  bool there = true;
  try {
    for (unsigned k = 0; k < count; ++k) threads.emplace_back([end] { end.wait(); });
  } catch (const std::exception&) {
    there = false;
  }
  all_there.set_value();
  return there;
}

/// The software renderer waits for ever for threads that it could not start; without any it draws in ours.
void draw_with_threads_there_are() {
  if (!threads_can_be_had(std::max(1U, std::thread::hardware_concurrency())))
    ::setenv("LP_NUM_THREADS", "0", 1);
}

// What a driver that draws on the processor may use of it, which moves a lit pixel by a level here and there.
std::string instructions(const std::string& renderer) {
  if (renderer.find("llvmpipe") == std::string::npos) return {};
  std::string level;
#ifdef __x86_64__
  level = __builtin_cpu_supports("avx2")     ? ", AVX2"
          : __builtin_cpu_supports("avx")    ? ", AVX"
          : __builtin_cpu_supports("sse4.1") ? ", SSE4.1"
                                             : ", SSE2";
  if (__builtin_cpu_supports("fma")) level += " and FMA";
#endif
  const char* lowered = std::getenv("GALLIUM_OVERRIDE_CPU_CAPS");
  return lowered != nullptr ? fmt::format("{}, lowered to {}", level, lowered) : level;
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

GlContext::GlContext(const GlBackendChoice& choice) {
  check_environment();
  draw_with_threads_there_are();
  // The driver would leave a cache of compiled shaders in the home folder.
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  // What fails is said by the error alone.
  ::setenv("EGL_LOG_LEVEL", "fatal", 0);
  backend_ = make_gl_backend(choice);
  make_current();

  gl_ = std::make_unique<Gl>();
  const auto address = [&](const char* name) {
    void* const found = backend_->address(name);
    if (found == nullptr) throw OutputError(fmt::format("OpenGL: the driver has no {}", name));
    return found;
  };
#define PLUMB_GL_LOAD(type, name) gl_->name = reinterpret_cast<type>(address("gl" #name));
  PLUMB_GL_FUNCTIONS(PLUMB_GL_LOAD)
#undef PLUMB_GL_LOAD

  info_.backend = backend_->description();
  info_.renderer = reinterpret_cast<const char*>(gl_->GetString(GL_RENDERER));
  info_.renderer += instructions(info_.renderer);
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
  return backend_->try_current();
}

const GlContext& GlContext::make_current() const {
  if (!try_current()) throw OutputError("OpenGL: the context cannot be made current");
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
