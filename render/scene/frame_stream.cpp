#include "render/scene/frame_stream.h"

#include <deque>
#include <future>
#include <memory>

#include "engine/base/interrupt.h"

namespace plumb {

void stream_frames(SceneRenderer& scene, const FrameRange& range, const PngTexts& texts, PngEffort effort,
                   const TakeFrame& take) {
  // The renderer has threads of its own, so that more frames under way than processors only cost memory.
  constexpr std::size_t waiting = 2;
  struct Encoded {
    std::string png;
    Image image;  // for the memory of a later one
  };
  std::deque<std::pair<int, std::future<Encoded>>> encoding;
  Image spare;
  const auto take_first = [&] {
    Encoded encoded = encoding.front().second.get();
    take(encoding.front().first, std::move(encoded.png));
    spare = std::move(encoded.image);
    encoding.pop_front();
  };
  for (int k = range.first; k <= range.last; ++k) {
    stop_if_interrupted();
    Image image = std::move(spare);
    scene.frame(k, image);
    const auto encode = [image = std::make_shared<Image>(std::move(image)), &texts, effort] {
      std::string png = encode_png(*image, texts, effort);
      return Encoded{std::move(png), std::move(*image)};
    };
    // Where no thread is to be had the picture is encoded once it is asked for: by a copy of the function, as
    // the attempt at a thread uses one up.
    encoding.emplace_back(k, std::async(std::launch::async | std::launch::deferred, encode));
    if (encoding.size() > waiting) take_first();
  }
  while (!encoding.empty()) take_first();
}

}  // namespace plumb
