#include "render/gl/gl_backend.h"
// After glcorearb.h: the core-profile header has to declare its types before GL/gl.h declares fewer.
#include <GL/glcorearb.h>
#include <GL/osmesa.h>

#include <memory>

#include "engine/base/errors.h"
#include "render/gl/shared_library.h"

namespace plumb {
namespace {

constexpr const char* osmesa_library = "libOSMesa.so.8";
constexpr int window_size = 16;

class OsmesaBackend : public GlBackend {
 public:
  OsmesaBackend() : library_(osmesa_library), window_(std::size_t{4} * window_size * window_size) {
    library_.load(create_, "OSMesaCreateContextAttribs");
    library_.load(destroy_, "OSMesaDestroyContext");
    library_.load(make_current_, "OSMesaMakeCurrent");
    library_.load(get_current_, "OSMesaGetCurrentContext");
    library_.load(get_address_, "OSMesaGetProcAddress");
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
    context_ = create_(attributes, nullptr);
    if (context_ == nullptr)
      throw OutputError("OpenGL: OSMesa gives no core profile of version 3.3 or above");
  }
  ~OsmesaBackend() override { destroy_(context_); }
  OsmesaBackend(const OsmesaBackend&) = delete;
  OsmesaBackend& operator=(const OsmesaBackend&) = delete;

  bool try_current() noexcept override {
    return get_current_() == context_ ||
           make_current_(context_, window_.data(), GL_UNSIGNED_BYTE, window_size, window_size) == GL_TRUE;
  }

  void* address(const char* function) const override {
    return reinterpret_cast<void*>(get_address_(function));
  }

  std::string description() const override { return "OSMesa"; }

 private:
  SharedLibrary library_;
  decltype(&OSMesaCreateContextAttribs) create_ = nullptr;
  decltype(&OSMesaDestroyContext) destroy_ = nullptr;
  decltype(&OSMesaMakeCurrent) make_current_ = nullptr;
  decltype(&OSMesaGetCurrentContext) get_current_ = nullptr;
  decltype(&OSMesaGetProcAddress) get_address_ = nullptr;
  OSMesaContext context_ = nullptr;
  std::vector<unsigned char> window_;  // OSMesa wants a buffer of its own; everything is drawn to others
};

}  // namespace

bool osmesa_is_there() {
  return SharedLibrary::is_there(osmesa_library);
}

std::unique_ptr<GlBackend> make_osmesa_backend() {
  return std::make_unique<OsmesaBackend>();
}

}  // namespace plumb
