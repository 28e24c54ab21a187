#include "render/plot/plot_theme.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

double luminance(Color color) {
  const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

// Each of the palette's colours, darkened or lightened until it is seen on the paper.
PlotTheme with_palette(PlotTheme theme) {
  std::transform(palette.begin(), palette.end(), theme.series.begin(),
                 [&](Color color) { return seen_on(theme, color); });
  return theme;
}

}  // namespace

double contrast(Color a, Color b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

Color seen_on(const PlotTheme& theme, Color color) {
  constexpr int steps = 64;
  for (int k = 0; k <= steps; ++k) {
    const float ink = static_cast<float>(k) / steps, own = 1 - ink;
    const Color mixed{own * color.r + ink * theme.ink.r, own * color.g + ink * theme.ink.g,
                      own * color.b + ink * theme.ink.b, color.a};
    if (contrast(mixed, theme.paper) >= theme.least_contrast) return mixed;
  }
  return {theme.ink.r, theme.ink.g, theme.ink.b, color.a};
}

const PlotTheme& plot_theme(SceneTheme word) {
  static const PlotTheme light = with_palette({.paper = Color::hex(0xFFFFFF),
                                               .ink = Color::hex(0x222222),
                                               .major_grid = Color::hex(0xDDDDDD),
                                               .minor_grid = Color::hex(0xF1F1F1),
                                               .zero = Color::hex(0x8C8C8C),
                                               .rule = Color::hex(0x8C8C8C),
                                               .rule_ink = Color::hex(0x555555),
                                               .series = {},
                                               .least_contrast = 3});
  static const PlotTheme dark = with_palette({.paper = Color::hex(0x14181E),
                                              .ink = Color::hex(0xE8ECF1),
                                              .major_grid = Color::hex(0x363D47),
                                              .minor_grid = Color::hex(0x21262E),
                                              .zero = Color::hex(0x7C8693),
                                              .rule = Color::hex(0x8C96A3),
                                              .rule_ink = Color::hex(0xB4BDC8),
                                              .series = {},
                                              .least_contrast = 4.5});
  return word == SceneTheme::light ? light : dark;
}

}  // namespace plumb
