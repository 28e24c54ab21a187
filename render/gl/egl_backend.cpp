#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "engine/base/errors.h"
#include "render/gl/gl_backend.h"
#include "render/gl/shared_library.h"

namespace plumb {
namespace {

constexpr const char* egl_library = "libEGL.so.1";

/// Whether a list of words separated by blanks has one.
bool has_word(std::string_view list, std::string_view word) {
  for (std::size_t at = 0; (at = list.find(word, at)) != std::string_view::npos; at += word.size()) {
    const bool begins = at == 0 || list[at - 1] == ' ';
    const std::size_t end = at + word.size();
    if (begins && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

/// The functions of EGL that are needed, by address.
struct Egl {
  SharedLibrary library{egl_library};
  PFNEGLGETPROCADDRESSPROC get_address = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLGETCURRENTCONTEXTPROC current_context = nullptr;
  PFNEGLGETERRORPROC error = nullptr;
  PFNEGLQUERYSTRINGPROC query_string = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = nullptr;

  Egl() {
    library.load(get_address, "eglGetProcAddress");
    library.load(initialize, "eglInitialize");
    library.load(bind_api, "eglBindAPI");
    library.load(create_context, "eglCreateContext");
    library.load(destroy_context, "eglDestroyContext");
    library.load(make_current, "eglMakeCurrent");
    library.load(current_context, "eglGetCurrentContext");
    library.load(error, "eglGetError");
    library.load(query_string, "eglQueryString");
    extension(query_devices, "eglQueryDevicesEXT");
    extension(query_device_string, "eglQueryDeviceStringEXT");
    extension(platform_display, "eglGetPlatformDisplayEXT");
  }

  std::vector<EGLDeviceEXT> devices() const {
    EGLint count = 0;
    if (query_devices(0, nullptr, &count) != EGL_TRUE || count < 1) return {};
    std::vector<EGLDeviceEXT> all(static_cast<std::size_t>(count));
    if (query_devices(count, all.data(), &count) != EGL_TRUE) return {};
    all.resize(static_cast<std::size_t>(count));
    return all;
  }

  EglDevice describe(EGLDeviceEXT device) const {
    const char* extensions = query_device_string(device, EGL_EXTENSIONS);
    EglDevice result;
    result.extensions = extensions != nullptr ? extensions : "";
    result.software = has_word(result.extensions, "EGL_MESA_device_software");
    return result;
  }

 private:
  template <typename Function>
  void extension(Function& function, const char* name) const {
    function = reinterpret_cast<Function>(get_address(name));
    if (function == nullptr) throw OutputError(fmt::format("OpenGL: EGL has no {}", name));
  }
};

class EglBackend : public GlBackend {
 public:
  explicit EglBackend(int device) {
    const std::vector<EGLDeviceEXT> all = egl_.devices();
    if (all.empty()) throw OutputError("OpenGL: EGL knows no device");
    device_count_ = all.size();
    choose(all, device);
    display_ = egl_.platform_display(EGL_PLATFORM_DEVICE_EXT, all[device_], nullptr);
    if (display_ == EGL_NO_DISPLAY || egl_.initialize(display_, &major_, &minor_) != EGL_TRUE)
      fail("gives no display");
    if (egl_.bind_api(EGL_OPENGL_API) != EGL_TRUE) fail("has no OpenGL");
    const char* offered = egl_.query_string(display_, EGL_EXTENSIONS);
    for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"})
      if (offered == nullptr || !has_word(offered, needed)) fail(fmt::format("has no {}", needed));
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    context_ = egl_.create_context(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) fail("gives no core profile of version 3.3 or above");
  }
  // The display stays: it is one for all contexts of a device.
  ~EglBackend() override {
    if (egl_.current_context() == context_)
      egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }
  EglBackend(const EglBackend&) = delete;
  EglBackend& operator=(const EglBackend&) = delete;

  bool try_current() noexcept override {
    return egl_.current_context() == context_ ||
           egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  void* address(const char* function) const override {
    return reinterpret_cast<void*>(egl_.get_address(function));
  }

  std::string description() const override {
    return fmt::format("EGL {}.{}, device {} of {}{}", major_, minor_, device_, device_count_,
                       software_ ? " (software)" : "");
  }

 private:
  void choose(const std::vector<EGLDeviceEXT>& all, int wanted) {
    if (wanted >= 0) {
      if (static_cast<std::size_t>(wanted) >= all.size())
        throw OutputError(
            fmt::format("OpenGL: EGL has no device {}; there are {}, from 0", wanted, all.size()));
      device_ = static_cast<std::size_t>(wanted);
    } else {
      while (device_ < all.size() && !egl_.describe(all[device_]).software) ++device_;
      if (device_ == all.size())
        throw OutputError(
            fmt::format("OpenGL: none of EGL's {} devices draws in software; PLUMB_GL=egl:0 takes the first",
                        all.size()));
    }
    software_ = egl_.describe(all[device_]).software;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw OutputError(fmt::format("OpenGL: device {} of EGL {} (error {:#x})", device_, what, egl_.error()));
  }

  Egl egl_;
  std::size_t device_ = 0;
  std::size_t device_count_ = 0;
  bool software_ = false;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLint major_ = 0, minor_ = 0;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

bool egl_is_there() {
  return SharedLibrary::is_there(egl_library);
}

std::vector<EglDevice> egl_devices() {
  if (!egl_is_there()) return {};
  const Egl egl;
  std::vector<EglDevice> result;
  for (const EGLDeviceEXT device : egl.devices()) result.push_back(egl.describe(device));
  return result;
}

std::unique_ptr<GlBackend> make_egl_backend(int device) {
  return std::make_unique<EglBackend>(device);
}

}  // namespace plumb
