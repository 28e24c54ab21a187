#include "render/gl/environment.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "engine/base/errors.h"
#include "engine/base/nearest.h"
#include "render/gl/gl_backend.h"

namespace plumb {
namespace {

constexpr std::string_view own_start = "PLUMB_";

/// Those of make.sh and of the examples for continuous integration.
constexpr std::array<std::string_view, 2> of_scripts{"PLUMB_PRESET", "PLUMB_REPOSITORY"};

void check_vector_width() {
  const char* given = std::getenv("LP_NATIVE_VECTOR_WIDTH");
  const std::string_view width = given != nullptr ? given : "";
  if (width.empty() || width == "128" || width == "256") return;
  throw UsageError(fmt::format(
      "LP_NATIVE_VECTOR_WIDTH={}: must be 128 or 256, as the software renderer crashes with others", width));
}

}  // namespace

std::span<const EnvironmentVariable> environment_variables() {
  static constexpr std::array all{
      EnvironmentVariable{"PLUMB_GL", "where pictures are drawn: osmesa, egl, or egl:N for device N"},
      EnvironmentVariable{"NO_COLOR", "if set: no colours on a terminal"},
      EnvironmentVariable{"PATH", "where --video looks for ffmpeg"},
      EnvironmentVariable{"LP_NATIVE_VECTOR_WIDTH", "of the software renderer: 128 or 256"},
      EnvironmentVariable{"LP_NUM_THREADS",
                          "of the software renderer: its threads; as many as processors unless given"},
      EnvironmentVariable{"GALLIUM_OVERRIDE_CPU_CAPS",
                          "of the software renderer, which checks it; noted as a part of its name"},
      EnvironmentVariable{"MESA_SHADER_CACHE_DISABLE", "of the software renderer; set to true unless given"},
      EnvironmentVariable{"GALLIVM_PERF",
                          "of the software renderer; set to nopt unless given, as its compiler takes long"},
      EnvironmentVariable{"EGL_LOG_LEVEL", "of the EGL library; set to fatal unless given"}};
  return all;
}

void check_environment() {
  // An empty one leaves the choice to what is there, which is looked for where it is needed.
  const char* backend = std::getenv("PLUMB_GL");
  if (backend != nullptr && *backend != '\0') GlBackendChoice::from_environment();
  check_vector_width();
}

std::vector<std::string> mistyped_variables() {
  std::vector<std::string> known{"PLUMB_GL"};
  known.insert(known.end(), of_scripts.begin(), of_scripts.end());
  std::vector<std::string> remarks;
  for (char** entry = ::environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string name(text.substr(0, text.find('=')));
    if (!name.starts_with(own_start)) continue;
    // Other programs may have variables that begin alike.
    constexpr std::size_t near = 2;
    const std::string_view meant = nearest(name, known);
    if (meant.empty() || meant == name || edit_distance(name, meant) > near) continue;
    remarks.push_back(fmt::format("{} in the environment is not looked at; did you mean {}?", name, meant));
  }
  return remarks;
}

}  // namespace plumb
