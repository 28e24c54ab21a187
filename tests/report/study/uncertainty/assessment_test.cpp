#include "engine/study/uncertainty/assessment.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/study/uncertainty/budget_json.h"
#include "engine/study/uncertainty/uncertainty_json.h"
#include "report/study/uncertainty/budget_figure.h"
#include "report/study/uncertainty/budget_section.h"
#include "report/study/uncertainty/uncertainty_figure.h"
#include "report/study/uncertainty/uncertainty_section.h"
#include "report/verdict/results.h"
#include "tests/report/made_run.h"
#include "tests/report/program/program.h"
#include "tests/report/study/uncertainty/made_assessment.h"

namespace plumb {
namespace assessment_test {

using Json = nlohmann::ordered_json;

void expect_all_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(UncertaintyJson, IsReadBackAsItWas) {
  const Json json = uncertainty_json(made_uncertainty());
  EXPECT_EQ(uncertainty_json(uncertainty_from_json(json)).dump(), json.dump());
  const Json& series = json["series"][0];
  EXPECT_EQ(series["error_at_greatest"], -0.1);
  EXPECT_DOUBLE_EQ(series["validation_uncertainty_at_greatest"], 0.005);
  EXPECT_EQ(series["at_least"], true);
  EXPECT_FALSE(series["parts"][2].contains("at_greatest_error")) << "what is not estimated has no number";
}

TEST(UncertaintySection, SaysEveryPartAndNeverANumberForOneThatIsNotEstimated) {
  const std::string page = uncertainty_on_page().html(uncertainty_json(made_uncertainty()), {});
  expect_all_in(page, {"0 of 1 comparison stay within their uncertainty (2 u ≥ 0.01 m at most) at all times; "
                       "known: tip.y is beyond it most often, at 33 % of the times."});
  EXPECT_LT(page.find("0 of 1 comparison"), page.find("After ")) << "the answer is first";
  expect_all_in(page,
                {"known: tip.y", ">-0.1<", ">0.003<", ">0.004<", ">≥ 0.005<", ">≥ 0.01<", "67 %",
                 "distinguishable at 1 of 3 times, at 1 s: model error between 0.09 and 0.11 m at 1 s",
                 "by &lt;meshes&gt;", "nobody knows", "not estimated", "no part", "standard deviation 25 %",
                 "a &lt;sheet&gt;", "4 samples were asked for; 3 have a result, 1 failed",
                 "cable.density = -1: refused", "other: tip.x: the run did not complete"});
  EXPECT_EQ(page.find(">0<"), std::string::npos) << page;
  const std::string whole =
      uncertainty_on_page().html(uncertainty_json(made_uncertainty(PartState::no_part)), {});
  EXPECT_EQ(whole.find("≥"), std::string::npos) << "every part is known";
}

TEST(UncertaintyFigure, HasABandOfTwiceTheUncertaintyForEverySeriesWithManyTimes) {
  Uncertainty made = made_uncertainty();
  EXPECT_TRUE(uncertainty_figure(made).plot.panels.empty()) << "three times make no curve";
  SeriesUncertainty& series = made.series[0];
  for (UncertaintyPart& part : series.parts)
    if (part.has_values()) part.values.assign(fewest_times_drawn, part.values.back());
  series.times.clear();
  for (std::size_t k = 0; k < fewest_times_drawn; ++k) series.times.push_back(static_cast<double>(k));
  series.error.assign(fewest_times_drawn, 0.02);
  conclude(series);
  const Figure figure = uncertainty_figure(made);
  const Panel& panel = figure.plot.panels.at(0);
  EXPECT_NEAR(panel.series.at(0).band.upper.at(3), 0.01, 1e-15);
  EXPECT_NEAR(panel.series[0].band.lower.at(3), -0.01, 1e-15);
  EXPECT_EQ(panel.series[0].label, "± 2 u, at least");
  EXPECT_EQ(panel.series.at(1).y, series.error);
  EXPECT_NE(figure.alt.find("distinguishable at 8 of 8 times"), std::string::npos) << figure.alt;
}

TEST(VerdictUncertainty, TheTextOfAVerdictSaysErrorUncertaintyAndWhatFollows) {
  const plumb::Run run = run_with("made");
  const Results with = evaluate(run, {}, {uncertainty_section(made_uncertainty(), run.loaded.spec)}),
                without = evaluate(run, {});
  ASSERT_EQ(with.verdicts.size(), 1U);
  EXPECT_EQ(with.verdicts[0].message, without.verdicts[0].message +
                                          "; E = -0.1 m with u_val ≥ 0.005 m: distinguishable at 1 of 3 "
                                          "times, at 1 s: model error between 0.09 and 0.11 m at 1 s, or in "
                                          "wider bounds: not every part is estimated");
  EXPECT_EQ(with.verdicts[0].status, without.verdicts[0].status) << "the criterion is the case's own";
}

TEST(BudgetJson, IsReadBackAsItWas) {
  const Json json = budget_json(made_budget());
  EXPECT_EQ(budget_json(budget_from_json(json)).dump(), json.dump());
  Json damaged = json;
  damaged["items"][0]["run"]["distances"].erase(1);
  EXPECT_THROW(budget_from_json(damaged), std::runtime_error);
}

TEST(BudgetSection, ShowsEveryItemAloneAndAllTogether) {
  const std::string page = budget_on_page().html(budget_json(made_budget()), {});
  expect_all_in(page,
                {"repeats it to 2e-06 m", "gravity 0.004 m, step unstable at most; all together 0.012 m",
                 "strain (for information)", ">0.0015<", ">0.005<", "unstable: it grew", "every 0.001 s",
                 "as &lt;stated&gt;", "method.name=euler"});
  ErrorBudget none;
  none.reference = "known";
  none.left_out = "the reference is for another cable";
  const std::string empty = budget_on_page().html(budget_json(none), {});
  expect_all_in(empty, {"No error budget of known: the reference is for another cable."});
  EXPECT_EQ(empty.find("<table"), std::string::npos);
}

TEST(BudgetFigure, HasAGroupOfBarsForEachSeriesAndNoneForWhatFailed) {
  const Figure figure = budget_figure(made_budget());
  const Panel& panel = figure.plot.panels.at(0);
  EXPECT_EQ(panel.x.tick_labels, (std::vector<std::string>{"tip.y", "tip.z"}));
  ASSERT_EQ(panel.bars.size(), 2U * 3) << "gravity, all together, strain";
  const std::vector<double> heights{1.5e-3, 4.5e-3, 1.5e-4, 5e-3, 15e-3, 5e-4};
  for (std::size_t k = 0; k < heights.size(); ++k) {
    EXPECT_EQ(panel.bars[k].y[0], 0) << "a bar that does not start at 0 misleads";
    EXPECT_NEAR(panel.bars[k].y[1], heights[k], 1e-12) << k;
  }
  expect_all_in(figure.alt, {"step did not complete", "tip.z: gravity 0.005 m", "all together 0.015 m"});
}

/// A short run of the pendulum with fewer samples and meshes that are quick.
std::vector<std::string> quick(std::vector<std::string> arguments) {
  for (const char* set : {"time.end=0.1", "reference.0.coverage.to=0.1", "reference.1.coverage.to=0.1",
                          "scene.size=[160,90]", "uncertainty.samples=3", "study={}"}) {
    arguments.emplace_back("--set");
    arguments.emplace_back(set);
  }
  return arguments;
}

TEST(Program, ReportsUncertaintyAndErrorBudgetAgainWithoutComputingThem) {
  const TemporaryFolder folder;
  const Ended first = plumb_in(folder.path(), quick({"run", case_path("pendulum.toml"), "--json"}));
  ASSERT_EQ(first.status, 0) << first.err;
  const Json computed = Json::parse(first.out);
  ASSERT_EQ(computed["uncertainty"]["series"].size(), 6U);
  ASSERT_EQ(computed["error_budget"]["items"].size(), 5U);
  EXPECT_TRUE(fs::exists(folder / "output/pendulum/figures/error_budget.png"));
  const Ended second = plumb_in(folder.path(), {"report", "output/pendulum", "--json"});
  ASSERT_EQ(second.status, 0) << second.err;
  const Json shown = Json::parse(second.out);
  EXPECT_EQ(shown["uncertainty"], computed["uncertainty"]);
  EXPECT_EQ(shown["error_budget"], computed["error_budget"])
      << "its seconds would differ if it were made anew";
  EXPECT_EQ(shown["verdicts"], computed["verdicts"]);
  for (const char* part : {"E = ", "u_val"})
    EXPECT_NE(shown["verdicts"][0]["message"].get<std::string>().find(part), std::string::npos) << part;
  expect_all_in(read_text(folder / "output/pendulum/index.html"),
                {"id=\"uncertainty\"", "id=\"budget\"", "error_budget.png"});

  write_text(folder / "output/pendulum/assessment.json", "{}");
  const Ended damaged = plumb_in(folder.path(), {"report", "output/pendulum"});
  EXPECT_EQ(damaged.status, 3) << damaged.err;
  expect_one_line(damaged.err);
  EXPECT_NE(damaged.err.find("assessment.json: cannot be used"), std::string::npos) << damaged.err;
}

}  // namespace assessment_test
}  // namespace plumb
