#pragma once

#include <memory>
#include <string>

#include "render/gl/gl_backend.h"

namespace plumb {

struct Gl;

/// What the renderer runs on.
struct GlInfo {
  std::string backend;  ///< "OSMesa", "EGL 1.5, device 0 of 1 (software)"
  std::string
      renderer;  ///< GL_RENDERER and how it uses the processor: "llvmpipe (LLVM 15.0.6, 256 bits), AVX2"
  std::string version;       ///< GL_VERSION: "4.5 (Core Profile) Mesa 22.3.6"
  std::string font_library;  ///< that draws letters: "FreeType 2.12.1"
  int max_size = 0;          ///< greatest width or height of a picture after supersampling, pixels
  int max_samples = 0;       ///< samples a pixel of a multisampled texture

  /// Pictures drawn with the same fingerprint are the same to the byte: backend, renderer, the processor's
  /// instructions, versions, and that of the letters.
  std::string fingerprint() const {
    return backend + "; " + renderer + "; OpenGL " + version + "; " + font_library;
  }
};

/// An OpenGL core profile, 3.3 or above, without a display or a window. It belongs to the thread that uses
/// it: every class that draws makes it current first.
class GlContext {
 public:
  /// Throws OutputError when no context can be had, and UsageError where check_environment does.
  explicit GlContext(const GlBackendChoice& choice = GlBackendChoice::from_environment());
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  const GlInfo& info() const { return info_; }
  const Gl& gl() const { return *gl_; }

  /// Makes this the context that OpenGL calls of this thread go to, and returns it. Throws OutputError.
  const GlContext& make_current() const;
  /// The same for destructors: false when it cannot be done.
  bool try_current() const noexcept;

  /// Throws OutputError that names `task` and the error, if OpenGL has recorded one.
  void check(const std::string& task) const;

  /// Throws OutputError that names the limit unless width and height, times the supersampling, can be drawn.
  void check_size(int width, int height, int supersampling) const;

 private:
  std::unique_ptr<GlBackend> backend_;
  std::unique_ptr<Gl> gl_;
  GlInfo info_;
};

}  // namespace plumb
