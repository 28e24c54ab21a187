#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "render/scene/frame_stream.h"
#include "tests/render/scene/swing.h"

namespace {

std::atomic<long> allocations{0};
std::atomic<long> bytes{0};
std::atomic<bool> counting{false};

}  // namespace

// The whole test program allocates by these; counted only where a test asks.
void* operator new(std::size_t size) {
  if (counting) {
    ++allocations;
    bytes += static_cast<long>(size);
  }
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace plumb {
namespace {

/// What drawing a frame allocates once those before it have been drawn.
struct PerFrame {
  double allocations = 0;
  double bytes = 0;
};

PerFrame drawing(int width, int height) {
  const GlContext context;
  const Trajectory trajectory = swing(31);
  SceneInput input = swing_input();
  input.spec.size = {width, height};
  SceneRenderer scene(context, trajectory, input);
  Image picture;
  for (int k = 0; k < scene.frame_count(); ++k) scene.frame(k, picture);
  allocations = bytes = 0;
  counting = true;
  for (int k = 0; k < scene.frame_count(); ++k) scene.frame(k, picture);
  counting = false;
  const double frames = scene.frame_count();
  return {static_cast<double>(allocations) / frames, static_cast<double>(bytes) / frames};
}

TEST(FrameMemory, NothingOfAPicturesSizeIsAllocatedForAFrame) {
  const PerFrame small = drawing(240, 135), large = drawing(960, 540);
  fmt::print(
      "a frame allocates {:.0f} times, {:.0f} bytes at 240 x 135; {:.0f} times, {:.0f} bytes at 960 x 540\n",
      small.allocations, small.bytes, large.allocations, large.bytes);
  EXPECT_GT(small.allocations, 0) << "nothing is counted";
  // What is left are the curve, its mesh and the texts, which grow with the cable's length in pixels.
  EXPECT_LT(large.bytes, 960 * 540) << "less than a byte a pixel, of which the picture has three";
  EXPECT_LT(large.bytes, 8 * small.bytes) << "16 times as many pixels";
}

TEST(FrameMemory, APictureDrawnIntoAnotherIsTheSame) {
  const GlContext context;
  const Trajectory trajectory = swing();
  SceneInput input = swing_input();
  input.spec.size = {96, 54};
  SceneRenderer scene(context, trajectory, input);
  Image picture = scene.frame(3);
  const void* const memory = picture.rgb.data();
  scene.frame(20, picture);
  EXPECT_EQ(picture, scene.frame(20));
  EXPECT_EQ(static_cast<const void*>(picture.rgb.data()), memory);
}

}  // namespace
}  // namespace plumb
