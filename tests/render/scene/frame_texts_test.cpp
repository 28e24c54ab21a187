#include "render/scene/frame_texts.h"

#include <gtest/gtest.h>

#include "tests/render/image/pictures.h"

namespace plumb {
namespace frame_texts_test {

FrameTexts some_texts() {
  FrameTexts texts;
  texts.title = "Spatial cable pendulum";
  texts.time = "t = 10.52 s";
  texts.ink = Color::hex(0x2B3038);
  texts.quiet_ink = Color::hex(0x5A626E);
  return texts;
}

class FrameTextsTest : public testing::Test {
 protected:
  Image drawn(const FrameTexts& texts, int width, int height) {
    Canvas canvas(context_, width, height);
    canvas.begin_flat({1, 1, 1});
    painter_.begin(canvas);
    draw_texts(painter_, texts, width, height);
    return canvas.read();
  }

  // Rows in which two pictures differ.
  static std::pair<int, int> changed_rows(const Image& a, const Image& b) {
    std::pair<int, int> rows{a.height, -1};
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < 3 * a.width; ++x)
        if (a.rgb[static_cast<std::size_t>(3 * y * a.width + x)] !=
            b.rgb[static_cast<std::size_t>(3 * y * a.width + x)])
          rows = {std::min(rows.first, y), y};
    return rows;
  }

  GlContext context_;
  Painter painter_{context_};
};

TEST_F(FrameTextsTest, ColourBarIsClearOfAllOtherTextsAndOfTheMotion) {
  for (const auto& [width, height] : {std::pair{960, 540}, std::pair{1920, 1080}, std::pair{300, 600},
                                      std::pair{640, 480}, std::pair{200, 120}, std::pair{1200, 200}})
    for (const double bar_metres : {0.08, 0.11, 0.19})
      for (const auto& [lo, hi] :
           {std::pair{-1.5e-3, 2.5e-3}, std::pair{0.0, 4.2}, std::pair{-4.0e5, 1.2e6}}) {
        FrameTexts texts = some_texts();
        texts.pixels_per_metre = bar_metres * width;
        const Image without = drawn(texts, width, height);
        texts.bar = ColorBar{"bending moment", "N m", lo, hi};
        const Image with = drawn(texts, width, height);
        keep("texts_" + std::to_string(width) + "_" + std::to_string(height), with);
        int inked = 0, changed = 0;
        for (std::size_t i = 0; i < with.rgb.size(); ++i) {
          inked += with.rgb[i] != without.rgb[i] ? 1 : 0;
          changed += without.rgb[i] != 255 && with.rgb[i] != without.rgb[i] ? 1 : 0;
        }
        EXPECT_GT(inked, 300) << width << " x " << height;
        EXPECT_EQ(changed, 0) << "over other texts at " << width << " x " << height;
        const double kept_clear = height / 2.0 * (1 + margins_beside(texts, width, height).bottom);
        if (height > 150) {
          EXPECT_GE(changed_rows(with, without).first, kept_clear) << width << " x " << height;
        }
      }
}

TEST_F(FrameTextsTest, LabelsAreClearOfTheTitleAndOfTheMotion) {
  for (const auto& [width, height] : {std::pair{960, 540}, std::pair{300, 600}}) {
    FrameTexts texts = some_texts();
    texts.pixels_per_metre = 100;
    const Image without = drawn(texts, width, height);
    texts.labels = {{"this run", Color::hex(0x0072B2)},
                    {"another", Color::hex(0xD55E00)},
                    {"published", Color::hex(0x009E73), Marker::circle}};
    const Image with = drawn(texts, width, height);
    keep("labels_" + std::to_string(width), with);
    const auto [first, last] = changed_rows(with, without);
    EXPECT_GT(first, 1.1 * frame_text_size(width, height));
    EXPECT_LE(last, height / 2.0 * (1 - margins_beside(texts, width, height).top));
    for (std::size_t i = 0; i < with.rgb.size(); ++i)
      ASSERT_TRUE(without.rgb[i] == 255 || with.rgb[i] == without.rgb[i]) << "over other texts";
  }
}

TEST_F(FrameTextsTest, TinyPicturesHaveNone) {
  FrameTexts texts = some_texts();
  texts.pixels_per_metre = 100;
  texts.bar = ColorBar{"speed", "m/s", 0, 1};
  const Image image = drawn(texts, 160, 90);
  for (const std::uint8_t byte : image.rgb) ASSERT_EQ(byte, 255);
}

}  // namespace frame_texts_test
}  // namespace plumb
