#include "render/image/png_chunks.h"

#include <fmt/format.h>
#include <zlib.h>

#include "engine/base/errors.h"

namespace plumb {

namespace {

std::uint32_t check_sum(std::string_view type, std::string_view data) {
  const auto add = [](uLong sum, std::string_view bytes) {
    // zlib starts anew when it is given no data at all.
    return bytes.empty() ? sum : crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  };
  return static_cast<std::uint32_t>(add(add(0, type), data));
}

}  // namespace

std::vector<PngChunk> png_chunks(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(png_signature)) throw InputError(fmt::format("{}: not a PNG file", name));
  std::vector<PngChunk> chunks;
  std::size_t at = png_signature.size();
  while (chunks.empty() || chunks.back().type != "IEND") {
    constexpr std::size_t around = 12;  // length, type and check sum
    const std::size_t length = bytes.size() - at < around ? 0 : read_u32(bytes.substr(at));
    if (bytes.size() - at < around + length)
      throw InputError(fmt::format("{}: the PNG data end early, after {} bytes", name, bytes.size()));
    const PngChunk chunk{bytes.substr(at + 4, 4), bytes.substr(at + 8, length)};
    if (read_u32(bytes.substr(at + 8 + length)) != check_sum(chunk.type, chunk.data))
      throw InputError(fmt::format("{}: the check sum of the PNG chunk at byte {} is wrong", name, at));
    chunks.push_back(chunk);
    at += around + length;
  }
  if (chunks.front().type != "IHDR" || chunks.front().data.size() != 13)
    throw InputError(fmt::format("{}: the PNG file does not begin with its header", name));
  return chunks;
}

void append_chunk(std::string& out, std::string_view type, std::string_view data) {
  append_u32(out, static_cast<std::uint32_t>(data.size()));
  out.append(type);
  out.append(data);
  append_u32(out, check_sum(type, data));
}

void append_u32(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>((value >> shift) & 255U));
}

std::uint32_t read_u32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = (value << 8) | static_cast<unsigned char>(byte);
  return value;
}

}  // namespace plumb
