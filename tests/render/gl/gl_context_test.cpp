#include "render/gl/gl_context.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "engine/base/errors.h"
#include "render/gl/painter.h"

namespace plumb {
namespace gl_context_test {

TEST(GlContext, TellsWhatItRunsOn) {
  const GlContext context;
  EXPECT_FALSE(context.info().renderer.empty());
  EXPECT_GE(context.info().version.front(), '3') << context.info().version;
  EXPECT_GE(context.info().max_size, 4096);
  EXPECT_GE(context.info().max_samples, 4);
}

TEST(GlContext, TakesTheBackendThatTheEnvironmentNames) {
  for (const char* wrong : {"glx", "egl:", "egl:x", "egl:-1", "egl:99999", "OSMesa"}) {
    setenv("PLUMB_GL", wrong, 1);
    EXPECT_THROW(GlBackendChoice::from_environment(), UsageError) << wrong;
  }
  setenv("PLUMB_GL", "egl:12", 1);
  const GlBackendChoice choice = GlBackendChoice::from_environment();
  EXPECT_EQ(choice.kind, GlBackendKind::egl);
  EXPECT_EQ(choice.device, 12);
  setenv("PLUMB_GL", "osmesa", 1);
  EXPECT_EQ(GlBackendChoice::from_environment().kind, GlBackendKind::osmesa);
  unsetenv("PLUMB_GL");
  EXPECT_EQ(GlBackendChoice::from_environment().kind == GlBackendKind::osmesa,
            osmesa_is_there() || !egl_is_there());
}

TEST(GlContext, RefusesADeviceThatIsNotThere) {
  if (!egl_is_there()) GTEST_SKIP() << "libEGL cannot be opened";
  EXPECT_THROW(GlContext({GlBackendKind::egl, 900}), OutputError);
}

TEST(GlContext, RefusesTheVectorWidthThatCrashesTheDriver) {
  for (const char* wrong : {"512", "64", "-128", "wide"}) {
    setenv("LP_NATIVE_VECTOR_WIDTH", wrong, 1);
    EXPECT_THROW(GlContext(), UsageError) << wrong;
  }
  unsetenv("LP_NATIVE_VECTOR_WIDTH");
  EXPECT_NO_THROW(GlContext());
}

TEST(GlContext, RefusesSizesBeyondTheLimitAfterSupersampling) {
  const GlContext context;
  const int limit = context.info().max_size;
  EXPECT_NO_THROW(context.check_size(limit, 1, 1));
  EXPECT_NO_THROW(context.check_size(limit / 4, limit / 4, 4));
  EXPECT_THROW(context.check_size(limit + 1, 1, 1), OutputError);
  EXPECT_THROW(context.check_size(1, limit / 4 + 1, 4), OutputError);
  EXPECT_THROW(context.check_size(2147483647, 1, 4), OutputError);
  EXPECT_THROW(context.check_size(0, 1, 1), OutputError);
  EXPECT_THROW(Canvas(context, limit + 1, 1), OutputError);
}

TEST(GlContext, TwoLiveBesideEachOther) {
  const GlContext first;
  Canvas a(first, 8, 8);
  const GlContext second;
  Canvas b(second, 8, 8);
  first.make_current();
  a.begin_flat(Color::hex(0xFF0000));
  second.make_current();
  b.begin_flat(Color::hex(0x00FF00));
  EXPECT_EQ(b.read().rgb[1], 255);
  first.make_current();
  EXPECT_EQ(a.read().rgb[0], 255);
}

std::array<int, 3> at(const Image& image, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

TEST(Painter, LineCoversItsWidthAndNothingElse) {
  const GlContext context;
  Canvas canvas(context, 40, 20);
  Painter painter(context);
  canvas.begin_flat(Color::hex(0xFFFFFF));
  painter.begin(canvas);
  painter.line(std::vector{Point(5, 8), Point(35, 8)}, 4, Color::hex(0x0072B2));
  const Image image = canvas.read();
  EXPECT_EQ(at(image, 20, 7), (std::array{0, 0x72, 0xB2})) << "rows 6 to 9 are the line's";
  EXPECT_EQ(at(image, 20, 6), (std::array{0, 0x72, 0xB2}));
  EXPECT_EQ(at(image, 20, 5), (std::array{255, 255, 255}));
  EXPECT_EQ(at(image, 20, 10), (std::array{255, 255, 255}));
}

TEST(Painter, CrossingOfATranslucentLineIsNotDarker) {
  const GlContext context;
  Canvas canvas(context, 40, 40);
  Painter painter(context);
  canvas.begin_flat(Color::hex(0xFFFFFF));
  painter.begin(canvas);
  const std::vector<Point> path = {{5, 20}, {35, 20}, {20, 35}, {20, 5}};
  painter.line(path, 6, Color{0, 0, 0, 0.5F});
  const Image image = canvas.read();
  EXPECT_EQ(at(image, 20, 20), at(image, 10, 20));
}

TEST(Painter, NotANumberBreaksALine) {
  const GlContext context;
  Canvas canvas(context, 40, 20);
  Painter painter(context);
  canvas.begin_flat(Color::hex(0xFFFFFF));
  painter.begin(canvas);
  const double nan = std::nan("");
  painter.line(std::vector<Point>{{2, 10}, {12, 10}, {nan, 10}, {28, 10}, {38, 10}}, 4, Color::hex(0));
  const Image image = canvas.read();
  EXPECT_EQ(at(image, 8, 10)[0], 0);
  EXPECT_EQ(at(image, 20, 10)[0], 255);
  EXPECT_EQ(at(image, 32, 10)[0], 0);
}

}  // namespace gl_context_test
}  // namespace plumb
