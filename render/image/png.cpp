#include "render/image/png.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <new>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "render/image/few_colors.h"
#include "render/image/png_chunks.h"
#include "render/image/png_pixels.h"

namespace plumb {

namespace {

// Measured on frames and plots: drawings with flat areas are smallest, and soonest written, without a filter.
// Level 9 would save another 5 to 10 % over level 6 and take four times as long; level 3 takes half as long
// for 14 % more, and level 1 hardly less than that for 24 % more.
constexpr int compression_level(PngEffort effort) {
  return effort == PngEffort::quick ? 3 : 6;
}
constexpr int filters = PNG_FILTER_NONE;

struct Sink {
  std::string bytes;
  std::string error;
};

/// What libpng keeps while it writes.
struct Writer {
  explicit Writer(png_structp made) : png(made) {}
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  png_structp png;
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
};

void write_bytes(png_structp png, png_bytep data, std::size_t size) {
  static_cast<Sink*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), size);
}

void flush_nothing(png_structp /*png*/) {}

// For warnings as well: they tell of texts that would be left out.
[[noreturn]] void keep_error(png_structp png, png_const_charp message) {
  static_cast<Sink*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void interleave(const Image& image, std::size_t row, std::vector<std::uint8_t>& rgba) {
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t x = 0; x < width; ++x) {
    const std::size_t pixel = row * width + x;
    for (std::size_t c = 0; c < 3; ++c) rgba[4 * x + c] = image.rgb[3 * pixel + c];
    rgba[4 * x + 3] = image.alpha[pixel];
  }
}

// Nothing in this function has a destructor, as libpng's errors jump out of what it calls; what it throws
// itself passes none of libpng. `rgba` has room for a row where the picture has opacities; `palette` has
// colours where it is written with them.
bool write(png_structp png, png_infop info, const Image& image, const std::vector<png_text>& texts,
           std::vector<std::uint8_t>& rgba, const std::vector<png_color>& palette, const FewColors& few,
           int level) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               !palette.empty() ? PNG_COLOR_TYPE_PALETTE
               : rgba.empty()   ? PNG_COLOR_TYPE_RGB
                                : PNG_COLOR_TYPE_RGBA,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, level);
  png_set_compression_buffer_size(png, 1U << 18);  // few, large IDAT chunks
  png_set_filter(png, PNG_FILTER_TYPE_BASE, filters);
  if (!texts.empty()) png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
  png_write_info(png, info);
  const std::vector<std::uint8_t>& bytes = palette.empty() ? image.rgb : few.pixels;
  const std::size_t stride = (palette.empty() ? std::size_t{3} : 1) * static_cast<std::size_t>(image.width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
    stop_if_interrupted();
    if (!rgba.empty()) interleave(image, row, rgba);
    png_write_row(png, rgba.empty() ? bytes.data() + row * stride : rgba.data());
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string encode_png(const Image& image, const PngTexts& texts, PngEffort effort) {
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.rgb.size() != 3 * pixels ||
      (!image.alpha.empty() && image.alpha.size() != pixels))
    throw OutputError(
        fmt::format("PNG: a picture of {} x {} pixels with {} bytes and {} opacities cannot be written",
                    image.width, image.height, image.rgb.size(), image.alpha.size()));
  std::vector<std::uint8_t> rgba(image.alpha.empty() ? 0 : 4 * static_cast<std::size_t>(image.width));
  std::vector<png_text> entries;
  for (const auto& [key, value] : texts) {
    png_text entry{};
    entry.compression = PNG_TEXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(key.c_str());  // libpng only reads it
    entry.text = const_cast<char*>(value.c_str());
    entry.text_length = value.size();
    entries.push_back(entry);
  }

  FewColors few;
  if (effort == PngEffort::page && image.alpha.empty()) few = in_few_colors(image);
  std::vector<png_color> palette;
  for (const auto& [red, green, blue] : few.colors) palette.push_back({red, green, blue});

  Sink sink;
  const Writer writer(png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, keep_error, keep_error));
  if (writer.info == nullptr) throw std::bad_alloc();
  png_set_write_fn(writer.png, &sink, write_bytes, flush_nothing);
  if (!write(writer.png, writer.info, image, entries, rgba, palette, few, compression_level(effort)))
    throw OutputError("PNG: " + sink.error);
  return std::move(sink.bytes);
}

std::optional<std::string> text_in_png(std::string_view bytes, const std::string& keyword,
                                       const std::string& name) {
  for (const PngChunk& chunk : png_chunks(bytes, name)) {
    const std::size_t end = chunk.data.find('\0');
    if (chunk.type == "tEXt" && end != std::string_view::npos && chunk.data.substr(0, end) == keyword)
      return std::string(chunk.data.substr(end + 1));
  }
  return {};
}

Image decode_png(std::string_view bytes, const std::string& name) {
  return decode_still(read_png_file(bytes, name), name).image;
}

}  // namespace plumb
