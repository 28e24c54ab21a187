#include "render/gl/utf8.h"

#include <cstddef>

namespace plumb {

namespace {

constexpr char32_t replacement = 0xFFFD;

// Bytes that follow a lead byte, or -1 if it cannot lead.
int followers(unsigned char lead) {
  if (lead < 0x80) return 0;
  if (lead >= 0xC2 && lead < 0xE0) return 1;
  if (lead >= 0xE0 && lead < 0xF0) return 2;
  if (lead >= 0xF0 && lead < 0xF5) return 3;
  return -1;
}

bool is_character(char32_t point, int follower_count) {
  constexpr char32_t smallest[] = {0, 0x80, 0x800, 0x10000};  // less could have been written shorter
  return point >= smallest[follower_count] && point <= 0x10FFFF && !(point >= 0xD800 && point < 0xE000);
}

}  // namespace

std::u32string decode_utf8(std::string_view text) {
  std::u32string points;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int n = followers(lead);
    char32_t point = n > 0 ? lead & (0x3FU >> n) : lead;
    bool valid = n >= 0 && i + static_cast<std::size_t>(n) < text.size();
    for (int k = 1; valid && k <= n; ++k) {
      const auto byte = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      valid = (byte & 0xC0) == 0x80;
      point = (point << 6) | (byte & 0x3FU);
    }
    valid = valid && is_character(point, n);
    points.push_back(valid ? point : replacement);
    i += valid ? static_cast<std::size_t>(n) + 1 : 1;
  }
  return points;
}

void append_utf8(std::string& text, char32_t point) {
  constexpr char32_t bits_of_a_byte = 6;
  const auto follow = [&](char32_t from) { text += static_cast<char>(0x80U | ((point >> from) & 0x3FU)); };
  if (point < 0x80) {
    text += static_cast<char>(point);
    return;
  }
  if (point < 0x800) {
    text += static_cast<char>(0xC0U | (point >> bits_of_a_byte));
  } else if (point < 0x10000) {
    text += static_cast<char>(0xE0U | (point >> 2 * bits_of_a_byte));
    follow(bits_of_a_byte);
  } else {
    text += static_cast<char>(0xF0U | (point >> 3 * bits_of_a_byte));
    follow(2 * bits_of_a_byte);
    follow(bits_of_a_byte);
  }
  follow(0);
}

}  // namespace plumb
