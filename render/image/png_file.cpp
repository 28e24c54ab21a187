#include "render/image/png_file.h"

#include <fmt/format.h>

#include <optional>

#include "engine/base/errors.h"
#include "render/image/png_chunks.h"

namespace plumb {
namespace {

/// Bits of a pixel, or nothing for a kind that PNG does not know.
std::optional<int> bits_a_pixel(int depth, int kind) {
  const bool whole = depth == 8 || depth == 16;
  const bool part = depth == 1 || depth == 2 || depth == 4;
  switch (kind) {
    case 0:
      return whole || part ? std::optional(depth) : std::nullopt;
    case 3:
      return part || depth == 8 ? std::optional(depth) : std::nullopt;
    case 2:
      return whole ? std::optional(3 * depth) : std::nullopt;
    case 4:
      return whole ? std::optional(2 * depth) : std::nullopt;
    case 6:
      return whole ? std::optional(4 * depth) : std::nullopt;
    default:
      return {};
  }
}

/// What its chunks say of its colours.
struct ColorChunks {
  std::string_view coding, profile, gamma, primaries, turned;
  bool srgb = false;

  /// Of chunks that contradict each other the first in the standard's order counts.
  std::string in_all() const {
    constexpr std::string_view gamma_of_srgb("\0\0\xB1\x8F", 4);
    constexpr std::string_view primaries_of_srgb(
        "\0\0\x7A\x26\0\0\x80\x84\0\0\xFA\0\0\0\x80\xE8\0\0\x75\x30\0\0\xEA\x60\0\0\x3A\x98\0\0\x17\x70", 32);
    std::string all;
    const auto add = [&](std::string_view type, std::string_view data) {
      if (!data.empty()) append_chunk(all, type, data);
    };
    if (!coding.empty())
      add("cICP", coding);
    else if (!profile.empty())
      add("iCCP", profile);
    else if (!srgb) {
      if (gamma != gamma_of_srgb) add("gAMA", gamma);
      if (primaries != primaries_of_srgb) add("cHRM", primaries);
    }
    add("eXIf", turned);
    return all;
  }
};

/// Goes through the chunks in their order.
class ChunkReader {
 public:
  explicit ChunkReader(const std::string& name) : name_(name) {}

  PngFile read(const std::vector<PngChunk>& chunks) {
    read_header(chunks.front().data);
    for (std::size_t i = 1; i < chunks.size(); ++i) take(chunks[i]);
    if (file_.data.empty()) refuse("there are no pixels");
    check_holds(file_.data, file_.width, file_.height);
    finish_frame();
    if (!file_.frames.empty() && file_.frames.size() != announced_)
      refuse(fmt::format("{} frames are announced and {} are there", announced_, file_.frames.size()));
    if (1.0 * file_.width * file_.height * static_cast<double>(file_.frames.size()) > most_apng_pixels)
      refuse(fmt::format("{} frames of {} x {} pixels: at most {:g} pixels in all can be read",
                         file_.frames.size(), file_.width, file_.height, most_apng_pixels));
    file_.color_space = color_.in_all();
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("{}: {}", name_, why));
  }

  void read_header(std::string_view data) {
    constexpr std::size_t depth_at = 8, kind_at = 9, compression_at = 10, filter_at = 11, interlace_at = 12;
    const auto byte = [&](std::size_t at) { return int{static_cast<unsigned char>(data[at])}; };
    const std::uint32_t width = read_u32(data), height = read_u32(data.substr(4));
    if (width == 0 || height == 0) refuse(fmt::format("{} x {} pixels are no picture", width, height));
    if (width > most_png_side || height > most_png_side || 1.0 * width * height > most_png_pixels)
      refuse(fmt::format("{} x {} pixels: at most {} a side and {:g} in all can be read", width, height,
                         most_png_side, most_png_pixels));
    const auto bits = bits_a_pixel(byte(depth_at), byte(kind_at));
    if (!bits || byte(compression_at) != 0 || byte(filter_at) != 0 || byte(interlace_at) > 1)
      refuse("the header is of no kind of PNG");
    file_.width = static_cast<int>(width);
    file_.height = static_cast<int>(height);
    file_.header = data;
    bits_ = *bits;
    indexed_ = byte(kind_at) == 3;
  }

  /// Refuses pixels that the data cannot hold, before there is room for them: nothing is compressed to less
  /// than one byte in 1032.
  void check_holds(const std::vector<std::string_view>& data, int width, int height) const {
    constexpr double most_inflated = 1032;
    double bytes = 0;
    for (const std::string_view part : data) bytes += static_cast<double>(part.size());
    const double needed = 1.0 * width * height * bits_ / 8;
    if (needed > most_inflated * bytes)
      refuse(fmt::format("{} x {} pixels cannot be in {:.0f} bytes of data", width, height, bytes));
  }

  void take(const PngChunk& chunk) {
    const std::string_view type = chunk.type, data = chunk.data;
    const bool again = pixels_ == Pixels::going_on && type == "IDAT";
    if (pixels_ == Pixels::going_on && !again) pixels_ = Pixels::over;
    if (type == "IDAT")
      take_pixels(data);
    else if (type == "PLTE")
      take_palette(data);
    else if (type == "tRNS")
      take_opacity(data);
    else if (type == "acTL")
      take_animation(data);
    else if (type == "fcTL")
      take_frame(data);
    else if (type == "fdAT")
      take_frame_pixels(data);
    else if (type == "cICP")
      color_.coding = before_pixels(chunk);
    else if (type == "iCCP")
      color_.profile = before_pixels(chunk);
    else if (type == "sRGB")
      color_.srgb = !before_pixels(chunk).empty();
    else if (type == "gAMA")
      color_.gamma = before_pixels(chunk);
    else if (type == "cHRM")
      color_.primaries = before_pixels(chunk);
    else if (type == "eXIf")
      color_.turned = data;
    else if (type != "IEND" && type.front() >= 'A' && type.front() <= 'Z')
      refuse(type == "IHDR" ? "there are two headers" : "it has a chunk that is in no PNG file");
  }

