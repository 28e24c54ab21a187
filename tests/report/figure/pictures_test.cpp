#include "report/figure/pictures.h"

#include <gtest/gtest.h>

#include "tests/report/program/program.h"

namespace plumb {
namespace pictures_test {

Figure small_figure() {
  Figure figure;
  figure.name = "line";
  figure.plot.width = 160;
  figure.plot.height = 120;
  figure.plot.font_size = 8;
  Series series;
  series.x = {0, 1, 2};
  series.y = {0, 1, 0};
  figure.plot.panels.emplace_back().series.push_back(series);
  return figure;
}

TEST(Pictures, ForAPageAreDrawnOnLightAndOnDarkPaperInFewerBytes) {
  const TemporaryFolder temporary;
  OutputFolder folder((temporary / "a").string());
  DrawingTools tools;
  const std::vector<Picture> pictures = draw_for_page({small_figure()}, tools, "made", folder);
  folder.commit();
  ASSERT_EQ(pictures.size(), 1U);
  const Picture& picture = pictures[0];
  EXPECT_EQ(read_text(temporary / "a/figures/line.png"), picture.png)
      << "the file is the light one, as drawn";
  EXPECT_LT(picture.page_png.size(), picture.png.size());
  const Image file = decode_png(picture.png, "file"), light = decode_png(picture.page_png, "light"),
              dark = decode_png(picture.dark_png, "dark");
  ASSERT_EQ(light.rgb.size(), file.rgb.size());
  ASSERT_EQ(dark.rgb.size(), file.rgb.size());
  EXPECT_EQ(light.rgb[0], file.rgb[0]) << "paper stays as it is";
  EXPECT_GT(light.rgb[0], 200);
  EXPECT_LT(dark.rgb[0], 60);
}

}  // namespace pictures_test
}  // namespace plumb
