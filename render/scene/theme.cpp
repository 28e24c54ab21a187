#include "render/scene/theme.h"

namespace plumb {

const Theme& theme(SceneTheme word) {
  static constexpr Theme light{.above = {0.984F, 0.988F, 0.992F, 1},
                               .below = {0.925F, 0.937F, 0.953F, 1},
                               .plain = Color::hex(0xFFFFFF),
                               .grid = {0.70F, 0.735F, 0.78F, 0.6F},
                               .shadow = {0.24F, 0.28F, 0.34F, 0.5F},
                               .cable = Color::hex(0x1F6FB2),
                               .series = {palette[1], palette[2], palette[3], palette[4], palette[5]},
                               .support = Color::hex(0x4A515B),
                               .trail = Color::hex(0xD55E00),
                               .ink = Color::hex(0x2B3038),
                               .quiet_ink = Color::hex(0x5A626E)};
  static constexpr Theme dark{
      .above = Color::hex(0x0E1116),
      .below = Color::hex(0x1B2028),
      .plain = Color::hex(0x14181E),
      .grid = Color::hex(0x5C6878, 0.6F),
      .shadow = Color::hex(0x000000, 0.65F),
      .cable = Color::hex(0x4FA3E0),
      .series = {Color::hex(0xF08A3C), Color::hex(0x2BC295), palette[3], palette[4], Color::hex(0xB8C4FF)},
      .support = Color::hex(0x9AA3AF),
      .trail = Color::hex(0xF08A3C),
      .ink = Color::hex(0xE8ECF1),
      .quiet_ink = Color::hex(0xA9B2BE)};
  return word == SceneTheme::light ? light : dark;
}

}  // namespace plumb
