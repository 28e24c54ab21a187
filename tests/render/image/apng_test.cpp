#include "render/image/apng.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/errors.h"
#include "render/image/png.h"
#include "render/image/png_chunks.h"
#include "tests/render/image/made_png.h"

namespace plumb {
namespace apng_test {

Image flat(int width, int height, std::uint8_t level) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), level)};
}

std::vector<std::string> frames(int count) {
  std::vector<std::string> result;
  for (int i = 0; i < count; ++i)
    result.push_back(encode_png(flat(20, 10, static_cast<std::uint8_t>(40 * i))));
  return result;
}

std::string pixel_data(const std::string& png) {
  std::string data;
  for (const PngChunk& chunk : png_chunks(png, "frame"))
    if (chunk.type == "IDAT") data += chunk.data;
  return data;
}

// The compressed pixels of each frame, from IDAT and fdAT, which follow their fcTL.
std::vector<std::string> animated_data(const std::string& apng) {
  std::vector<std::string> data;
  for (const PngChunk& chunk : png_chunks(apng, "animation")) {
    if (chunk.type == "fcTL") data.emplace_back();
    if (chunk.type == "IDAT") data.back() += chunk.data;
    if (chunk.type == "fdAT") data.back() += chunk.data.substr(4);
  }
  return data;
}

TEST(Apng, FramesHoldTheCompressedPixelsOfTheirPngs) {
  const std::vector<std::string> pngs = frames(5);
  const std::vector<std::string> data = animated_data(join_apng(pngs, 25));
  ASSERT_EQ(data.size(), pngs.size());
  for (std::size_t i = 0; i < pngs.size(); ++i) EXPECT_EQ(data[i], pixel_data(pngs[i])) << "frame " << i;
}

TEST(Apng, ControlSaysHowManyFramesAndThatItLoopsForEver) {
  const std::string apng = join_apng(frames(5), 25);
  const auto chunks = png_chunks(apng, "animation");
  const auto control =
      std::find_if(chunks.begin(), chunks.end(), [](const PngChunk& chunk) { return chunk.type == "acTL"; });
  ASSERT_NE(control, chunks.end());
  EXPECT_EQ(read_u32(control->data), 5U);
  EXPECT_EQ(read_u32(control->data.substr(4)), 0U);
  const auto data =
      std::find_if(chunks.begin(), chunks.end(), [](const PngChunk& chunk) { return chunk.type == "IDAT"; });
  EXPECT_LT(control, data) << "acTL has to come before the pixels";
}

TEST(Apng, SequenceNumbersCountFromZeroWithoutGaps) {
  const std::string apng = join_apng(frames(4), 25);
  std::uint32_t expected = 0;
  for (const PngChunk& chunk : png_chunks(apng, "animation")) {
    if (chunk.type == "fcTL" || chunk.type == "fdAT") {
      EXPECT_EQ(read_u32(chunk.data), expected++);
    }
  }
  EXPECT_EQ(expected, 4U + 3U);
}

TEST(Apng, EveryFrameHasTheSizeAndTheDelayOfTheRate) {
  for (const auto& [rate, numerator, denominator] :
       {std::tuple(25.0, 1, 25), std::tuple(12.5, 80, 1000), std::tuple(0.5, 2000, 1000)}) {
    const std::string apng = join_apng(frames(3), rate);
    for (const PngChunk& chunk : png_chunks(apng, "animation")) {
      if (chunk.type != "fcTL") continue;
      ASSERT_EQ(chunk.data.size(), 26U);
      EXPECT_EQ(read_u32(chunk.data.substr(4)), 20U);
      EXPECT_EQ(read_u32(chunk.data.substr(8)), 10U);
      EXPECT_EQ(read_u32(chunk.data.substr(20)), static_cast<std::uint32_t>(numerator * 65536 + denominator))
          << rate;
    }
  }
}

TEST(Apng, ShowsItsFirstFrameWhereAnimationIsUnknown) {
  EXPECT_EQ(decode_png(join_apng(frames(3), 25), "animation"), flat(20, 10, 0));
}

TEST(Apng, SplitsIntoTheFramesItWasJoinedOf) {
  const std::vector<std::string> pngs = frames(5);
  const std::vector<std::string> again = split_apng(join_apng(pngs, 25), "animation");
  ASSERT_EQ(again.size(), pngs.size());
  for (std::size_t i = 0; i < pngs.size(); ++i)
    EXPECT_EQ(decode_png(again[i], "frame"), decode_png(pngs[i], "frame")) << "frame " << i;
  EXPECT_EQ(split_apng(pngs[0], "still"), std::vector{pngs[0]});
}

TEST(Apng, WithoutFramesOrOfPartsOfThePictureIsNotSplit) {
  const std::string data = flat_data(4, 4, "abc");
  EXPECT_THROW(
      split_apng(
          file_of({{"IHDR", header_of(4, 4)}, {"acTL", animation_of(1)}, {"IDAT", data}, {"IEND", ""}}),
          "a.png"),
      InputError);
  EXPECT_THROW(split_apng(file_of({{"IHDR", header_of(4, 4)},
                                   {"acTL", animation_of(1)},
                                   {"IDAT", data},
                                   {"fcTL", control_of(0, {2, 4})},
                                   {"fdAT", u32(1) + data},
                                   {"IEND", ""}}),
                          "a.png"),
               InputError);
}

TEST(Apng, FramesOfDifferentSizeAreRefused) {
  EXPECT_THROW(join_apng(std::vector{encode_png(flat(20, 10, 0)), encode_png(flat(10, 20, 0))}, 25),
               OutputError);
}

TEST(Apng, NoFramesOrARateThatCannotBeWrittenAreRefused) {
  EXPECT_THROW(join_apng({}, 25), OutputError);
  for (const double rate : {0.0, -1.0, 1e-3, 2500.5, 1e9})
    EXPECT_THROW(join_apng(frames(1), rate), OutputError) << rate;
  EXPECT_THROW(join_apng(std::vector<std::string>{"not a PNG"}, 25), InputError);
}

}  // namespace apng_test
}  // namespace plumb
