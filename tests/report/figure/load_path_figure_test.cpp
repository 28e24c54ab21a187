#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/document/case_json.h"
#include "report/figure/run_figures.h"
#include "tests/report/made_run.h"

namespace plumb {

std::optional<Figure> load_path_figure(const Run& run);

namespace load_path_figure_test {

/// Stable up to 0.6 of the load, unstable to 0.8, and stable elsewhere.
plumb::Run run_with_path() {
  plumb::Run run = run_with("a");
  Equilibria& equilibria = run.trajectory.equilibria;
  equilibria.negative_eigenvalues = {0, 1, 0};
  equilibria.path = {
      {0, 0, 0, true}, {0.6, 1, 0, true}, {0.7, 2, 1, true}, {0.8, 3, 1, true}, {0.8, 9, 0, false}};
  equilibria.critical_points = {
      {CriticalKind::limit_point, 0.65, 1.5, 0, 1, 1, {0, 1, 0}, "along the same path"}};
  return run;
}

TEST(LoadPathFigure, TellsStablePartsFromUnstableOnesAndMarksThePoints) {
  const Figure figure = load_path_figure(run_with_path()).value();
  const Panel& panel = figure.plot.panels.at(0);
  ASSERT_EQ(panel.series.size(), 3U) << "no bifurcation is drawn where there is none";
  const Series &stable = panel.series[0], &unstable = panel.series[1], &limit = panel.series[2];
  EXPECT_EQ(stable.label, "stable");
  EXPECT_EQ(unstable.label, "unstable");
  EXPECT_NE(stable.dash, unstable.dash);
  // A gap before where the cable went over.
  ASSERT_EQ(stable.x.size(), 4U);
  EXPECT_EQ(stable.x[1], 1);
  EXPECT_TRUE(std::isnan(stable.x[2]));
  EXPECT_EQ(stable.x[3], 9);
  // From the last stable point on.
  ASSERT_GE(unstable.x.size(), 4U);
  EXPECT_TRUE(std::isnan(unstable.x[0]));
  EXPECT_EQ(unstable.x[1], 1);
  EXPECT_EQ(unstable.y[3], 0.8);
  EXPECT_EQ(limit.label, "limit point");
  EXPECT_EQ(limit.x, std::vector<double>{1.5});
  EXPECT_EQ(limit.line_width, 0);
  EXPECT_NE(figure.alt.find("a limit point at 0.65 of the load"), std::string::npos) << figure.alt;
}

TEST(LoadPathFigure, IsOneOfTheFiguresOfARunThatHasAPathOnly) {
  const auto has = [](const plumb::Run& run) {
    for (const Figure& figure : figures(run, {}))
      if (figure.name == "load_path") return true;
    return false;
  };
  EXPECT_TRUE(has(run_with_path()));
  EXPECT_FALSE(has(run_with("a")));
}

TEST(LoadPathFigure, HasItsNumbersInTheJsonOfTheRun) {
  const auto json = solve_json(run_with_path());
  EXPECT_EQ(json["equilibria"]["negative_eigenvalues"], (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(json["equilibria"]["path"]["load"].size(), 5U);
  EXPECT_EQ(json["equilibria"]["path"]["load"][2], 0.7);
  EXPECT_EQ(json["equilibria"]["path"]["joined"][4], false);
  EXPECT_EQ(json["equilibria"]["critical_points"][0]["kind"], "limit-point");
  EXPECT_FALSE(solve_json(run_with("a")).contains("equilibria"));
}

}  // namespace load_path_figure_test
}  // namespace plumb
