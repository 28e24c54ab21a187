#include "render/image/thumbnail.h"

#include <gtest/gtest.h>

namespace plumb {
namespace thumbnail_test {

Image plain(int width, int height, std::uint8_t level) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), level)};
}

TEST(Thumbnail, KeepsTheShapeAndNoPictureGrows) {
  const Image small = thumbnail(plain(640, 480, 255), 160);
  EXPECT_EQ(small.width, 160);
  EXPECT_EQ(small.height, 120);
  EXPECT_EQ(small.rgb, plain(160, 120, 255).rgb);
  EXPECT_EQ(thumbnail(plain(7, 3, 0), 160), plain(7, 3, 0));
  EXPECT_EQ(thumbnail(plain(1000, 1, 0), 10).height, 1);
}

TEST(Thumbnail, MixesLightAndNotLevels) {
  Image checks = plain(40, 20, 0);
  for (std::size_t k = 0; k < checks.rgb.size(); ++k) checks.rgb[k] = k / 3 % 2 == 0 ? 255 : 0;
  const Image small = thumbnail(checks, 10);
  // Half the light of white is level 188 of sRGB, of 32 levels the nearest of which is 189.
  for (const std::uint8_t level : small.rgb) EXPECT_EQ(level, 189);
}

TEST(Thumbnail, LaysWhatIsNotOpaqueOverWhite) {
  Image clear = plain(20, 20, 0);
  clear.alpha.assign(400, 0);
  EXPECT_EQ(thumbnail(clear, 10).rgb, plain(10, 10, 255).rgb);
  EXPECT_TRUE(thumbnail(clear, 10).alpha.empty());
}

}  // namespace thumbnail_test
}  // namespace plumb
