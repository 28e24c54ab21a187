#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/errors.h"
#include "engine/case/case_words.h"
#include "engine/model/cable.h"
#include "render/image/color_map.h"
#include "render/scene/theme.h"
#include "tests/render/image/pictures.h"
#include "tests/render/scene/swing.h"

namespace plumb {
namespace scene_style_test {

/// The case of the swing.
Case swing_case() {
  Case spec;
  spec.cable.length = 1;
  spec.cable.area = 2.5e-5;
  spec.cable.density = 320;
  spec.cable.youngs_modulus = 1.6e6;
  spec.cable.second_moment = 5e-11;
  spec.cable.elements = 4;
  spec.loads.gravity = {0, -9.81, 0};
  spec.supports.first = Support::pinned;
  spec.title = "Spatial cable pendulum";
  spec.scene.size = {320, 240};
  return spec;
}

SceneInput style_input() {
  SceneInput input = scene_input(swing_case());
  input.cable = std::make_shared<Cable>(swing_case());
  return input;
}

std::array<int, 3> at(const Image& image, const Point& place) {
  const int x = std::clamp(static_cast<int>(place.x()), 0, image.width - 1);
  const int y = std::clamp(static_cast<int>(place.y()), 0, image.height - 1);
  const auto i = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

std::size_t differing_pixels(const Image& a, const Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3)
    count += std::equal(&a.rgb[i], &a.rgb[i] + 3, &b.rgb[i]) ? 0 : 1;
  return count;
}

double distance(const std::array<int, 3>& color, const std::array<int, 3>& other) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += std::pow(color[c] - other[c], 2);
  return std::sqrt(sum);
}

std::array<int, 3> levels(Color color) {
  const auto level = [](float channel) { return static_cast<int>(std::lround(255 * channel)); };
  return {level(color.r), level(color.g), level(color.b)};
}

/// What light leaves of a colour, which it makes brighter and whiter: from 0 for the least channel to 255.
std::array<int, 3> hue(const std::array<int, 3>& color) {
  const auto [least, most] = std::minmax_element(color.begin(), color.end());
  std::array<int, 3> result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = 255 * (color[c] - *least) / std::max(1, *most - *least);
  return result;
}

class SceneStyle : public testing::Test {
 protected:
  Image frame(const SceneInput& input, int k = 20) {
    return SceneRenderer(context_, trajectory_, input).frame(k);
  }

