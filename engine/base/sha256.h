#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

/// SHA-256 of some bytes, 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// SHA-256 of the next `size` bytes of an open file; nothing if it has not just as many.
/// Throws std::system_error if it cannot be read.
std::optional<std::string> sha256_of(int file, std::uintmax_t size);

}  // namespace plumb
