#include "render/image/png.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "engine/base/errors.h"
#include "render/image/png_chunks.h"

namespace plumb {
namespace png_test {

Image pattern(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i)
    image.rgb.push_back(static_cast<std::uint8_t>(i * 37 + i / 100));
  return image;
}

TEST(Png, DecodesToWhatWasEncoded) {
  EXPECT_TRUE(rc::check([] {
    Image image{*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40), {}};
    image.rgb = *rc::gen::container<std::vector<std::uint8_t>>(
        static_cast<std::size_t>(3 * image.width * image.height), rc::gen::arbitrary<std::uint8_t>());
    RC_ASSERT(decode_png(encode_png(image), "a.png") == image);
  }));
}

TEST(Png, OpacitiesAreKept) {
  const Image image{2, 2, {10, 20, 30, 200, 100, 0, 0, 0, 0, 255, 255, 0}, {255, 0, 128, 51}};
  const std::string bytes = encode_png(image);
  EXPECT_EQ(png_chunks(bytes, "a.png").front().data.substr(8, 2), std::string_view("\x08\x06", 2)) << "RGBA";
  EXPECT_EQ(decode_png(bytes, "a.png"), image);
}

TEST(Png, OpacitiesThatAreNotAsManyAsPixelsAreRefused) {
  Image image = pattern(3, 3);
  image.alpha.resize(8);
  EXPECT_THROW(encode_png(image), OutputError);
}

TEST(Png, SamePictureGivesTheSameBytes) {
  EXPECT_EQ(encode_png(pattern(90, 70)), encode_png(pattern(90, 70)));
}

TEST(Png, TextsAreKeptInChunksOfTheirOwn) {
  const std::string bytes = encode_png(pattern(4, 4), {{"Software", "Plumb"}, {"Description", "t = 1 s"}});
  std::vector<std::string> texts;
  for (const PngChunk& chunk : png_chunks(bytes, "a.png"))
    if (chunk.type == "tEXt") texts.emplace_back(chunk.data);
  const auto with_separator = [](std::string key, const std::string& value) {
    return (key += '\0') += value;
  };
  EXPECT_EQ(texts,
            (std::vector{with_separator("Software", "Plumb"), with_separator("Description", "t = 1 s")}));
}

TEST(Png, EveryTruncationIsRefusedByName) {
  const std::string bytes = encode_png(pattern(30, 20));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    try {
      decode_png(std::string_view(bytes).substr(0, length), "cut.png");
      ADD_FAILURE() << "decoded " << length << " of " << bytes.size() << " bytes";
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("cut.png: ")) << error.what();
    }
  }
}

TEST(Png, AnyChangedByteIsRefusedOrHarmless) {
  const Image image = pattern(30, 20);
  const std::string bytes = encode_png(image);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string bad = bytes;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    EXPECT_THROW(decode_png(bad, "bad.png"), InputError) << "byte " << i << " of " << bytes.size();
  }
}

TEST(Png, BadPixelDataWithGoodCheckSumsAreRefused) {
  std::string bytes(png_signature);
  const std::string good = encode_png(pattern(30, 20));
  for (const PngChunk& chunk : png_chunks(good, "a.png"))
    append_chunk(bytes, chunk.type, chunk.type == "IDAT" ? "no zlib stream" : chunk.data);
  EXPECT_THROW(decode_png(bytes, "bad.png"), InputError);
}

TEST(Png, PictureWithoutAllItsBytesIsNotWritten) {
  EXPECT_THROW(encode_png({10, 10, std::vector<std::uint8_t>(299)}), OutputError);
  EXPECT_THROW(encode_png({0, 0, {}}), OutputError);
}

TEST(Png, KeywordThatPngForbidsIsRefused) {
  EXPECT_THROW(encode_png(pattern(4, 4), {{std::string(200, 'x'), "long"}}), OutputError);
}

}  // namespace png_test
}  // namespace plumb
