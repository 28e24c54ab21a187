#include "render/image/png_pixels.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <new>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "render/image/png_chunks.h"

namespace plumb {
namespace {

/// A PNG file of nothing but what its pixels need: libpng is given no text, profile or unknown chunk.
std::string bare_png(const PngFile& file, int width, int height, const std::vector<std::string_view>& data) {
  std::string png(png_signature);
  std::string header;
  append_u32(header, static_cast<std::uint32_t>(width));
  append_u32(header, static_cast<std::uint32_t>(height));
  constexpr std::size_t size_bytes = 8;
  append_chunk(png, "IHDR", header.append(file.header.substr(size_bytes)));
  if (!file.palette.empty()) append_chunk(png, "PLTE", file.palette);
  if (!file.opacity.empty()) append_chunk(png, "tRNS", file.opacity);
  for (const std::string_view part : data) append_chunk(png, "IDAT", part);
  append_chunk(png, "IEND", {});
  return png;
}

void read_bytes(png_structp png, png_bytep to, std::size_t size) {
  auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (size > rest.size()) png_error(png, "too few bytes");
  std::copy_n(rest.begin(), size, to);
  rest.remove_prefix(size);
}

[[noreturn]] void jump(png_structp png, png_const_charp /*message*/) {
  png_longjmp(png, 1);
}

void say_nothing(png_structp /*png*/, png_const_charp /*message*/) {}

/// What libpng keeps while it reads.
struct Decoder {
  explicit Decoder(png_structp made) : png(made) {}
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  png_structp png;
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
};

/// Takes rows of red, green, blue and opacity.
class Taker {
 public:
  Taker(int width, int height) : width_(static_cast<std::size_t>(width)) {
    const std::size_t pixels = width_ * static_cast<std::size_t>(height);
    image_.width = width;
    image_.height = height;
    image_.rgb.resize(3 * pixels);
    image_.alpha.resize(pixels);
  }

  void take(std::size_t y, const png_byte* row, bool deep) {
    for (std::size_t x = 0; x < width_; ++x) {
      const std::size_t pixel = y * width_ + x;
      // No colour is seen where nothing is opaque.
      const bool unseen = deep && row[8 * x + 6] == 0 && row[8 * x + 7] == 0;
      for (std::size_t c = 0; c < 4; ++c) {
        const std::size_t from = 4 * x + c;
        const std::uint8_t level = unseen ? 0 : deep ? reduced(row + 2 * from, 4 * pixel + c) : row[from];
        (c < 3 ? image_.rgb[3 * pixel + c] : image_.alpha[pixel]) = level;
        opaque_ = opaque_ && (c < 3 || level == 255);
      }
    }
  }

  PngPixels taken() {
    if (opaque_) image_.alpha = {};
    return {std::move(image_), finer_};
  }

 private:
  /// The nearest of 8 bits; what is left over goes into the mark, with its place.
  std::uint8_t reduced(const png_byte* two, std::size_t place) {
    constexpr unsigned step = 257;
    constexpr std::uint64_t mixer = 0x9E3779B97F4A7C15U;
    const unsigned value = two[0] * 256U + two[1], level = (value + step / 2) / step;
    if (value != level * step) finer_ = (finer_ ^ (place * 65536U + value)) * mixer + 1;
    return static_cast<std::uint8_t>(level);
  }

  std::size_t width_;
  Image image_;
  bool opaque_ = true;
  std::uint64_t finer_ = 0;
};

// Nothing in these two functions has a destructor, as libpng's errors jump out of what they call; what they
// throw themselves passes none of libpng.
bool begin_rows(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, most_png_side, most_png_side);
  png_read_info(png, info);
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool read_rows(png_structp png, std::vector<png_byte>& rows, std::size_t height, int passes, bool deep,
               Taker& taker) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const std::size_t stride = passes > 1 ? rows.size() / height : 0;
  for (int pass = 1; pass <= passes; ++pass)
    for (std::size_t y = 0; y < height; ++y) {
      stop_if_interrupted();
      png_byte* row = rows.data() + y * stride;
      png_read_row(png, row, nullptr);
      if (pass == passes) taker.take(y, row, deep);
    }
  return true;
}

PngPixels decode(const std::string& bytes, int width, int height, const std::string& name) {
  std::string_view rest = bytes;
  const Decoder decoder(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, jump, say_nothing));
  if (decoder.info == nullptr) throw std::bad_alloc();
  png_set_read_fn(decoder.png, &rest, read_bytes);
  if (!begin_rows(decoder.png, decoder.info))
    throw InputError(name + ": the PNG file is damaged before its pixels");
  const bool interlaced = png_get_interlace_type(decoder.png, decoder.info) != PNG_INTERLACE_NONE;
  constexpr int passes_of_interlaced = 7;
  const std::size_t rows = interlaced ? static_cast<std::size_t>(height) : 1;
  std::vector<png_byte> buffer(rows * png_get_rowbytes(decoder.png, decoder.info));
  Taker taker(width, height);
  if (!read_rows(decoder.png, buffer, static_cast<std::size_t>(height), interlaced ? passes_of_interlaced : 1,
                 png_get_bit_depth(decoder.png, decoder.info) > 8, taker))
    throw InputError(name + ": the pixels of the PNG file are damaged");
  return taker.taken();
}

}  // namespace

PngPixels decode_still(const PngFile& file, const std::string& name) {
  return decode(bare_png(file, file.width, file.height, file.data), file.width, file.height, name);
}

PngPixels decode_frame(const PngFile& file, const PngFrame& frame, const std::string& name) {
  return decode(png_of_frame(file, frame), frame.width, frame.height, name);
}

std::string png_of_frame(const PngFile& file, const PngFrame& frame) {
  return bare_png(file, frame.width, frame.height, frame.data);
}

}  // namespace plumb
