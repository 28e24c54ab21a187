#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/gl/gl_context.h"
#include "render/plot/plot_renderer.h"
#include "report/figure/number_markup.h"
#include "report/figure/run_figures.h"
#include "tests/render/image/pictures.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace field_figures_test {

std::vector<std::string> names(const std::vector<Figure>& figures) {
  std::vector<std::string> result;
  for (const Figure& figure : figures) result.push_back(figure.name);
  return result;
}

/// Those of what happens along the cable.
std::vector<Figure> field_figures(const plumb::Run& run) {
  std::vector<Figure> result;
  for (const RunFigure& known : run_figures()) {
    std::optional<Figure> figure = known.name == "energy" || known.of_modes ? std::nullopt : known.draw(run);
    if (!figure) continue;
    figure->name = known.name;
    result.push_back(std::move(*figure));
  }
  return result;
}

const Figure& figure_of(const std::vector<Figure>& figures, const std::string& name) {
  return *std::find_if(figures.begin(), figures.end(),
                       [&](const Figure& figure) { return figure.name == name; });
}

TEST(FieldFigures, AreRangesOfTensionAndCurvatureAndAMapOfTheStrain) {
  const plumb::Run run = run_with("a");
  const std::vector<Figure> found = field_figures(run);
  EXPECT_EQ(names(found), (std::vector<std::string>{"tension_range", "curvature_range", "strain_map"}));
  const Panel& tension = found[0].plot.panels[0];
  ASSERT_EQ(tension.series.size(), 3U);
  const Series& mean = tension.series[1];
  EXPECT_EQ(mean.band.lower, tension.series[2].y);
  EXPECT_EQ(mean.band.upper, tension.series[0].y);
  for (std::size_t k = 0; k < mean.y.size(); ++k) {
    EXPECT_LE(mean.band.lower[k], mean.y[k]) << k;
    EXPECT_LE(mean.y[k], mean.band.upper[k]) << k;
  }
  EXPECT_EQ(tension.y.label, "tension [N]");
  EXPECT_EQ(found[1].plot.panels[0].y.label, "curvature κ [m^{-1}]");
  const HeatMap& map = found[2].plot.panels[0].heat_map.value();
  EXPECT_EQ(map.x_edges.size(), 4U) << "three outputs";
  EXPECT_EQ(map.y_edges.back(), 2) << "m";
}

TEST(FieldFigures, ShowTheCurvatureOfAStraightCableAsNothing) {
  for (const bool bent : {false, true}) {
    plumb::Run run = run_with("a");
    if (!bent)
      for (Eigen::VectorXd& q : run.trajectory.q) q[7] = 0;
    const std::vector<Figure> found = field_figures(run);
    const Panel& curvature = figure_of(found, "curvature_range").plot.panels[0];
    double greatest = 0;
    for (const Series& series : curvature.series)
      for (const double value : series.y) greatest = std::max(greatest, std::abs(value));
    EXPECT_EQ(greatest > 1e-6, bent) << greatest;
    EXPECT_EQ(curvature.y.range.has_value(), !bent);
    EXPECT_EQ(curvature.rules.size(), bent ? 0U : 1U);
  }
}

TEST(FieldFigures, SayWhereTheGreatestTensionIsAndWhen) {
  // EA is 1 N. In the middle of the only element, of 2 m, the slope is (1, -0.75 t²): a strain of 0.28125 at
  // 1 s.
  const Figure figure = figure_of(field_figures(run_with("a")), "tension_range");
  EXPECT_NE(figure.alt.find("The greatest is 0.3516 N, 1 m from the first end, at 1 s"), std::string::npos)
      << figure.alt;
}

TEST(FieldFigures, OfAChainLeaveOutTheCurvature) {
  plumb::Run run = run_with("a", "");
  run.loaded.spec.cable.model = CableModel::chain;
  EXPECT_EQ(names(field_figures(run)), (std::vector<std::string>{"tension_range", "strain_map"}));
}

TEST(FieldFigures, OfARunWithoutOutputsAreNone) {
  plumb::Run run = run_with("a");
  run.trajectory.times.resize(1);
  run.trajectory.q.resize(1);
  run.trajectory.v.resize(1);
  EXPECT_EQ(field_figures(run).size(), 2U) << "one output has ranges, but no map";
  for (double& value : run.trajectory.q[0]) value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(field_figures(run).empty());
  run.trajectory.times.clear();
  run.trajectory.q.clear();
  run.trajectory.v.clear();
  EXPECT_TRUE(field_figures(run).empty());
}

