#include "render/image/image_difference.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "render/gl/gl_context.h"
#include "render/gl/painter.h"

namespace plumb {
namespace image_difference_test {

Image plain(int width, int height, std::uint8_t level = 255) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), level)};
}

void set(Image& image, int x, int y, std::uint8_t level) {
  for (int c = 0; c < 3; ++c) image.rgb[static_cast<std::size_t>(3 * (y * image.width + x) + c)] = level;
}

TEST(ImageDifference, OfAPictureToItselfIsNone) {
  const Image image = plain(40, 30, 128);
  const ImageDifference found = difference(image, image, {});
  EXPECT_TRUE(found.identical());
  EXPECT_EQ(found.density, 0);
}

TEST(ImageDifference, OfSizesIsItsOwn) {
  const ImageDifference found = difference(plain(40, 30), plain(41, 30), {});
  EXPECT_FALSE(found.same_size);
  EXPECT_FALSE(found.within({255, 1.0}));
}

TEST(ImageDifference, CountsPixelsAndLevels) {
  const Image a = plain(64, 48);
  Image b = a;
  set(b, 10, 10, 247);  // within the tolerance of 8 levels
  set(b, 50, 40, 200);
  set(b, 51, 40, 100);
  set(b, 3, 3, 0);
  const ImageDifference found = difference(a, b, {8, 0.01});
  EXPECT_EQ(found.changed, 4);
  EXPECT_EQ(found.beyond, 3);
  EXPECT_EQ(found.greatest, 255);
  EXPECT_DOUBLE_EQ(found.density, 2.0 / 256) << "the two that are near each other";
  EXPECT_LE(found.x, 50);
  EXPECT_GT(found.x + difference_window, 51);
}

TEST(ImageDifference, TheWindowHoldsNoMoreThanItsSize) {
  const Image a = plain(64, 48);
  for (const int apart : {difference_window - 1, difference_window}) {
    Image beside = a, above = a;
    for (const int place : {0, apart}) {
      set(beside, place, 9, 0);
      set(above, 9, place, 0);
    }
    const double expected = (apart < difference_window ? 2.0 : 1.0) / (difference_window * difference_window);
    EXPECT_DOUBLE_EQ(difference(a, beside, {}).density, expected) << apart;
    EXPECT_DOUBLE_EQ(difference(a, above, {}).density, expected) << apart;
  }
}

TEST(ImageDifference, OfOnePixelIsWhereThatIs) {
  const Image a = plain(64, 48);
  Image b = a;
  set(b, 50, 40, 0);
  const ImageDifference found = difference(a, b, {});
  EXPECT_EQ(found.x, 50 - difference_window + 1) << "the first window that has it";
  EXPECT_EQ(found.y, 40 - difference_window + 1);
}

TEST(ImageDifference, OneLevelEverywhereIsWithinTheToleranceButNotIdentical) {
  const ImageDifference found = difference(plain(64, 48, 100), plain(64, 48, 101), {});
  EXPECT_FALSE(found.identical());
  EXPECT_EQ(found.changed, 64 * 48);
  EXPECT_TRUE(found.within({}));
  EXPECT_FALSE(difference(plain(64, 48, 100), plain(64, 48, 101), {0, 0}).within({0, 0}));
}

TEST(ImageDifference, OfOpacitiesIsWhatIsSeenOnBlackOrWhite) {
  const auto one_pixel = [](std::vector<std::uint8_t> rgb, std::vector<std::uint8_t> alpha) {
    return Image{1, 1, std::move(rgb), std::move(alpha)};
  };
  const Image white = one_pixel({255, 255, 255}, {}), black = one_pixel({0, 0, 0}, {});
  const auto greatest = [](const Image& a, const Image& b) { return difference(a, b, {}).greatest; };
  EXPECT_EQ(greatest(white, one_pixel({255, 255, 255}, {0})), 255) << "the same on white";
  EXPECT_EQ(greatest(black, one_pixel({0, 0, 0}, {0})), 255) << "the same on black";
  EXPECT_EQ(greatest(white, one_pixel({255, 255, 255}, {254})), 1);
  EXPECT_EQ(greatest(black, one_pixel({0, 0, 0}, {155})), 100);
  EXPECT_EQ(greatest(one_pixel({1, 2, 3}, {0}), one_pixel({200, 100, 50}, {0})), 0)
      << "a colour without opacity is not seen";
  EXPECT_EQ(greatest(one_pixel({0, 0, 0}, {1}), one_pixel({128, 0, 0}, {1})), 1) << "hardly seen";
  EXPECT_EQ(greatest(one_pixel({1, 2, 3}, {255}), one_pixel({1, 2, 3}, {})), 0);
  EXPECT_TRUE(difference(one_pixel({1, 2, 3}, {0}), one_pixel({9, 9, 9}, {0}), {}).identical());
  EXPECT_FALSE(difference(one_pixel({1, 2, 3}, {1}), one_pixel({1, 2, 3}, {0}), {}).identical());
}

TEST(ImageDifference, MarksWhatWasAddedAndRemoved) {
  Image a = plain(64, 48), b = plain(64, 48);
  set(a, 5, 5, 0);
  set(b, 30, 30, 0);
  const Image marks = difference_image(a, b, {});
  const auto at = [&](int x, int y) { return &marks.rgb[static_cast<std::size_t>(3 * (y * 64 + x))]; };
  EXPECT_GT(at(5, 5)[0], at(5, 5)[2]) << "removed: red";
  EXPECT_LT(at(30, 30)[0], at(30, 30)[2]) << "added: blue";
}

