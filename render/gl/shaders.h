#pragma once

#include <string_view>

namespace plumb {

/// The texts of render/shaders/, embedded by CMake.
extern const std::string_view fullscreen_vert, resolve_frag, coverage_frag, shape_vert, shape_frag, text_vert,
    text_frag, background_frag, ground_vert, ground_frag, shadow_vert, shadow_frag, tube_vert, tube_frag,
    trail_vert, trail_frag, ground_shadow_frag;

}  // namespace plumb
