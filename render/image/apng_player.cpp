#include "render/image/apng_player.h"

#include <algorithm>

#include "engine/base/interrupt.h"

namespace plumb {
namespace {

constexpr int full = 255;

Image clear_picture(int width, int height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint8_t>(3 * pixels), std::vector<std::uint8_t>(pixels)};
}

/// Mixes a pixel of an opacity over another, whose colour and opacity change.
void mix_over(const std::uint8_t* color, int alpha, std::uint8_t* under, std::uint8_t& under_alpha) {
  const int share = alpha * full, rest = (full - alpha) * under_alpha, all = share + rest;
  if (all == 0) return;
  for (int c = 0; c < 3; ++c)
    under[c] = static_cast<std::uint8_t>((color[c] * share + under[c] * rest + all / 2) / all);
  under_alpha = static_cast<std::uint8_t>((all + full / 2) / full);
}

/// Puts a frame in its place.
void put(const Image& image, const PngFrame& frame, Image& canvas) {
  const auto wide = static_cast<std::size_t>(canvas.width);
  std::size_t from = 0;
  for (int y = 0; y < image.height; ++y) {
    stop_if_interrupted();
    std::size_t to = static_cast<std::size_t>(frame.y + y) * wide + static_cast<std::size_t>(frame.x);
    for (int x = 0; x < image.width; ++x, ++from, ++to) {
      const int alpha = image.alpha.empty() ? full : image.alpha[from];
      if (frame.blends && alpha < full) {
        mix_over(&image.rgb[3 * from], alpha, &canvas.rgb[3 * to], canvas.alpha[to]);
        continue;
      }
      std::copy_n(&image.rgb[3 * from], 3, &canvas.rgb[3 * to]);
      canvas.alpha[to] = static_cast<std::uint8_t>(alpha);
    }
  }
}

void clear_part(const PngFrame& frame, Image& canvas) {
  for (int y = frame.y; y < frame.y + frame.height; ++y)
    std::fill_n(canvas.alpha.begin() + std::ptrdiff_t{y} * canvas.width + frame.x, frame.width,
                std::uint8_t{0});
}

}  // namespace

bool stands_alone(const PngFile& file, const PngFrame& frame) {
  return !frame.blends && frame.width == file.width && frame.height == file.height;
}

const PngPixels& ApngPlayer::show(std::size_t k) {
  if (shown_.image.rgb.empty()) shown_.image = clear_picture(file_.width, file_.height);
  // What a frame hides for good need not be drawn.
  for (std::size_t s = k + 1; s-- > drawn_;) {
    if (!stands_alone(file_, file_.frames[s]) || file_.frames[s].after == FrameAfter::is_undone) continue;
    drawn_ = s;
    last_ = nullptr;
    break;
  }
  while (drawn_ <= k) draw(file_.frames[drawn_++]);
  return shown_;
}

void ApngPlayer::draw(const PngFrame& frame) {
  if (last_ != nullptr && last_->after == FrameAfter::is_cleared) clear_part(*last_, shown_.image);
  if (last_ != nullptr && last_->after == FrameAfter::is_undone) shown_.image = before_;
  if (frame.after == FrameAfter::is_undone) before_ = shown_.image;
  const PngPixels drawn = decode_frame(file_, frame, name_);
  put(drawn.image, frame, shown_.image);
  constexpr std::uint64_t mixer = 0x9E3779B97F4A7C15U;
  shown_.finer = stands_alone(file_, frame) ? drawn.finer : shown_.finer * mixer + drawn.finer;
  last_ = &frame;
}

}  // namespace plumb