/// Grey levels of one row of pixels.
Image row(const std::vector<std::uint8_t>& levels, std::vector<std::uint8_t> alpha = {}) {
  Image image = plain(static_cast<int>(levels.size()), 1);
  for (std::size_t x = 0; x < levels.size(); ++x) set(image, static_cast<int>(x), 0, levels[x]);
  image.alpha = std::move(alpha);
  return image;
}

TEST(ImageDifference, MarksAreOverThePictureAsItIsSeenOnWhite) {
  const Image half = row({0, 0, 100, 255}, {255, 51, 0, 255}), seen = row({0, 204, 255, 255});
  const Image marks = difference_image(half, half, {});
  EXPECT_EQ(marks.rgb, difference_image(seen, seen, {}).rgb);
  EXPECT_EQ(marks.rgb[0], 192) << "black in grey";
  EXPECT_EQ(marks.rgb[3], 243) << "a fifth of black in grey";
}

TEST(ImageDifference, AMarkIsOfItsOwnPixelAlone) {
  const Image a = row({200, 255, 255, 200, 0, 255, 255, 255, 255, 255, 255});
  const Image b = row({255, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255});
  const Image marks = difference_image(a, b, {});
  const auto mark = [&](std::size_t x) { return int{marks.rgb[3 * x]} - int{marks.rgb[3 * x + 2]}; };
  EXPECT_GT(mark(0), 0) << "removed, beside what was added";
  EXPECT_LT(mark(1), 0) << "added";
  EXPECT_EQ(mark(2), 0) << "the same";
  EXPECT_GT(mark(3), 0) << "removed, beside what was removed";
  EXPECT_GT(mark(4), 0) << "removed";
}

TEST(ImageDifference, ChangeOfOneChannelIsMarkedAsWhatItIs) {
  const Image white = plain(8, 1);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Image other = white;
    other.rgb[channel] = 0;
    const Image removed = difference_image(other, white, {}), added = difference_image(white, other, {});
    EXPECT_GT(removed.rgb[0], removed.rgb[2]) << "channel " << channel;
    EXPECT_LT(added.rgb[0], added.rgb[2]) << "channel " << channel;
  }
}

TEST(ImageDifference, MarksAreOverOpacitiesRoundedToTheNearestLevel) {
  const Image faint = row({9}, {16}), seen = row({240});  // 239.56 on white
  EXPECT_EQ(difference_image(faint, faint, {}).rgb, difference_image(seen, seen, {}).rgb);
}

TEST(ImageDifference, WhatIsAddedIsToldFromTheCommonestColour) {
  const auto picture = [](std::uint8_t level, std::size_t channel, std::uint8_t last) {
    Image image = plain(8, 1, 0);
    for (std::size_t x = 0; x < 8; ++x) image.rgb[3 * x + channel] = x == 7 ? last : level;
    return image;
  };
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const Image ground = picture(100, channel, 100), brighter = picture(100, channel, 180);
    const Image added = difference_image(ground, brighter, {}),
                removed = difference_image(brighter, ground, {});
    EXPECT_LT(added.rgb[21], added.rgb[23]) << "added: blue; channel " << channel;
    EXPECT_GT(removed.rgb[21], removed.rgb[23]) << "removed: red; channel " << channel;
  }
}

TEST(ImageDifference, OfTwoColoursThatAreAsCommonTheDarkerIsTheGround) {
  const Image dark = plain(8, 1, 100), bright = plain(8, 1, 180);
  const Image added = difference_image(dark, bright, {}), removed = difference_image(bright, dark, {});
  EXPECT_LT(added.rgb[0], added.rgb[2]) << "added: blue";
  EXPECT_GT(removed.rgb[0], removed.rgb[2]) << "removed: red";
}

/// A line of two pixels' width at a height, drawn with smooth rims.
Image line_at(const GlContext& context, double height) {
  Canvas canvas(context, 200, 100);
  Painter painter(context);
  canvas.begin_flat(Color::hex(0xFFFFFF));
  painter.begin(canvas);
  painter.line(std::vector{Point(10, height), Point(190, height + 20)}, 2, Color::hex(0x0072B2));
  return canvas.read();
}

TEST(ImageDifference, ALineMovedByThreeTenthsOfAPixelIsSeen) {
  const GlContext context;
  const Image before = line_at(context, 40);
  const ImageDifference moved = difference(before, line_at(context, 40.3), {});
  EXPECT_FALSE(moved.within({})) << "density " << moved.density << ", " << moved.beyond << " pixels beyond";
  const ImageDifference hardly = difference(before, line_at(context, 40.01), {});
  EXPECT_TRUE(hardly.within({})) << "density " << hardly.density << ", " << hardly.greatest << " levels";
}

RC_GTEST_PROP(ImageDifferenceProperty, IsTheSameBothWaysAndCountsWhatWasChanged, ()) {
  const int width = *rc::gen::inRange(1, 50), height = *rc::gen::inRange(1, 50);
  const Image a = plain(width, height);
  Image b = a;
  const int count = *rc::gen::inRange(0, 30);
  for (int i = 0; i < count; ++i) set(b, *rc::gen::inRange(0, width), *rc::gen::inRange(0, height), 0);
  long black = 0;
  for (std::size_t i = 0; i < b.rgb.size(); i += 3) black += b.rgb[i] == 0 ? 1 : 0;
  const ImageDifference there = difference(a, b, {}), back = difference(b, a, {});
  RC_ASSERT(there.beyond == black);
  RC_ASSERT(back.beyond == black);
  RC_ASSERT(there.density == back.density);
  // All of them are in one window, or the densest has fewer.
  const int window = std::min(width, difference_window) * std::min(height, difference_window);
  RC_ASSERT(std::lround(there.density * window) <= black);
  RC_ASSERT((there.density > 0) == (black > 0));
}

}  // namespace image_difference_test
}  // namespace plumb
