#include "render/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <limits>

#include "engine/errors.h"
#include "render/apng.h"
#include "tests/render/pictures.h"
#include "tests/render/swing.h"

namespace plumb {
namespace {

class SceneTest : public testing::Test {
 protected:
  GlContext context_;
};

TEST_F(SceneTest, AnimationOfTwoSecondsHas51Frames) {
  const Trajectory trajectory = swing();
  const auto start = std::chrono::steady_clock::now();
  SceneRenderer scene(context_, trajectory, swing_input());
  ASSERT_EQ(scene.frame_count(), 51);
  std::vector<std::string> frames;
  std::future<std::string> encoding;
  double drawing = 0;
  for (int k = 0; k < scene.frame_count(); ++k) {
    const auto before = std::chrono::steady_clock::now();
    Image image = scene.frame(k);
    drawing += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    if (encoding.valid()) frames.push_back(encoding.get());
    encoding = std::async(std::launch::async, [picture = std::move(image)] { return encode_png(picture); });
  }
  frames.push_back(encoding.get());
  const std::string animation = join_apng(frames, 25);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("51 frames: {:.2f} s, {:.2f} s of it drawing; {} bytes the frame, {} the animation\n", seconds, drawing,
             frames[20].size(), animation.size());
  for (const std::size_t k : {0, 8, 20, 35, 50}) keep(fmt::format("frame_{:02}", k), frames[k]);
  keep("animation", animation);
}

}  // namespace
}  // namespace plumb
