#include "render/frame_stream.h"

#include <deque>
#include <future>

#include "engine/interrupt.h"

namespace plumb {

void stream_frames(SceneRenderer& scene, const FrameRange& range, const PngTexts& texts, PngEffort effort,
                   const TakeFrame& take) {
  // The renderer has threads of its own, so that more frames under way than processors only cost memory.
  constexpr std::size_t waiting = 2;
  std::deque<std::pair<int, std::future<std::string>>> encoding;
  const auto take_first = [&] {
    take(encoding.front().first, encoding.front().second.get());
    encoding.pop_front();
  };
  for (int k = range.first; k <= range.last; ++k) {
    stop_if_interrupted();
    encoding.emplace_back(k, std::async(std::launch::async, [image = scene.frame(k), &texts, effort] {
                            return encode_png(image, texts, effort);
                          }));
    if (encoding.size() > waiting) take_first();
  }
  while (!encoding.empty()) take_first();
}

}  // namespace plumb
