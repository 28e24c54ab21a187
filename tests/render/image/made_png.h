#pragma once

#include <zlib.h>

#include <string>
#include <vector>

#include "render/image/png_chunks.h"

/// PNG files made chunk by chunk, so that any of them may be wrong.
namespace plumb {

using MadeChunks = std::vector<std::pair<std::string, std::string>>;

inline std::string u32(std::uint32_t value) {
  std::string bytes;
  append_u32(bytes, value);
  return bytes;
}

inline std::string u16(unsigned value) {
  return u32(value).substr(2);
}

inline std::string file_of(const MadeChunks& chunks) {
  std::string file(png_signature);
  for (const auto& [type, data] : chunks) append_chunk(file, type, data);
  return file;
}

/// IHDR; kinds: 0 gray, 2 colours, 3 palette, 4 gray and opacity, 6 colours and opacity.
inline std::string header_of(std::uint32_t width, std::uint32_t height, int depth = 8, int kind = 2,
                             int interlaced = 0) {
  std::string data = u32(width) + u32(height);
  for (const int byte : {depth, kind, 0, 0, interlaced}) data += static_cast<char>(byte);
  return data;
}

inline std::string deflated(const std::string& bytes) {
  std::string out(compressBound(bytes.size()), '\0');
  uLongf size = out.size();
  compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
            bytes.size(), 9);
  return out.substr(0, size);
}

/// Rows of the same pixels, not filtered, compressed.
inline std::string rows_of(int count, const std::string& row) {
  std::string all;
  for (int y = 0; y < count; ++y) all += '\0' + row;
  return deflated(all);
}

inline std::string repeated(const std::string& part, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += part;
  return all;
}

/// Pixels of one colour, of `width` x `height` with 8 bits for each of its bytes.
inline std::string flat_data(int width, int height, const std::string& pixel) {
  return rows_of(height, repeated(pixel, width));
}

struct MadeFrame {
  std::uint32_t width = 4, height = 4, x = 0, y = 0;
  unsigned delay = 1, unit = 25;
  int after = 0, blend = 0;
};

/// fcTL
inline std::string control_of(std::uint32_t number, const MadeFrame& f = {}) {
  std::string data =
      u32(number) + u32(f.width) + u32(f.height) + u32(f.x) + u32(f.y) + u16(f.delay) + u16(f.unit);
  data += static_cast<char>(f.after);
  return data += static_cast<char>(f.blend);
}

/// acTL
inline std::string animation_of(std::uint32_t frames, std::uint32_t plays = 0) {
  return u32(frames) + u32(plays);
}

}  // namespace plumb