TEST(Figures, OfACaseKeepANameThatEveryRunHasAFigureOf) {
  plumb::Run run = run_with("a");
  FigureSpec& figure = run.loaded.spec.figures.emplace_back();
  figure.name = "strain_map";
  figure.y = "tip.y";
  const std::vector<Figure> found = figures(run, {});
  EXPECT_EQ(names(found),
            (std::vector<std::string>{"strain_map", "energy", "tension_range", "curvature_range"}));
  EXPECT_FALSE(found.front().plot.panels[0].heat_map);
}

TEST(Figures, OfARunAreDrawnInTheThemeOfItsScene) {
  const std::string figure =
      "[[figure]]\nname = \"height\"\ntitle = \"a^{b} \\\\_{c}\"\ny = \"tip.y\"\n"
      "reference = \"known\"\n";
  const GlContext context;
  PlotRenderer renderer(context);
  for (const std::string theme : {"light", "dark"}) {
    const plumb::Run run = run_with("a", figure + "[scene]\ntheme = \"" + theme + "\"\n");
    for (const Figure& each : figures(run, series_errors(run))) {
      const Image image = renderer.draw(each.plot);
      keep("figure_" + each.name + "_" + theme, image);
      EXPECT_EQ(image.rgb[0] < 128, theme == "dark") << each.name;
    }
  }
}

TEST(Figures, ShowTheTitleOfTheCaseLiterally) {
  const plumb::Run run =
      run_with("a", "[[figure]]\nname = \"height\"\ntitle = \"a^{b} \\\\_{c}\"\ny = \"tip.y\"\n");
  const Figure figure = figures(run, series_errors(run)).front();
  EXPECT_EQ(figure.title, "a^{b} \\_{c}");
  EXPECT_EQ(figure.plot.title, R"(a\^\{b\} \\\_\{c\})");
}

TEST(Figures, ShowHowFarTheReferenceIsUncertain) {
  const plumb::Run run =
      run_with("a", "[[figure]]\nname = \"height\"\ny = \"tip.y\"\nreference = \"known\"\n");
  const Figure figure = figures(run, series_errors(run)).front();
  const Series& points = figure.plot.panels[0].series[1];
  EXPECT_EQ(points.y_error.lower, (std::vector<double>{-0.01, -0.26, -0.9 - 0.01}));
  EXPECT_EQ(points.y_error.upper, (std::vector<double>{0.01, -0.24, -0.9 + 0.01}));
  ASSERT_EQ(figure.plot.panels[1].rules.size(), 1U) << "a tenth of the difference";
  EXPECT_EQ(figure.plot.panels[1].rules[0].from, -0.01);
  EXPECT_EQ(figure.plot.panels[1].rules[0].to, 0.01);
  EXPECT_EQ(figure.plot.panels[1].rules[0].label, "uncertainty of the reference: ±0.01 m");
}

TEST(UnitMarkup, WritesWhatIsBelowASlashAsANegativePower) {
  EXPECT_EQ(unit_markup("1/m"), "m^{-1}");
  EXPECT_EQ(unit_markup("m/s"), "m s^{-1}");
  EXPECT_EQ(unit_markup("m/s^2"), "m s^{-2}");
  EXPECT_EQ(unit_markup("N m"), "N m");
  EXPECT_EQ(unit_markup("1"), "1");
  EXPECT_EQ(unit_markup("a/b/c"), "a/b/c");
  EXPECT_EQ(unit_markup("m_{x}/s"), "m\\_\\{x\\} s^{-1}");
}

TEST(NumberMarkup, HasAPowerOfTenWhereANumberIsSmallOrLarge) {
  EXPECT_EQ(unit_markup("kg/m³"), "kg m^{-3}");
  EXPECT_EQ(unit_text("m/s²"), "m s⁻²");
  EXPECT_EQ(unit_text("1/m"), "m⁻¹");
  EXPECT_EQ(unit_text("N m"), "N m");
  EXPECT_EQ(unit_text("m/s/s"), "m/s/s") << "what is not understood stays";
  EXPECT_EQ(unit_after("1"), "");
  EXPECT_EQ(unit_after("rad/s"), " rad s⁻¹");
  EXPECT_EQ(plain_text("10^{-12} κ_{max} ω_{10} of mid_y"), "10⁻¹² κmax ω₁₀ of mid_y");
  EXPECT_EQ(number_markup(0.031), "0.031");
  EXPECT_EQ(number_markup(3.1e-12), "3.1·10^{-12}");
  EXPECT_EQ(number_markup(0), "0");
}

}  // namespace field_figures_test
}  // namespace plumb
