#include "render/image/few_colors.h"

#include <gtest/gtest.h>

#include "render/image/png.h"
#include "render/image/png_chunks.h"

namespace plumb {
namespace few_colors_test {

Image back(const FewColors& few, int width, int height) {
  Image image{width, height, {}};
  for (const std::uint8_t pixel : few.pixels)
    image.rgb.insert(image.rgb.end(), few.colors[pixel].begin(), few.colors[pixel].end());
  return image;
}

TEST(FewColors, KeepADrawingOfFewColorsAsItIs) {
  Image image{40, 6, {}};
  for (int k = 0; k < 240; ++k) {
    const auto part = static_cast<std::uint8_t>(16 * (k % 16) + 3);
    image.rgb.insert(image.rgb.end(), {part, static_cast<std::uint8_t>(255 - part), 9});
  }
  EXPECT_EQ(back(in_few_colors(image), 40, 6), image);
  EXPECT_EQ(decode_png(encode_png(image, {}, PngEffort::page), "a.png"), image);
}

TEST(FewColors, OfColorsThatAreAlikeTheMostFrequentStays) {
  Image image{4, 1, {250, 250, 250, 255, 255, 255, 255, 255, 255, 254, 255, 255}};
  const FewColors few = in_few_colors(image);
  ASSERT_EQ(few.colors.size(), 1U);
  EXPECT_EQ(few.colors[0], (std::array<std::uint8_t, 3>{255, 255, 255}));
}

TEST(FewColors, OfTooManyAreStillNear) {
  Image image{256, 64, {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 256; ++x)
      image.rgb.insert(image.rgb.end(), {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(4 * y),
                                         static_cast<std::uint8_t>((x + y) % 256)});
  const FewColors few = in_few_colors(image);
  ASSERT_LE(few.colors.size(), 256U);
  const Image shown = back(few, 256, 64);
  int greatest = 0;
  for (std::size_t k = 0; k < image.rgb.size(); ++k)
    greatest = std::max(greatest, std::abs(shown.rgb[k] - image.rgb[k]));
  EXPECT_LE(greatest, 48) << "of 255";
}

TEST(FewColors, TakeAByteAPixelOfAPngFile) {
  const Image image{2, 2, {1, 2, 3, 200, 2, 3, 1, 2, 3, 1, 2, 3}};
  const std::string bytes = encode_png(image, {}, PngEffort::page);
  EXPECT_EQ(png_chunks(bytes, "a.png").front().data.substr(8, 2), std::string_view("\x08\x03", 2))
      << "a palette";
  const Image clear{2, 1, {1, 2, 3, 4, 5, 6}, {255, 0}};
  EXPECT_EQ(decode_png(encode_png(clear, {}, PngEffort::page), "a.png"), clear) << "opacities are kept";
}

}  // namespace few_colors_test
}  // namespace plumb
