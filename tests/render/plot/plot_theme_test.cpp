#include "render/plot/plot_theme.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>

namespace plumb {
namespace plot_theme_test {

constexpr std::array both = {SceneTheme::light, SceneTheme::dark};

TEST(Contrast, IsThatOfTheGuidelines) {
  EXPECT_NEAR(contrast(Color::hex(0x000000), Color::hex(0xFFFFFF)), 21, 1e-6);
  EXPECT_NEAR(contrast(Color::hex(0xFFFFFF), Color::hex(0xFFFFFF)), 1, 1e-6);
  // The lightest grey on white that the guidelines' examples let pass as text.
  EXPECT_NEAR(contrast(Color::hex(0x767676), Color::hex(0xFFFFFF)), 4.54, 0.005);
}

TEST(PlotTheme, TextsHaveTheContrastOfSmallTextAndLinesThatOfGraphics) {
  for (const SceneTheme word : both) {
    const PlotTheme& theme = plot_theme(word);
    for (const Color text : {theme.ink, theme.rule_ink}) EXPECT_GE(contrast(text, theme.paper), 4.5);
    for (const Color line : {theme.zero, theme.rule}) EXPECT_GE(contrast(line, theme.paper), 3);
    for (std::size_t k = 0; k < theme.series.size(); ++k)
      EXPECT_GE(contrast(theme.series[k], theme.paper), 3) << "series " << k;
    EXPECT_LT(contrast(theme.major_grid, theme.paper), 2) << "a grid stays behind the data";
    EXPECT_LT(contrast(theme.minor_grid, theme.paper), contrast(theme.major_grid, theme.paper));
  }
}

TEST(PlotTheme, ColoursThatAreSeenStayAsTheyAre) {
  const PlotTheme& light = plot_theme(SceneTheme::light);
  EXPECT_EQ(light.series[0], palette[0]);
  EXPECT_EQ(light.series[1], palette[1]);
  EXPECT_EQ(seen_on(light, Color::hex(0x0072B2)), Color::hex(0x0072B2));
}

TEST(PlotTheme, SeriesStayApart) {
  for (const SceneTheme word : both) {
    const auto& series = plot_theme(word).series;
    for (std::size_t i = 0; i < series.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double distance = std::abs(series[i].r - series[j].r) + std::abs(series[i].g - series[j].g) +
                                std::abs(series[i].b - series[j].b);
        EXPECT_GT(distance, 0.2) << i << " and " << j;
      }
  }
}

TEST(SeenOn, GivesEveryColourTheContrastAskedForAndKeepsItsOpacity) {
  EXPECT_TRUE(rc::check([] {
    const PlotTheme& theme = plot_theme(*rc::gen::elementOf(std::array(both)));
    const auto rgb = static_cast<unsigned>(*rc::gen::inRange(0, 0x1000000));
    const Color color = seen_on(theme, Color::hex(rgb, 0.4F));
    RC_ASSERT(contrast(color, theme.paper) >= theme.least_contrast);
    RC_ASSERT(theme.least_contrast >= 3);
    RC_ASSERT(color.a == 0.4F);
  }));
}

}  // namespace plot_theme_test
}  // namespace plumb
