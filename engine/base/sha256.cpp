#include "engine/base/sha256.h"

#include <nettle/sha2.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>
#include <vector>

namespace plumb {
namespace {

/// Nettle's, which allocates nothing and so cannot fail.
class Sha256 {
 public:
  Sha256() { sha256_init(&context_); }
  void add(const void* bytes, std::size_t count) {
    sha256_update(&context_, count, static_cast<const std::uint8_t*>(bytes));
  }
  std::string digits() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> sum{};
    sha256_digest(&context_, sum.size(), sum.data());
    constexpr char hexadecimal[] = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : sum) {
      text += hexadecimal[byte >> 4];
      text += hexadecimal[byte & 15];
    }
    return text;
  }

 private:
  sha256_ctx context_{};
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Sha256 sum;
  sum.add(bytes.data(), bytes.size());
  return sum.digits();
}

std::optional<std::string> sha256_of(int file, std::uintmax_t size) {
  Sha256 sum;
  std::vector<char> part(std::size_t{1} << 18);
  for (;;) {
    const ssize_t count = ::read(file, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw std::system_error(errno, std::generic_category());
    if (static_cast<std::uintmax_t>(count) > size) return {};
    if (count == 0) return size == 0 ? std::optional(sum.digits()) : std::nullopt;
    sum.add(part.data(), static_cast<std::size_t>(count));
    size -= static_cast<std::uintmax_t>(count);
  }
}

}  // namespace plumb
