#pragma once

#include <memory>
#include <string>
#include <vector>

namespace plumb {

struct Gl;

/// What the renderer runs on.
struct GlInfo {
  std::string renderer;  ///< GL_RENDERER: "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version;   ///< GL_VERSION: "4.5 (Core Profile) Mesa 22.3.6"
  int max_size = 0;      ///< greatest width or height of a picture after supersampling, pixels
  int max_samples = 0;   ///< samples a pixel of a multisampled texture
};

/// An OpenGL core profile, 3.3 or above, without a display or a window (OSMesa). It belongs to the thread
/// that uses it: every class that draws makes it current first.
class GlContext {
 public:
  /// Throws OutputError when no context can be had, or when the environment would crash the driver.
  GlContext();
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
  struct Release {
    void operator()(void* context) const;
  };

  std::unique_ptr<void, Release> context_;
  std::unique_ptr<Gl> gl_;
  mutable std::vector<unsigned char>
      window_;  // OSMesa wants a buffer of its own; everything is drawn to others
  GlInfo info_;
};

}  // namespace plumb