  GlContext context_;
  Trajectory trajectory_ = swing();
};

TEST_F(SceneStyle, ThemesAndBackgroundsAreAsTheySay) {
  for (const auto& [theme_word, theme_written] : words_of<SceneTheme>)
    for (const auto& [background, written] : words_of<SceneBackground>)
      for (const std::array<int, 2> size : {std::array{960, 540}, std::array{320, 400}}) {
        SceneInput input = style_input();
        input.spec.size = size;
        input.spec.theme = theme_word;
        input.spec.background = background;
        const Image image = frame(input);
        keep(std::string("style_") + std::string(theme_written) + "_" + std::string(written) + "_" +
                 std::to_string(size[0]),
             image);
        const std::array<int, 3> corner = at(image, {image.width - 1.0, 0});
        const bool light = theme_word == SceneTheme::light;
        if (background == SceneBackground::transparent) {
          ASSERT_EQ(image.alpha.size(), image.rgb.size() / 3);
          EXPECT_EQ(image.alpha[static_cast<std::size_t>(image.width) - 1], 0);
          continue;
        }
        EXPECT_TRUE(image.alpha.empty());
        EXPECT_EQ(corner[0] > 128, light) << theme_written;
        if (background == SceneBackground::plain) {
          EXPECT_LT(distance(corner, levels(theme(theme_word).plain)), 1.0) << theme_written;
        }
      }
}

TEST_F(SceneStyle, TransparentFrameOnWhiteIsThePlainOne) {
  SceneInput input = style_input();
  input.spec.background = SceneBackground::plain;
  input.spec.ghosts = 2;
  const Image plain = frame(input);
  input.spec.background = SceneBackground::transparent;
  const Image transparent = frame(input);
  int most = 0;
  for (std::size_t i = 0; i < plain.rgb.size(); ++i) {
    const int alpha = transparent.alpha[i / 3];
    const int composed = (transparent.rgb[i] * alpha + 255 * (255 - alpha) + 127) / 255;
    most = std::max(most, std::abs(plain.rgb[i] - composed));
  }
  EXPECT_LE(most, 4) << "levels, of several layers rounded each for itself";
}

TEST_F(SceneStyle, CableIsOpaqueInATransparentFrame) {
  SceneInput input = style_input();
  input.spec.background = SceneBackground::transparent;
  SceneRenderer scene(context_, trajectory_, input);
  const Image image = scene.frame(20);
  const Point tip = scene.pixel(trajectory_.q[40].segment<3>(12), 0.8);
  EXPECT_EQ(image.alpha[static_cast<std::size_t>(static_cast<int>(tip.y()) * image.width +
                                                 static_cast<int>(tip.x()))],
            255);
}

TEST_F(SceneStyle, TextIsLegibleInBothThemes) {
  const auto luminance = [](Color c) {
    const auto linear = [](double v) {
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  };
  for (const auto& [word_of_theme, written] : words_of<SceneTheme>) {
    const Theme& t = theme(word_of_theme);
    for (const Color ink : {t.ink, t.quiet_ink})
      for (const Color ground : {t.above, t.below, t.plain}) {
        const double a = luminance(ink) + 0.05, b = luminance(ground) + 0.05;
        EXPECT_GT(std::max(a, b) / std::min(a, b), 4.5) << "contrast of WCAG's AA, " << written;
      }
  }
}

TEST_F(SceneStyle, EveryFieldColoursTheCableAndHasALegend) {
  for (const auto& [theme_word, size] : {std::pair{SceneTheme::light, std::array{960, 540}},
                                         std::pair{SceneTheme::dark, std::array{300, 600}}}) {
    SceneInput input = style_input();
    input.spec.size = size;
    input.spec.theme = theme_word;
    const Image without = frame(input);
    for (const auto& [field, written] : words_of<ColorField>) {
      if (field == ColorField::none) continue;
      input.spec.color_by = field;
      const Image with = frame(input);
      keep(std::string("field_") + std::string(written) + "_" + std::to_string(size[0]), with);
      EXPECT_GT(differing_pixels(with, without), 500U) << written;
    }
  }
}

TEST_F(SceneStyle, SpeedRunsThroughTheMapFromTheHeldEndToTheTip) {
  // A stiff cable that turns evenly: its speed grows along it, from the least of the run to the greatest.
  Trajectory turning;
  turning.elements = 4;
  turning.element_length = 0.25;
  for (int k = 0; k <= 10; ++k) {
    const double angle = 0.3 * k;
    const Vec3 way(std::cos(angle), 0, -std::sin(angle)), rate(-std::sin(angle), 0, -std::cos(angle));
    Eigen::VectorXd q(30), v(30);
    for (int node = 0; node <= 4; ++node) {
      q.segment<6>(6 * node) << 0.25 * node * way, way;
      v.segment<6>(6 * node) << 0.25 * node * 3 * rate, 3 * rate;
    }
    turning.times.push_back(0.1 * k);
    turning.q.push_back(q);
    turning.v.push_back(v);
    turning.energies.emplace_back();
  }
  SceneInput input = style_input();
  input.spec.size = {640, 480};
  input.spec.color_by = ColorField::speed;
  input.spec.view = View::top;
  input.spec.trail = 0;
  input.supports.first = Support::free;
  SceneRenderer scene(context_, turning, input);
  const Image image = scene.at(0.3);
  keep("field_of_a_turning_cable", image);
  for (const double s : {0.05, 0.3, 0.6, 0.8}) {
    const Eigen::VectorXd& q = turning.q[3];
    const Vec3 place = s * q.segment<3>(24);
    const std::array<int, 3> color = at(image, scene.pixel(place, 0.3));
    double nearest = 0;
    for (int k = 1; k <= 100; ++k)
      if (distance(hue(color), hue(levels(map_color(k / 100.0)))) <
          distance(hue(color), hue(levels(map_color(nearest)))))
        nearest = k / 100.0;
    EXPECT_NEAR(nearest, s, 0.12) << color[0] << ", " << color[1] << ", " << color[2];
  }
}

TEST_F(SceneStyle, ColoursNeedTheCableTheyAreComputedWith) {
  SceneInput input = style_input();
  input.spec.color_by = ColorField::axial_force;
  input.cable = nullptr;
  EXPECT_THROW(frame(input), OutputError);
  Case finer = swing_case();
  finer.cable.elements = 5;
  input.cable = std::make_shared<Cable>(finer);
  EXPECT_THROW(frame(input), OutputError);
}

TEST_F(SceneStyle, GhostsAreWhereTheCableWas) {
  SceneInput input = style_input();
  input.spec.size = {640, 480};
  input.spec.trail = 0;
  const Image without = frame(input);
  input.spec.ghosts = 3;
  input.spec.ghost_interval = 0.12;
  SceneRenderer scene(context_, trajectory_, input);
  const Image with = scene.frame(20);
  keep("ghosts", with);
  double before = 0;
  for (const int back : {18, 12, 6}) {  // outputs, from the earliest
    const Vec3 place = trajectory_.q[static_cast<std::size_t>(40 - back)].segment<3>(18);
    const Point p = scene.pixel(place, 0.8);
    const double changed = distance(at(with, p), at(without, p));
    EXPECT_GT(changed, before) << "the later, the stronger";
    before = changed + 5;
  }
  const Vec3 earlier = trajectory_.q[16].segment<3>(18);
  EXPECT_EQ(at(with, scene.pixel(earlier, 0.8)), at(without, scene.pixel(earlier, 0.8)))
      << "a ghost that was not asked for";
  EXPECT_EQ(SceneRenderer(context_, trajectory_, input).at(0), [&] {
    input.spec.ghosts = 0;
    return SceneRenderer(context_, trajectory_, input).at(0);
  }()) << "nothing was before the start";
}

TEST_F(SceneStyle, TrailIsAsLongAsItIsToldToBe) {
  SceneInput input = style_input();
  const Image usual = frame(input, 40);
  input.spec.trail = 32.0 / 25;
  EXPECT_EQ(frame(input, 40), usual) << "the default is 32 frames";
  input.spec.trail = 0;
  const Image none = frame(input, 40);
  input.spec.trail = 0.2;
  const Image some = frame(input, 40);
  EXPECT_GT(differing_pixels(some, none), 20U);
  EXPECT_GT(differing_pixels(usual, none), 2 * differing_pixels(some, none));
}

TEST_F(SceneStyle, OtherRunsAndPointsAreDrawnInTheirColours) {
  Trajectory later = trajectory_;
  for (std::size_t i = 0; i + 10 < later.q.size(); ++i) {
    later.q[i] = trajectory_.q[i + 10];
    later.v[i] = trajectory_.v[i + 10];
  }
  for (const auto& [theme_word, theme_written] : words_of<SceneTheme>) {
    SceneInput input = style_input();
    input.spec.size = {960, 540};
    input.spec.theme = theme_word;
    input.spec.trail = 0.4;
    input.label = "4 elements";
    input.others.push_back(scene_run(swing_case(), later, "a little later"));
    ScenePoints published{"published", {}, {}, {}};
    for (std::size_t i = 0; i < trajectory_.times.size(); i += 5) {
      published.times.push_back(trajectory_.times[i]);
      published.places.push_back(trajectory_.q[i].segment<3>(24));
    }
    input.points.push_back(published);
    SceneRenderer scene(context_, trajectory_, input);
    const Image image = scene.frame(20);
    keep(std::string("over_") + std::string(theme_written), image);
    const std::array<int, 3> other = at(image, scene.pixel(later.q[40].segment<3>(12), 0.8));
    EXPECT_GT(other[0], other[2] + 60) << "the other run is not in its orange";
    const std::array<int, 3> point = at(image, scene.pixel(published.places[8], 0.8));
    EXPECT_GT(point[1], point[0] + 40) << "the latest point is not in its green";

    input.others[0].offset = {1.6, 0, 0};
    SceneRenderer beside(context_, trajectory_, input);
    const Image apart = beside.frame(20);
    keep(std::string("beside_") + std::string(theme_written), apart);
    const Vec3 moved = later.q[40].segment<3>(12) + Vec3(1.6, 0, 0);
    const std::array<int, 3> there = at(apart, beside.pixel(moved, 0.8));
    EXPECT_GT(there[0], there[2] + 60) << "the other run is not where it was put";
  }
}

TEST_F(SceneStyle, PointsAreSeenFromTheirTimeOnForAsLongAsATrail) {
  SceneInput input = style_input();
  input.spec.trail = 0.1;
  input.spec.background = SceneBackground::plain;
  input.points.push_back({"", {0.4, 1.0}, {{0, 0.6, 0}, {0, 0.5, 0}}, Color::hex(0x009E73)});
  SceneRenderer scene(context_, trajectory_, input);
  const auto is_seen = [&](const Vec3& place, double time) {
    const std::array<int, 3> color = at(scene.at(time), scene.pixel(place, time));
    return color[1] > color[0] + 40;
  };
  EXPECT_FALSE(is_seen({0, 0.6, 0}, 0.39));
  EXPECT_TRUE(is_seen({0, 0.6, 0}, 0.4));
  EXPECT_TRUE(is_seen({0, 0.6, 0}, 0.9)) << "the latest";
  EXPECT_FALSE(is_seen({0, 0.6, 0}, 1.0)) << "longer ago than the trail";
  EXPECT_TRUE(is_seen({0, 0.5, 0}, 1.0));
}

TEST_F(SceneStyle, WhatCannotBeDrawnIsRefused) {
  SceneInput input = style_input();
  input.points.push_back({"one time too many", {0, 1}, {{0, 0, 0}}, {}});
  EXPECT_THROW(frame(input), OutputError);
  input = style_input();
  input.points.push_back({"nowhere", {0}, {{0, std::numeric_limits<double>::quiet_NaN(), 0}}, {}});
  EXPECT_THROW(frame(input), OutputError);
  input = style_input();
  input.others.emplace_back();
  input.others[0].length = 1;
  EXPECT_THROW(frame(input), OutputError);
  const Trajectory empty;
  input.others[0].trajectory = &empty;
  EXPECT_THROW(frame(input), OutputError);
  input = style_input();
  input.spec.ghosts = 2;
  input.spec.ghost_interval = 0;
  EXPECT_THROW(frame(input), OutputError);
}

TEST_F(SceneStyle, SameInputGivesTheSamePixels) {
  SceneInput input = style_input();
  input.spec.color_by = ColorField::curvature;
  input.spec.view = View::orbit;
  input.spec.ghosts = 4;
  input.spec.background = SceneBackground::transparent;
  SceneRenderer scene(context_, trajectory_, input);
  const Image first = scene.frame(20);
  scene.frame(3);
  EXPECT_EQ(scene.frame(20), first);
  EXPECT_EQ(frame(input, 20), first);
}

}  // namespace scene_style_test
}  // namespace plumb
