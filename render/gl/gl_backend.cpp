#include "render/gl/gl_backend.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>
#include <vector>

#include "engine/base/errors.h"
#include "engine/base/nearest.h"

namespace plumb {

std::string word(GlBackendKind kind) {
  return kind == GlBackendKind::osmesa ? "osmesa" : "egl";
}

GlBackendChoice GlBackendChoice::from_environment() {
  const char* given = std::getenv("PLUMB_GL");
  const std::string text = given != nullptr ? given : "";
  if (text.empty())
    return {osmesa_is_there() || !egl_is_there() ? GlBackendKind::osmesa : GlBackendKind::egl, -1};
  if (text == "osmesa") return {GlBackendKind::osmesa, -1};
  if (text == "egl") return {GlBackendKind::egl, -1};
  if (text.starts_with("egl:") && text.size() > 4 && text.size() < 8 &&
      text.find_first_not_of("0123456789", 4) == std::string::npos)
    return {GlBackendKind::egl, std::atoi(text.c_str() + 4)};
  const std::vector<std::string> known{"osmesa", "egl", "egl:0"};
  const std::string_view near = nearest(text, known);
  throw UsageError(fmt::format(
      "PLUMB_GL={}: must be osmesa, egl, or egl:N for device N of those that plumb doctor lists{}", text,
      near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near)));
}

std::unique_ptr<GlBackend> make_gl_backend(const GlBackendChoice& choice) {
  return choice.kind == GlBackendKind::osmesa ? make_osmesa_backend() : make_egl_backend(choice.device);
}

}  // namespace plumb
