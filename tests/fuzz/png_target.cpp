#include "render/image/apng.h"
#include "render/image/apng_player.h"
#include "render/image/image_difference.h"
#include "render/image/png.h"
#include "render/image/png_chunks.h"
#include "tests/fuzz/mended_png.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

void promise_image(const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  promise(image.width > 0 && image.height > 0 && image.rgb.size() == 3 * pixels,
          "a picture without its pixels");
  promise(image.alpha.empty() || image.alpha.size() == pixels, "opacities beside no pixels");
  promise(difference(image, image, {}).identical(), "a picture differs from itself");
}

void play(const std::string& bytes) {
  const std::string name = "a.png";
  const PngFile file = read_png_file(bytes, name);
  ApngPlayer player(file, name);
  for (std::size_t k = 0; k < file.frames.size(); ++k) {
    const Image& seen = player.show(k).image;
    promise(seen.width == file.width && seen.height == file.height, "a frame is shown in another size");
    promise_image(seen);
  }
}

bool feed_one(const std::string& bytes) {
  bool accepted = reads<InputError>([&] {
    const Image image = decode_png(bytes, "a.png");
    promise_image(image);
    const Image again = decode_png(encode_png(image, {}, PngEffort::quick), "b.png");
    promise(again == image, "a picture changes as it is written");
  });
  accepted &= reads<InputError>([&] { play(bytes); });
  reads<InputError>([&] {
    text_in_png(bytes, renderer_keyword, "a.png");
    const std::vector<std::string> frames = split_apng(bytes, "a.png");
    promise(!frames.empty(), "a picture of no frames");
    if (frames.size() > 1)
      reads<OutputError>([&] {
        promise(split_apng(join_apng(frames, 25), "b.png").size() == frames.size(),
                "frames are lost as they are joined");
      });
  });
  return accepted;
}

bool feed(std::string_view input) {
  const std::string bytes(input), mended = mended_png(input);
  const bool accepted = feed_one(bytes);
  return mended == bytes ? accepted : feed_one(mended) || accepted;
}

std::vector<std::string> seeds() {
  const std::string opaque = encode_png(small_image(3, 2, true, 0), {{"Renderer", "none"}});
  return {opaque, encode_png(small_image(5, 1, false, 9)),
          join_apng({{opaque, encode_png(small_image(3, 2, true, 90))}}, 25)};
}

}  // namespace

const Target png_target{"png", feed, seeds};

}  // namespace plumb::fuzz