  std::string_view before_pixels(const PngChunk& chunk) const {
    if (pixels_ != Pixels::to_come) refuse(fmt::format("{} comes after the pixels", chunk.type));
    return chunk.data;
  }

  void take_pixels(std::string_view data) {
    if (pixels_ == Pixels::over) refuse("the pixels are torn apart");
    pixels_ = Pixels::going_on;
    file_.data.push_back(data);
    if (file_.still_is_frame) file_.frames.front().data.push_back(data);
  }

  void take_palette(std::string_view data) {
    if (pixels_ != Pixels::to_come || !file_.palette.empty() || data.empty() || data.size() % 3 != 0 ||
        data.size() > 3 * 256)
      refuse("the palette is of no kind that PNG has");
    file_.palette = data;
  }

  void take_opacity(std::string_view data) {
    if (pixels_ != Pixels::to_come || !file_.opacity.empty() || data.empty() ||
        (indexed_ && file_.palette.empty()))
      refuse("the opacities stand in a wrong place");
    file_.opacity = data;
  }

  void take_animation(std::string_view data) {
    if (pixels_ != Pixels::to_come || file_.says_animated || data.size() != 8)
      refuse("the control of the animation is damaged or in a wrong place");
    file_.says_animated = true;
    announced_ = read_u32(data);
    file_.plays = read_u32(data.substr(4));
  }

  void check_sequence(std::string_view data) {
    if (!file_.says_animated) refuse("there are frames without a control of the animation before them");
    if (const std::uint32_t number = read_u32(data); number != sequence_)
      refuse(fmt::format("a part of the animation has the number {} for {}", number, sequence_));
    ++sequence_;
  }

  void finish_frame() const {
    if (file_.frames.empty()) return;
    const PngFrame& last = file_.frames.back();
    if (last.data.empty()) refuse(fmt::format("frame {} has no pixels", file_.frames.size()));
    check_holds(last.data, last.width, last.height);
  }

  void take_frame(std::string_view data) {
    constexpr std::size_t size = 26, after_at = 24, blend_at = 25;
    if (data.size() != size) refuse("the control of a frame is damaged");
    check_sequence(data);
    const std::size_t number = file_.frames.size() + 1;
    if (pixels_ == Pixels::to_come && number > 1) refuse("there are two first frames");
    if (pixels_ != Pixels::to_come) finish_frame();
    const auto word = [&](std::size_t at) { return read_u32(data.substr(at)); };
    const std::uint32_t width = word(4), height = word(8), x = word(12), y = word(16), shown = word(20);
    const auto all_width = static_cast<std::uint32_t>(file_.width),
               all_height = static_cast<std::uint32_t>(file_.height);
    if (width == 0 || height == 0 || width > all_width || height > all_height || x > all_width - width ||
        y > all_height - height)
      refuse(fmt::format("frame {}, {} x {} pixels at ({}, {}), is not within the picture", number, width,
                         height, x, y));
    const bool still = pixels_ == Pixels::to_come;
    if (still && (width != all_width || height != all_height))
      refuse("the first frame is but a part of the still picture");
    const auto after = static_cast<unsigned char>(data[after_at]),
               blend = static_cast<unsigned char>(data[blend_at]);
    if (after > 2 || blend > 1) refuse(fmt::format("frame {} is drawn in no way that PNG has", number));
    PngFrame frame{static_cast<int>(x), static_cast<int>(y), static_cast<int>(width),
                   static_cast<int>(height)};
    frame.delay = shown >> 16U;
    if (const std::uint32_t unit = shown & 0xFFFFU; unit != 0) frame.delay_unit = unit;
    frame.after = after == 0   ? FrameAfter::stays
                  : after == 1 ? FrameAfter::is_cleared
                               : FrameAfter::is_undone;
    frame.blends = blend == 1;
    file_.still_is_frame = file_.still_is_frame || still;
    file_.frames.push_back(std::move(frame));
  }

  void take_frame_pixels(std::string_view data) {
    constexpr std::size_t number_size = 4;
    if (data.size() < number_size) refuse("a part of the animation is damaged");
    check_sequence(data);
    // What stands before the second control can only be more of the still picture.
    if (pixels_ == Pixels::to_come || file_.frames.size() <= (file_.still_is_frame ? 1U : 0U))
      refuse("there are pixels of a frame without its control");
    file_.frames.back().data.push_back(data.substr(number_size));
  }

  enum class Pixels { to_come, going_on, over };

  std::string name_;
  PngFile file_;
  ColorChunks color_;
  Pixels pixels_ = Pixels::to_come;
  int bits_ = 0;
  bool indexed_ = false;
  std::uint32_t announced_ = 0;
  std::uint32_t sequence_ = 0;
};

}  // namespace

PngFile read_png_file(std::string_view bytes, const std::string& name) {
  return ChunkReader(name).read(png_chunks(bytes, name));
}

}  // namespace plumb
