#include <gtest/gtest.h>

#include "engine/model/cable.h"
#include "render/plot/plot_renderer.h"
#include "render/scene/scene.h"
#include "tests/render/scene/swing.h"

namespace plumb {
namespace backends_test {

std::size_t differing_bytes(const Image& a, const Image& b) {
  if (a.rgb.size() != b.rgb.size()) return std::max(a.rgb.size(), b.rgb.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) count += a.rgb[i] != b.rgb[i] ? 1 : 0;
  return count;
}

class BackendsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!osmesa_is_there()) GTEST_SKIP() << "libOSMesa cannot be opened";
    const auto devices = egl_devices();
    if (std::none_of(devices.begin(), devices.end(), [](const EglDevice& any) { return any.software; }))
      GTEST_SKIP() << "EGL has no device that draws in software: " << devices.size() << " devices";
  }
};

TEST_F(BackendsTest, DrawTheSameFrames) {
  const Trajectory trajectory = swing();
  SceneInput input = swing_input();
  input.spec.size = {480, 270};
  const GlContext osmesa({GlBackendKind::osmesa, -1});
  SceneRenderer first(osmesa, trajectory, input);
  const GlContext egl({GlBackendKind::egl, -1});
  SceneRenderer second(egl, trajectory, input);
  for (const int k : {0, 7, 20, 33, 50}) {
    osmesa.make_current();
    const Image a = first.frame(k);
    egl.make_current();
    const Image b = second.frame(k);
    EXPECT_EQ(a, b) << "frame " << k << ": " << differing_bytes(a, b) << " bytes differ between "
                    << osmesa.info().fingerprint() << " and " << egl.info().fingerprint();
  }
}

TEST_F(BackendsTest, DrawTheSameStyles) {
  const Trajectory trajectory = swing();
  Case spec;
  spec.cable = {1, 2.5e-5, 320, 1.6e6, 5e-11, 4};
  SceneInput input = swing_input();
  input.cable = std::make_shared<Cable>(spec);
  input.spec.size = {480, 270};
  input.spec.theme = SceneTheme::dark;
  input.spec.color_by = ColorField::curvature;
  input.spec.ghosts = 3;
  input.points.push_back({"points", {0, 0.5}, {{0.3, -0.2, 0.1}, {0.4, -0.1, 0.2}}, {}});
  const GlContext osmesa({GlBackendKind::osmesa, -1});
  const GlContext egl({GlBackendKind::egl, -1});
  for (const View view : {View::orbit, View::follow, View::front})
    for (const SceneBackground background : {SceneBackground::scene, SceneBackground::transparent}) {
      input.spec.view = view;
      input.spec.background = background;
      osmesa.make_current();
      const Image a = SceneRenderer(osmesa, trajectory, input).frame(20);
      egl.make_current();
      const Image b = SceneRenderer(egl, trajectory, input).frame(20);
      EXPECT_EQ(a, b) << "view " << static_cast<int>(view) << ": " << differing_bytes(a, b)
                      << " bytes differ";
    }
}

TEST_F(BackendsTest, DrawTheSamePlots) {
  Plot plot;
  plot.title = "both";
  Panel panel;
  panel.x.label = "time [s]";
  panel.y.scale = Scale::logarithmic;
  panel.series.push_back({"one", {0, 1, 2, 3}, {1, 10, 3, 200}, {}, 1, Dash::dashed, Marker::circle});
  panel.series.push_back({"other", {0, 1, 2, 3}, {5, 2, 30, 70}, {}, 2});
  plot.panels.push_back(panel);
  plot.width = 640;
  plot.height = 480;
  plot.font_size = 16;
  const GlContext osmesa({GlBackendKind::osmesa, -1});
  const Image a = PlotRenderer(osmesa).draw(plot);
  const GlContext egl({GlBackendKind::egl, -1});
  const Image b = PlotRenderer(egl).draw(plot);
  EXPECT_EQ(a, b) << differing_bytes(a, b) << " bytes differ";
}

}  // namespace backends_test
}  // namespace plumb
