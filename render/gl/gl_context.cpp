#include "render/gl/gl_context.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <thread>
#include <vector>

#include "engine/base/errors.h"
#include "render/gl/environment.h"
#include "render/gl/gl.h"
#include "render/gl/text.h"

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

constexpr const char* threads_variable = "LP_NUM_THREADS";
constexpr long most_threads = 16;  // that any version of it starts

/// The software renderer waits for ever for threads that it could not start; without any it draws in ours.
void draw_with_threads_there_are() {
  const unsigned wanted = std::clamp(std::thread::hardware_concurrency(), 1U, unsigned{most_threads});
  const bool there = threads_can_be_had(wanted);
  // Told how many, so that it is known how many there must be.
  ::setenv(threads_variable, std::to_string(there && wanted > 1 ? wanted : 0).c_str(), there ? 0 : 1);
}

constexpr std::string_view name_of_makers = "plumb-gl", renderer_names = "llvmpipe-";

/// While one exists, threads that this one starts begin with a name that tells.
class NamesItsThreads {
 public:
  NamesItsThreads() {
    ::prctl(PR_GET_NAME, before_);
    ::prctl(PR_SET_NAME, name_of_makers.data());
  }
  ~NamesItsThreads() { ::prctl(PR_SET_NAME, before_); }
  NamesItsThreads(const NamesItsThreads&) = delete;
  NamesItsThreads& operator=(const NamesItsThreads&) = delete;

 private:
  char before_[16] = {};
};

/// Threads of the software renderer.
struct RendererThreads {
  long there = 0;         ///< as many as there may be where that cannot be seen
  bool starting = false;  ///< one that has no name of its own yet is at work
};

RendererThreads renderer_threads() {
  RendererThreads found;
  std::error_code error;
  for (std::filesystem::directory_iterator thread("/proc/self/task", error), end; !error && thread != end;
       thread.increment(error)) {
    // "7007 (plumb) S 1 ..."
    std::string status;
    std::getline(std::ifstream(thread->path() / "stat"), status);
    const std::size_t name = status.find('('), state = status.rfind(") ");
    if (name == std::string::npos || state == std::string::npos) {
      ++found.there;
      continue;
    }
    const std::string_view called = std::string_view(status).substr(name + 1, state - name - 1);
    if (called.starts_with(renderer_names)) ++found.there;
    if (called == name_of_makers && status.substr(state + 2, 1) != "S") found.starting = true;
  }
  if (error) found.there = most_threads;
  return found;
}

/// Those that could be had a moment ago may be gone. Throws OutputError.
void check_threads_are_there() {
  constexpr int looks_at_rest = 10;
  constexpr std::chrono::milliseconds look_every(5);
  const long wanted = std::clamp(std::strtol(std::getenv(threads_variable), nullptr, 10), 0L, most_threads);
  for (int at_rest = 0;;) {
    const RendererThreads threads = renderer_threads();
    if (threads.there >= wanted) return;
    at_rest = threads.starting ? 0 : at_rest + 1;
    if (at_rest == looks_at_rest)
      throw OutputError(
          fmt::format("OpenGL: only {} of the {} threads of the renderer could be started; with {}=0 "
                      "it draws without",
                      threads.there, wanted, threads_variable));
    std::this_thread::sleep_for(look_every);
  }
}

/// Where little is left of what the process may use, the driver crashes.
void refuse_scarce_memory() {
  constexpr double least = 100e6;  // bytes, for a small picture
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0 || static_cast<double>(limit.rlim_cur) > least) return;
  throw OutputError(
      fmt::format("OpenGL: the data segment may be no more than {:.3g} MB (ulimit -d), and drawing "
                  "takes {:.3g} MB",
                  static_cast<double>(limit.rlim_cur) / 1e6, least / 1e6));
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
  refuse_scarce_memory();
  draw_with_threads_there_are();
  // The driver would leave a cache of compiled shaders in the home folder.
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  // Its compiler would take as long to make shaders fast as it takes to draw the frames of a report; the same
  // pixels come slower only where there are a hundred of 4K.
  ::setenv("GALLIVM_PERF", "nopt", 0);
  // What fails is said by the error alone.
  ::setenv("EGL_LOG_LEVEL", "fatal", 0);
  {
    const NamesItsThreads named;
    backend_ = make_gl_backend(choice);
    make_current();
  }

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
  if (info_.renderer.find("llvmpipe") != std::string::npos) {
    try {
      check_threads_are_there();
    } catch (const OutputError&) {
      backend_.release();  // it could not even be closed
      throw;
    }
  }
  info_.version = reinterpret_cast<const char*>(gl_->GetString(GL_VERSION));
  info_.font_library = font_library();
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
