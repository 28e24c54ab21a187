#include "render/image/png_file.h"

#include <gtest/gtest.h>

#include "engine/base/errors.h"
#include "render/image/png.h"
#include "render/image/png_pixels.h"
#include "tests/render/image/made_png.h"

namespace plumb {
namespace png_file_test {

const std::string black(3, '\0');
const std::string pixels = flat_data(4, 4, black);

/// A picture of 4 x 4 with these chunks between its header and its end.
std::string with(const MadeChunks& chunks) {
  MadeChunks all{{"IHDR", header_of(4, 4)}};
  all.insert(all.end(), chunks.begin(), chunks.end());
  all.emplace_back("IEND", "");
  return file_of(all);
}

std::string refusal(const std::string& bytes) {
  try {
    read_png_file(bytes, "a.png");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(PngFile, OfAnAnimationTellsStillPictureFramesDelaysAndPlays) {
  const std::string bytes = with({{"acTL", animation_of(2, 3)},
                                  {"fcTL", control_of(0)},
                                  {"IDAT", pixels},
                                  {"fcTL", control_of(1, {2, 3, 1, 1, 7, 0, 2, 1})},
                                  {"fdAT", u32(2) + pixels}});
  const PngFile file = read_png_file(bytes, "a.png");
  EXPECT_TRUE(file.says_animated && file.still_is_frame);
  EXPECT_EQ(file.plays, 3U);
  ASSERT_EQ(file.frames.size(), 2U);
  EXPECT_EQ(file.frames[0].data, file.data);
  const PngFrame& part = file.frames[1];
  EXPECT_EQ((std::array{part.x, part.y, part.width, part.height}), (std::array{1, 1, 2, 3}));
  EXPECT_EQ(part.delay, 7U);
  EXPECT_EQ(part.delay_unit, 100U) << "0 stands for 100";
  EXPECT_EQ(part.after, FrameAfter::is_undone);
  EXPECT_TRUE(part.blends);
}

TEST(PngFile, OfNoFramesIsItsStillPicture) {
  const std::string bytes = with({{"acTL", animation_of(1)}, {"IDAT", pixels}});
  const PngFile file = read_png_file(bytes, "a.png");
  EXPECT_TRUE(file.says_animated);
  EXPECT_TRUE(file.frames.empty());
}

TEST(PngFile, BrokenInAnyPartIsRefusedByName) {
  const std::string control = control_of(0), animation = animation_of(1);
  const std::pair<std::string, std::string> idat{"IDAT", pixels};
  const auto frame = [](const MadeFrame& made) {
    return with({{"acTL", animation_of(1)},
                 {"IDAT", pixels},
                 {"fcTL", control_of(0, made)},
                 {"fdAT", u32(1) + pixels}});
  };
  ASSERT_EQ(refusal(frame({})), "none") << "the faults below are the only ones";
  const std::vector<std::pair<std::string, std::string>> faults{
      {"no pixels", with({})},
      {"pixels torn apart", with({idat, {"tEXt", "a"}, idat})},
      {"a second header", with({{"IHDR", header_of(4, 4)}, idat})},
      {"an unknown chunk that matters", with({{"ABCD", ""}, idat})},
      {"palette after the pixels", with({idat, {"PLTE", black}})},
      {"palette of half a colour", with({{"PLTE", "ab"}, idat})},
      {"opacities after the pixels", with({idat, {"tRNS", "abcdef"}})},
      {"gamma after the pixels", with({idat, {"gAMA", u32(45455)}})},
      {"no width", file_of({{"IHDR", header_of(0, 4)}, idat, {"IEND", ""}})},
      {"no height", file_of({{"IHDR", header_of(4, 0)}, idat, {"IEND", ""}})},
      {"a kind that is none", file_of({{"IHDR", header_of(4, 4, 8, 5)}, idat, {"IEND", ""}})},
      {"a depth that is none", file_of({{"IHDR", header_of(4, 4, 3, 0)}, idat, {"IEND", ""}})},
      {"interlaced in no way", file_of({{"IHDR", header_of(4, 4, 8, 2, 2)}, idat, {"IEND", ""}})},
      {"control after the pixels", with({idat, {"acTL", animation}})},
      {"two controls", with({{"acTL", animation}, {"acTL", animation}, idat})},
      {"a short control", with({{"acTL", "abc"}, idat})},
      {"a frame in no animation", with({idat, {"fcTL", control}, {"fdAT", u32(1) + pixels}})},
      {"pixels in no animation", with({idat, {"fdAT", u32(0) + pixels}})},
      {"pixels without a frame", with({{"acTL", animation}, idat, {"fdAT", u32(0) + pixels}})},
      {"pixels of a frame before the still picture's",
       with({{"acTL", animation}, {"fcTL", control}, {"fdAT", u32(1) + pixels}, idat})},
      {"pixels of a frame that has the still picture's",
       with({{"acTL", animation}, {"fcTL", control}, idat, {"fdAT", u32(1) + pixels}})},
      {"two first frames", with({{"acTL", animation}, {"fcTL", control}, {"fcTL", control_of(1)}, idat})},
      {"a frame without pixels", with({{"acTL", animation}, idat, {"fcTL", control}})},
      {"a frame without pixels before another", with({{"acTL", animation_of(2)},
                                                      idat,
                                                      {"fcTL", control},
                                                      {"fcTL", control_of(1)},
                                                      {"fdAT", u32(2) + pixels}})},
      {"a number left out", with({{"acTL", animation}, idat, {"fcTL", control}, {"fdAT", u32(2) + pixels}})},
      {"a number twice", with({{"acTL", animation}, idat, {"fcTL", control}, {"fdAT", u32(0) + pixels}})},
      {"a first number of 1", with({{"acTL", animation}, {"fcTL", control_of(1)}, idat})},
      {"more frames announced", with({{"acTL", animation_of(2)}, {"fcTL", control}, idat})},
      {"none announced", with({{"acTL", animation_of(0)}, {"fcTL", control}, idat})},
      {"a short frame control", with({{"acTL", animation}, {"fcTL", control.substr(1)}, idat})},
      {"a frame part of less than its number",
       with({{"acTL", animation}, idat, {"fcTL", control}, {"fdAT", "ab"}})},
      {"first frame but a part", with({{"acTL", animation}, {"fcTL", control_of(0, {3, 4})}, idat})},
      {"a frame of no width", frame({0, 4})},
      {"a frame of no height", frame({4, 0})},
      {"a frame too wide", frame({4, 4, 1, 0})},
      {"a frame too low", frame({4, 4, 0, 1})},
      {"a frame far out", frame({4, 4, 0xFFFFFFFF, 0})},
      {"a frame of endless width", frame({0xFFFFFFFF, 4})},
      {"a frame that ends in no way", frame({4, 4, 0, 0, 1, 25, 3})},
      {"a frame drawn in no way", frame({4, 4, 0, 0, 1, 25, 0, 2})},
  };
  for (const auto& [what, bytes] : faults)
    EXPECT_TRUE(refusal(bytes).starts_with("a.png: ")) << what << ": " << refusal(bytes);
}

TEST(PngFile, LargerThanWhatIsReadIsRefusedBeforeItIsDecoded) {
  const auto bomb = [](std::uint32_t width, std::uint32_t height, int depth, int kind, std::size_t data) {
    return refusal(file_of(
        {{"IHDR", header_of(width, height, depth, kind)}, {"IDAT", std::string(data, 'x')}, {"IEND", ""}}));
  };
  EXPECT_EQ(bomb(32769, 1, 1, 0, 100000),
            "a.png: 32769 x 1 pixels: at most 32768 a side and 1.5e+08 in all can be read");
  EXPECT_NE(bomb(32768, 32768, 8, 2, 100), "none") << "3.2 GB";
  EXPECT_NE(bomb(12248, 12248, 1, 0, 100000), "none") << "just too many pixels";
  EXPECT_EQ(bomb(12247, 12247, 1, 0, 100000), "none");
  EXPECT_EQ(bomb(12247, 12247, 8, 2, 100), "a.png: 12247 x 12247 pixels cannot be in 100 bytes of data");
  EXPECT_NE(bomb(0xFFFFFFFF, 0xFFFFFFFF, 16, 6, 100), "none");
}

TEST(PngFile, OfManyLargeFramesIsRefused) {
  MadeChunks chunks{{"IHDR", header_of(12000, 12000, 1, 0)},
                    {"acTL", animation_of(700)},
                    {"IDAT", std::string(20000, 'x')}};
  std::uint32_t number = 0;
  for (int k = 0; k < 700; ++k) {
    chunks.emplace_back("fcTL", control_of(number++, {1, 1}));
    chunks.emplace_back("fdAT", u32(number++) + "x");
  }
  chunks.emplace_back("IEND", "");
  EXPECT_EQ(refusal(file_of(chunks)),
            "a.png: 700 frames of 12000 x 12000 pixels: at most 1e+11 pixels in all can be read");
}

/// The first pixel as text: "1 2 3 255".
std::string first_pixel(const std::string& bytes) {
  const Image image = decode_png(bytes, "a.png");
  std::string text;
  for (int c = 0; c < 3; ++c) text += std::to_string(image.rgb[static_cast<std::size_t>(c)]) + " ";
  return text + std::to_string(image.alpha.empty() ? 255 : image.alpha[0]);
}

TEST(PngFile, OfEveryKindIsDecodedToColoursAndOpacity) {
  const auto pixel_of = [](int depth, int kind, const std::string& row, const MadeChunks& extra = {},
                           int width = 1) {
    MadeChunks chunks{{"IHDR", header_of(static_cast<std::uint32_t>(width), 1, depth, kind)}};
    chunks.insert(chunks.end(), extra.begin(), extra.end());
    chunks.emplace_back("IDAT", rows_of(1, row));
    chunks.emplace_back("IEND", "");
    return first_pixel(file_of(chunks));
  };
  EXPECT_EQ(pixel_of(1, 0, "\x80"), "255 255 255 255");
  EXPECT_EQ(pixel_of(2, 0, "\x40"), "85 85 85 255");
  EXPECT_EQ(pixel_of(4, 0, "\x50"), "85 85 85 255");
  EXPECT_EQ(pixel_of(8, 0, "\x07"), "7 7 7 255");
  EXPECT_EQ(pixel_of(8, 0, "\x07", {{"tRNS", u16(7)}}), "7 7 7 0");
  EXPECT_EQ(pixel_of(16, 0, "\x80\xFF"), "128 128 128 255") << "to the nearest, 128.5 of 257ths down";
  EXPECT_EQ(pixel_of(16, 0, "\x07\x87"), "7 7 7 255");
  EXPECT_EQ(pixel_of(16, 0, "\x07\x88"), "8 8 8 255");
  EXPECT_EQ(pixel_of(8, 2, "\x01\x02\x03"), "1 2 3 255");
  EXPECT_EQ(pixel_of(8, 2, "\x01\x02\x03", {{"tRNS", u16(1) + u16(2) + u16(3)}}), "1 2 3 0");
  EXPECT_EQ(pixel_of(8, 3, "\x01", {{"PLTE", "abcdef"}, {"tRNS", "\x01\x09"}}), "100 101 102 9");
  EXPECT_EQ(pixel_of(1, 3, "\x80", {{"PLTE", "abcdef"}}), "100 101 102 255");
  EXPECT_EQ(pixel_of(8, 4, "\x05\x06"), "5 5 5 6");
  EXPECT_EQ(pixel_of(8, 6, "\x01\x02\x03\x04"), "1 2 3 4");
}

TEST(PngFile, InterlacedIsTheSamePicture) {
  // Of 2 x 2 pixels the passes are: the first; the second; the second row.
  std::string passes = std::string("\0", 1) + "abc" + '\0' + "def" + '\0' + "ghijkl";
  const std::string interlaced =
      file_of({{"IHDR", header_of(2, 2, 8, 2, 1)}, {"IDAT", deflated(passes)}, {"IEND", ""}});
  const std::string plain = file_of({{"IHDR", header_of(2, 2)},
                                     {"IDAT", deflated(std::string("\0", 1) + "abcdef" + '\0' + "ghijkl")},
                                     {"IEND", ""}});
  EXPECT_EQ(decode_png(interlaced, "a.png"), decode_png(plain, "a.png"));
}

TEST(PngFile, SixteenBitsLeaveAMarkOfWhatEightCannotTell) {
  const auto mark = [](const std::string& row) {
    const std::string bytes =
        file_of({{"IHDR", header_of(1, 1, 16, 6)}, {"IDAT", rows_of(1, row)}, {"IEND", ""}});
    return decode_still(read_png_file(bytes, "a.png"), "a.png").finer;
  };
  const std::string full("\xFF\xFF", 2), none("\0\0", 2), eight("\x07\x07"), nine("\x07\x08");
  EXPECT_EQ(mark(eight + eight + eight + full), 0U);
  EXPECT_NE(mark(eight + eight + nine + full), 0U);
  EXPECT_NE(mark(eight + eight + nine + full), mark(eight + nine + eight + full));
  EXPECT_EQ(mark(eight + eight + nine + none), 0U) << "what is not seen";
}

TEST(PngFile, ChunksOfTextAreNotInflated) {
  // 100 MB of text and of colour profile in 100 KB: read at once, as nobody looks into them.
  const std::string bomb = deflated(std::string(10'000'000, 'x'));
  const std::string bytes = with({{"iCCP", std::string("a\0\0", 3) + bomb},
                                  {"zTXt", std::string("a\0\0", 3) + bomb},
                                  {"iTXt", std::string("a\0\1\0\0\0", 6) + bomb},
                                  {"IDAT", pixels}});
  EXPECT_EQ(first_pixel(bytes), "0 0 0 255");
}

TEST(PngFile, ColourSpaceIsToldUnlessItIsThatOfEveryScreen) {
  const auto space = [](const MadeChunks& chunks) {
    MadeChunks all = chunks;
    all.emplace_back("IDAT", pixels);
    const std::string bytes = with(all);
    return read_png_file(bytes, "a.png").color_space;
  };
  EXPECT_EQ(space({}), "");
  EXPECT_EQ(space({{"gAMA", u32(45455)}}), "");
  EXPECT_EQ(space({{"sRGB", std::string(1, '\0')}, {"gAMA", u32(100000)}}), "") << "sRGB comes before gAMA";
  EXPECT_NE(space({{"gAMA", u32(100000)}}), "");
  EXPECT_NE(space({{"gAMA", u32(45456)}}), space({{"gAMA", u32(100000)}}));
  EXPECT_NE(space({{"cHRM", std::string(32, 'x')}}), "");
  EXPECT_NE(space({{"iCCP", "a"}}), space({{"iCCP", "b"}}));
  EXPECT_NE(space({{"cICP", "abcd"}}), "");
  EXPECT_NE(space({{"eXIf", "MM"}}), "");
  const std::string ours = encode_png({1, 1, {1, 2, 3}});
  EXPECT_EQ(read_png_file(ours, "a.png").color_space, "") << "what this program writes";
}

}  // namespace png_file_test
}  // namespace plumb
