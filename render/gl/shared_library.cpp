#include "render/gl/shared_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "engine/base/errors.h"

namespace plumb {
namespace {

void* open(const std::string& name) noexcept {
  return ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
}

std::string last_error() {
  const char* error = ::dlerror();
  return error != nullptr ? error : "no reason given";
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& name) : name_(name), handle_(open(name)) {
  if (handle_ == nullptr)
    throw OutputError(fmt::format("OpenGL: {} cannot be opened: {}", name, last_error()));
}

bool SharedLibrary::is_there(const std::string& name) noexcept {
  return open(name) != nullptr;
}

void* SharedLibrary::symbol(const char* name) const {
  void* address = ::dlsym(handle_, name);
  if (address == nullptr) throw OutputError(fmt::format("OpenGL: {} has no {}", name_, name));
  return address;
}

}  // namespace plumb
