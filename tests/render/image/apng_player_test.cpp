#include "render/image/apng_player.h"

#include <gtest/gtest.h>

#include "tests/render/image/made_png.h"

namespace plumb {
namespace apng_player_test {

/// A frame of 4 x 4 or a part of it, of one colour with opacity.
struct Shot {
  MadeFrame frame;
  std::string pixel;
};

std::string animation(const std::vector<Shot>& shots) {
  MadeChunks chunks{{"IHDR", header_of(4, 4, 8, 6)},
                    {"acTL", animation_of(static_cast<std::uint32_t>(shots.size()))},
                    {"IDAT", flat_data(4, 4, "abcd")}};
  std::uint32_t number = 0;
  for (const Shot& shot : shots) {
    chunks.emplace_back("fcTL", control_of(number++, shot.frame));
    chunks.emplace_back("fdAT", u32(number++) + flat_data(static_cast<int>(shot.frame.width),
                                                          static_cast<int>(shot.frame.height), shot.pixel));
  }
  chunks.emplace_back("IEND", "");
  return file_of(chunks);
}

/// The pixel at (x, y) of frame k: "1 2 3 255".
std::string pixel(const std::string& bytes, std::size_t k, int x, int y, bool every_frame) {
  const std::string name = "a.png";
  const PngFile file = read_png_file(bytes, name);
  ApngPlayer player(file, name);
  for (std::size_t i = 0; every_frame && i < k; ++i) player.show(i);
  const Image& image = player.show(k).image;
  const auto at = static_cast<std::size_t>(4 * y + x);
  std::string text;
  for (std::size_t c = 0; c < 3; ++c) text += std::to_string(image.rgb[3 * at + c]) + " ";
  return text + std::to_string(image.alpha[at]);
}

constexpr int stays = 0, is_cleared = 1, is_undone = 2, over = 1;
const std::string red("\xFF\0\0\xFF", 4), blue("\0\0\xFF\xFF", 4), half_blue("\0\0\xFF\x80", 4),
    nothing(4, '\0');

MadeFrame part(int after = stays, int blend = 0) {
  return {2, 2, 1, 1, 1, 25, after, blend};
}
MadeFrame whole(int after = stays, int blend = 0) {
  return {4, 4, 0, 0, 1, 25, after, blend};
}

TEST(ApngPlayer, ShowsFramesOnWhatThoseBeforeThemLeave) {
  for (const bool every : {false, true}) {
    SCOPED_TRACE(every);
    const std::string kept = animation({{whole(), red}, {part(), blue}, {part(stays, over), nothing}});
    EXPECT_EQ(pixel(kept, 1, 0, 0, every), "255 0 0 255");
    EXPECT_EQ(pixel(kept, 1, 1, 1, every), "0 0 255 255");
    EXPECT_EQ(pixel(kept, 2, 1, 1, every), "0 0 255 255");
    const std::string replaced = animation({{whole(), red}, {part(), nothing}});
    EXPECT_EQ(pixel(replaced, 1, 2, 2, every), "0 0 0 0");
    EXPECT_EQ(pixel(replaced, 1, 3, 3, every), "255 0 0 255");
    const std::string mixed = animation({{whole(), red}, {part(stays, over), half_blue}});
    EXPECT_EQ(pixel(mixed, 1, 1, 1, every), "127 0 128 255");
    const std::string on_nothing = animation({{part(stays, over), half_blue}});
    EXPECT_EQ(pixel(on_nothing, 0, 1, 1, every), "0 0 255 128");
    const std::string cleared =
        animation({{whole(), red}, {part(is_cleared), blue}, {part(stays, over), nothing}});
    EXPECT_EQ(pixel(cleared, 1, 1, 1, every), "0 0 255 255");
    EXPECT_EQ(pixel(cleared, 2, 1, 1, every), "0 0 255 0");
    EXPECT_EQ(pixel(cleared, 2, 0, 1, every), "255 0 0 255");
    const std::string undone =
        animation({{whole(), red}, {whole(is_undone), blue}, {part(stays, over), nothing}});
    EXPECT_EQ(pixel(undone, 1, 0, 0, every), "0 0 255 255");
    EXPECT_EQ(pixel(undone, 2, 0, 0, every), "255 0 0 255");
    const std::string first_undone = animation({{whole(is_undone), red}, {part(), blue}});
    EXPECT_EQ(pixel(first_undone, 1, 0, 0, every), "0 0 0 0");
    const std::string hidden =
        animation({{whole(), red}, {part(is_cleared), blue}, {whole(), blue}, {part(), red}});
    EXPECT_EQ(pixel(hidden, 3, 0, 0, every), "0 0 255 255");
    EXPECT_EQ(pixel(hidden, 3, 2, 2, every), "255 0 0 255");
  }
}

}  // namespace apng_player_test
}  // namespace plumb
