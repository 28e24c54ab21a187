#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// One chunk of a PNG file.
struct PngChunk {
  std::string_view type;  ///< four letters: "IHDR"
  std::string_view data;
};

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// The chunks of a PNG file, from IHDR to IEND, as views into `bytes`. Throws InputError that names `name`
/// when the file is not a PNG, ends early, or a check sum is wrong.
std::vector<PngChunk> png_chunks(std::string_view bytes, const std::string& name);
/// Not of a temporary, which the views would outlive.
std::vector<PngChunk> png_chunks(std::string&& bytes, const std::string& name) = delete;

/// Appends a chunk with its length and check sum.
void append_chunk(std::string& out, std::string_view type, std::string_view data);

/// Four bytes, the highest first, as PNG has its numbers.
void append_u32(std::string& out, std::uint32_t value);
std::uint32_t read_u32(std::string_view bytes);

}  // namespace plumb
