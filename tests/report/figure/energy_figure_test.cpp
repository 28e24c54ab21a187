#include <gtest/gtest.h>

#include "report/figure/run_figures.h"
#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {

std::optional<Figure> energy_figure(const Run& run);

namespace energy_figure_test {

plumb::Run run_with_energies() {
  plumb::Run run = run_with("a");
  run.trajectory.energies.assign(run.trajectory.times.size(), {.axial = 1, .bending = 2, .potential = -4});
  run.trajectory.energies.front() = {};
  return run;
}

TEST(EnergyFigure, CallsTheWorkOfAGrowingLoadNoDrift) {
  plumb::Run run = run_with_energies();
  run.trajectory.equilibria.negative_eigenvalues.assign(run.trajectory.times.size(), 0);
  const Figure figure = energy_figure(run).value();
  ASSERT_EQ(figure.plot.panels.size(), 1U);
  EXPECT_EQ(figure.alt.find("drift"), std::string::npos) << figure.alt;
  const Panel& panel = figure.plot.panels.front();
  ASSERT_EQ(panel.series.size(), 4U) << "nothing moves";
  EXPECT_EQ(panel.series[0].label, "axial strain");
  EXPECT_EQ(panel.series[2].label, "potential of the load that acts");
  EXPECT_EQ(panel.series[3].label, "sum");
  EXPECT_EQ(panel.series[3].y.back(), -1);
  EXPECT_EQ(drift_in_words(run.trajectory), "none, as the load grew and did work");
}

TEST(EnergyFigure, ShowsTheDriftOfAMotion) {
  const plumb::Run run = run_with_energies();
  const Figure figure = energy_figure(run).value();
  ASSERT_EQ(figure.plot.panels.size(), 2U);
  EXPECT_NE(figure.alt.find("drifts by at most 1 J"), std::string::npos) << figure.alt;
}

TEST(EnergyFigure, ShowsADriftOfRoundOffAsNothing) {
  plumb::Run run = run_with("a");
  run.trajectory.energies.assign(run.trajectory.times.size(), {.kinetic = 1});
  run.trajectory.energies.back().kinetic = 1 + 2e-15;
  const Figure figure = energy_figure(run).value();
  const Panel& drift = figure.plot.panels.at(1);
  const double bound = run.trajectory.energy_round_off();
  EXPECT_GT(bound, 2e-15);
  EXPECT_LT(bound, 1e-12);
  ASSERT_TRUE(drift.y.range.has_value());
  EXPECT_GT(drift.y.range->at(1), 2 * bound) << "the drift fills less than half of what is shown";
  ASSERT_EQ(drift.rules.size(), 1U);
  EXPECT_EQ(drift.rules[0].label, "below round-off");
  EXPECT_NE(drift_in_words(run.trajectory).find("no more than rounding makes"), std::string::npos)
      << drift_in_words(run.trajectory);

  run.trajectory.energies.back().kinetic = 1 + 3 * bound;
  EXPECT_FALSE(energy_figure(run)->plot.panels.at(1).y.range.has_value())
      << "a drift that is one is drawn as one";
  EXPECT_EQ(drift_in_words(run.trajectory).find("rounding"), std::string::npos);
}

}  // namespace energy_figure_test
}  // namespace plumb
