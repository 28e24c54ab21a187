#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include "render/image/png.h"

namespace plumb {

/// Keeps what a test drew or made for the eye, where the environment's PLUMB_PICTURES names a folder.
inline void keep(const std::string& name, const std::string& bytes) {
  if (const char* folder = std::getenv("PLUMB_PICTURES"))
    std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary) << bytes;
}

inline void keep(const std::string& name, const Image& image) {
  if (std::getenv("PLUMB_PICTURES") != nullptr) keep(name, encode_png(image));
}

}  // namespace plumb
