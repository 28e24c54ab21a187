#include "render/image/tiles.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/errors.h"
#include "tests/render/image/pictures.h"
#include "tests/render/scene/swing.h"

namespace plumb {
namespace tiles_test {

TEST(Tiles, CoverThePictureOnce) {
  for (const auto& [width, height, most] :
       {std::array{100, 60, 100}, std::array{100, 60, 32}, std::array{7, 9, 3}}) {
    std::vector<int> covered(static_cast<std::size_t>(width * height));
    for (const Tile& tile : tiles_of(width, height, most)) {
      EXPECT_LE(tile.width, most);
      EXPECT_LE(tile.height, most);
      for (int y = tile.top; y < std::min(height, tile.top + tile.height); ++y)
        for (int x = tile.left; x < std::min(width, tile.left + tile.width); ++x)
          ++covered[static_cast<std::size_t>(y * width + x)];
    }
    for (const int count : covered) EXPECT_EQ(count, 1);
  }
}

TEST(Tiles, TakeTheirCornersToThoseOfTheView) {
  const Tile tile{300, 200, 100, 50};
  const Color t = tile_transform(tile, 800, 600);
  const auto at = [&](double x, double y) {  // pixels to the tile's clip coordinates
    return std::pair{(2 * x / 800 - 1) * t.r + t.b, (1 - 2 * y / 600) * t.g + t.a};
  };
  EXPECT_NEAR(at(300, 200).first, -1, 1e-6);
  EXPECT_NEAR(at(300, 200).second, 1, 1e-6);
  EXPECT_NEAR(at(400, 250).first, 1, 1e-6);
  EXPECT_NEAR(at(400, 250).second, -1, 1e-6);
}

std::size_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

TEST(Tiles, GiveThePixelsOfAPictureDrawnAtOnceButForRounding) {
  const GlContext context;
  const Trajectory trajectory = swing();
  struct Look {
    int supersampling;
    View view;
    SceneBackground background;
  };
  for (const Look& look :
       {Look{1, View::fit, SceneBackground::scene}, Look{2, View::orbit, SceneBackground::scene},
        Look{2, View::fit, SceneBackground::transparent}, Look{3, View::top, SceneBackground::scene}}) {
    SceneInput input = swing_input();
    input.spec.size = {300, 200};
    input.spec.supersampling = look.supersampling;
    input.spec.view = look.view;
    input.spec.background = look.background;
    input.spec.ghosts = 2;
    input.points.push_back({"points", {0, 0.3}, {{0.3, -0.2, 0.1}, {-0.4, -0.5, 0.2}}, {}});
    const Image whole = SceneRenderer(context, trajectory, input).frame(30);
    const Image tiled = SceneRenderer(context, trajectory, input, 64).frame(30);
    ASSERT_EQ(tiled.width, 300);
    ASSERT_EQ(tiled.rgb.size(), whole.rgb.size());
    ASSERT_EQ(tiled.alpha.size(), whole.alpha.size());
    // Places within a tile are rounded otherwise, which an edge shows here and there.
    EXPECT_LE(differing(whole.rgb, tiled.rgb), whole.rgb.size() / 2000) << look.supersampling;
    EXPECT_LE(differing(whole.alpha, tiled.alpha), whole.alpha.size() / 2000) << look.supersampling;
    fmt::print("supersampling {}: {} of {} bytes differ in tiles\n", look.supersampling,
               differing(whole.rgb, tiled.rgb), whole.rgb.size());
  }
}

TEST(Tiles, LetPicturesBeLargerThanTheRendererDraws) {
  const GlContext context;
  const Trajectory trajectory = swing(1);
  SceneInput input = swing_input();
  input.spec.size = {context.info().max_size + 100, 40};
  input.spec.supersampling = 1;
  input.spec.cable_radius = 0.1;
  SceneRenderer scene(context, trajectory, input);
  const Image image = scene.frame(0);
  ASSERT_EQ(image.width, input.spec.size[0]);
  ASSERT_EQ(image.rgb.size(), 3U * 40U * static_cast<std::size_t>(image.width));
  const Point tip = scene.pixel(trajectory.q[0].segment<3>(18));
  const auto i =
      static_cast<std::size_t>(3 * (static_cast<int>(tip.y()) * image.width + static_cast<int>(tip.x())));
  EXPECT_GT(image.rgb[i + 2], image.rgb[i] + 40) << "no cable at " << tip.transpose();
}

TEST(Tiles, OfPicturesBeyondAllBoundsAreRefused) {
  const GlContext context;
  const Trajectory trajectory = swing(1);
  SceneInput input = swing_input();
  input.spec.size = {32769, 16};
  EXPECT_THROW(SceneRenderer(context, trajectory, input), OutputError);
}

}  // namespace tiles_test
}  // namespace plumb
