#include "engine/output/sha256.h"

#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <new>
#include <vector>

namespace plumb {
namespace {

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) throw std::bad_alloc();
  }
  void add(const void* bytes, std::size_t count) {
    if (EVP_DigestUpdate(context_.get(), bytes, count) != 1) throw std::bad_alloc();
  }
  std::string digits() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
    unsigned count = 0;
    if (EVP_DigestFinal_ex(context_.get(), sum.data(), &count) != 1) throw std::bad_alloc();
    constexpr char hexadecimal[] = "0123456789abcdef";
    std::string text;
    for (unsigned k = 0; k < count; ++k) {
      text += hexadecimal[sum[k] >> 4];
      text += hexadecimal[sum[k] & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
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
    if (count < 0 || static_cast<std::uintmax_t>(count) > size) return {};
    if (count == 0) return size == 0 ? std::optional(sum.digits()) : std::nullopt;
    sum.add(part.data(), static_cast<std::size_t>(count));
    size -= static_cast<std::uintmax_t>(count);
  }
}

}  // namespace plumb
