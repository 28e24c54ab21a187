#pragma once

#include <memory>
#include <string>
#include <vector>

namespace plumb {

/// Where an OpenGL context without a display comes from.
enum class GlBackendKind {
  osmesa,  ///< a library that draws into memory and nothing else
  egl,     ///< a device of EGL, without a surface
};

/// "osmesa", "egl".
std::string word(GlBackendKind);

/// A choice of backend: which, and for EGL which device.
struct GlBackendChoice {
  GlBackendKind kind = GlBackendKind::osmesa;
  int device = -1;  ///< of EGL, from 0; -1: the first that draws in software

  /// What the environment's PLUMB_GL asks for: "osmesa", "egl", or "egl:1" for a device. Nothing given:
  /// OSMesa where its library is there, else EGL. Throws UsageError for anything else.
  static GlBackendChoice from_environment();
};

/// An OpenGL core profile of version 3.3 or above with its library, opened when it is made.
class GlBackend {
 public:
  virtual ~GlBackend() = default;

  /// Makes the context that of this thread; false when it cannot be done.
  virtual bool try_current() noexcept = 0;
  /// The address of an OpenGL function, or nullptr.
  virtual void* address(const char* function) const = 0;
  /// "OSMesa", "EGL 1.5, device 0 of 1 (software)".
  virtual std::string description() const = 0;
};

/// Throws OutputError where the library or a context cannot be had.
std::unique_ptr<GlBackend> make_osmesa_backend();
std::unique_ptr<GlBackend> make_egl_backend(int device);  ///< see GlBackendChoice::device
std::unique_ptr<GlBackend> make_gl_backend(const GlBackendChoice& choice);

/// True where the library of the backend can be opened.
bool osmesa_is_there();
bool egl_is_there();

/// A device that EGL knows.
struct EglDevice {
  bool software = false;
  std::string extensions;
};
/// All of them; none where there is no EGL.
std::vector<EglDevice> egl_devices();

}  // namespace plumb
