#include "report/study/sensitivity/sensitivity_results.h"

#include <gtest/gtest.h>

#include "report/document/document.h"
#include "report/page/page_section.h"
#include "report/study/sensitivity/sensitivity_figure.h"
#include "report/study/sensitivity/sensitivity_section.h"
#include "report/verdict/results.h"
#include "tests/report/study/made_studies.h"

namespace plumb {
namespace sensitivity_results_test {

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
}

TEST(SensitivityReport, SaysInASentenceWhatACriterionNotices) {
  const Sensitivity found = made_sensitivity().result;
  EXPECT_EQ(
      noticed_in_words(found, 0),
      "0.035 m on known: tip.y notices 6.2 % of density, 33 % of bending stiffness and nothing of gravity "
      "along y; of the blunders a chain of springs and a density of a thousandth, but not twice the mesh")
      << "half as much again downwards is a third less";
  EXPECT_EQ(
      noticed_in_words(found, 1),
      "0.5 m on known: tip.x notices 50 % of density (where the run fails) and nothing of bending "
      "stiffness and gravity along y; of the blunders twice the mesh and a density of a thousandth, but "
      "not a chain of springs");
  expect_in(noticed_in_words(found, 2), {"is not met by the case itself"});
  expect_in(noticed_in_words(found, 3), {"notices density by a factor of 4"});
}

TEST(SensitivityReport, CallsWeakWhatOnlyAFailureOrAFinerMeshOrMoreThanAFactorOfTwoMakesFail) {
  const Sensitivity found = made_sensitivity().result;
  EXPECT_FALSE(found.weak(0));
  EXPECT_TRUE(found.weak(1));
  EXPECT_FALSE(found.weak(2)) << "what is not met may notice all";
  EXPECT_TRUE(found.weak(3));
  EXPECT_EQ(weak_in_words(found), "Weak: known: tip.x and known: <mid.y> notice nothing.");
  Sensitivity strong = found;
  strong.numbers[2].down.noticed[1].change = strong.numbers[2].down.noticed[3].change = 1;
  EXPECT_EQ(weak_in_words(strong), "") << "half of a number is within a factor of two";
}

TEST(SensitivityReport, CallsNothingWeakWhereNoChangedRunEndedInItsTime) {
  SensitivityStudy study = made_sensitivity();
  Sensitivity& found = study.result;
  for (NumberSensitivity& number : found.numbers)
    for (SearchedSide* side : {&number.up, &number.down}) {
      side->searched = 0;
      side->noticed.assign(side->noticed.size(), {});
    }
  for (BlunderSensitivity& of : found.blunders) of.trial = {Outcome::out_of_time, "", {}};
  EXPECT_TRUE(found.weak_names().empty());
  expect_in(noticed_in_words(found, 0), {"notices no number", "not found out within 10 s a run: density"});
  const StudyReport report = evaluate_sensitivity(study, {});
  expect_in(report.headline, {"Nothing was found out: no changed run ended in its time."});
  for (const Verdict& verdict : report.verdicts)
    EXPECT_EQ(verdict.status, VerdictStatus::not_run) << verdict.name;
}

TEST(SensitivityReport, DoesNotAskFiguresOfAnotherModel) {
  const std::string other = R"([model]
differences = ["a point mass"]
)",
                    exact = R"([exact]
obtained = "by hand"
uncertainty = 1e-12
uncertainty_basis = "closed form"
rows = [[0, 0], [0.5, -0.25], [1, -1.0]]
)";
  EXPECT_TRUE(judged_criteria(run_with("made", "", other)).empty());
  const std::vector<JudgedCriterion> judged = judged_criteria(run_with("made", "", other + exact));
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_EQ(judged[0].name, "known: exact: tip.y");
  plumb::Run failed = run_with("made", "", other + exact);
  failed.trajectory.outcome = Outcome::diverged;
  EXPECT_EQ(judged_criteria(failed).size(), 1U) << "in the same order, however a changed run ends";
}

TEST(SensitivityReport, HasAVerdictOnEachCriterion) {
  const SensitivityStudy study = made_sensitivity();
  const StudyReport report = evaluate_sensitivity(study, {});
  std::vector<VerdictStatus> statuses;
  for (const Verdict& verdict : report.verdicts) statuses.push_back(verdict.status);
  EXPECT_EQ(statuses, (std::vector{VerdictStatus::passed, VerdictStatus::failed, VerdictStatus::not_run,
                                   VerdictStatus::failed}));
  EXPECT_EQ(
      report.verdicts[0].message,
      "it notices 2 numbers of the model within a factor of two, and 1 blunder; 1 more would end the run")
      << "neither the run that fails nor the finer mesh";
  EXPECT_EQ(report.headline, "Weak: known: tip.x and known: <mid.y> notice nothing.");
  EXPECT_EQ(
      report.details,
      "The smallest change that is noticed is 6.2 % of density, by known: tip.y. None notices any change of "
      "gravity along y.");
  EXPECT_EQ(report.counts,
            "3 criteria were asked what they notice of 3 numbers of the model and 3 blunders.");
}

TEST(SensitivityReport, OfACaseThatDoesNotCompleteSaysWhyNothingWasTried) {
  SensitivityStudy study = made_sensitivity();
  study.result = {};
  study.result.left_out = "the case itself does not complete: it grew";
  const StudyReport report = evaluate_sensitivity(study, {});
  EXPECT_FALSE(report.complete);
  EXPECT_EQ(report.headline, "Nothing was tried: the case itself does not complete: it grew.");
  expect_in(sensitivity_on_page().html(sensitivity_document(study.result), {}), {"it grew"});
  EXPECT_FALSE(sensitivity_section(study.result).figures);
}

TEST(SensitivityReport, ShowsEveryChangeAndBlunder) {
  const std::string html = sensitivity_on_page().html(sensitivity_document(made_sensitivity().result), {});
  expect_in(html,
            {"+6.2 %", "−20 %", "+50 % (the run fails)", "× 4", ">nothing<", "known: &lt;mid.y&gt;",
             "up to × 10 only: the run would take more than 10 s", "does not apply: the mesh has one element",
             "no mistake", "unstable: it grew", "<span class=\"tag passed\">noticed</span><br>0.1 m",
             "<span class=\"tag not-run\">not noticed</span>", "<span class=\"tag failed\">weak</span>"});
  EXPECT_EQ(html.find("known: tip.z</"), std::string::npos) << "no column of what is not met";
}

TEST(SensitivityFigure, HasABarForEachNumberAndCriterionAsLongAsItsSmallestChange) {
  const Figure figure = sensitivity_figure(made_sensitivity().result);
  const Panel& panel = figure.plot.panels.at(0);
  EXPECT_EQ(panel.y.tick_labels,
            (std::vector<std::string>{"gravity along y", "bending stiffness", "density"}))
      << "from below";
  ASSERT_EQ(panel.bars.size(), 9U) << "of three criteria that were asked";
  EXPECT_DOUBLE_EQ(panel.bars[6].x[1], 6.25) << "% of density, on tip.y";
  EXPECT_DOUBLE_EQ(panel.bars[8].x[1], 300) << "of the last criterion";
  EXPECT_GT(panel.bars[0].x[1], 9900) << "nothing: to the end of the axis";
  expect_in(figure.alt, {"known: tip.y: density 6.2 %, bending stiffness 50 %, gravity along y nothing."});
}

TEST(SensitivitySection, RemarksOnWeakCriteriaInTheirVerdictsAndTheHeadline) {
  Sensitivity found = made_sensitivity().result;
  found.criteria[0].name = "other: tip.y";
  found.criteria[1].name = "known: tip.y";
  const auto run = run_with("made");
  const Results plain = evaluate(run, {}), with = evaluate(run, {}, {sensitivity_section(found)});
  ASSERT_EQ(with.verdicts.size(), plain.verdicts.size()) << "it adds no verdict";
  EXPECT_EQ(with.verdicts[0].status, plain.verdicts[0].status);
  EXPECT_EQ(with.verdicts[0].message,
            plain.verdicts[0].message +
                "; weak: it notices no number of the model within a factor of two, and no blunder");
  EXPECT_EQ(headline(with), headline(plain) + " Weak: known: tip.y and known: <mid.y> notice nothing.");
}

TEST(JudgedCriteria, AreThoseOnTheRunItself) {
  const std::vector<JudgedCriterion> judged = judged_criteria(run_with("made"));
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_EQ(judged[0].name, "known: tip.y");
  EXPECT_NEAR(judged[0].value, 0.1, 1e-12);
  EXPECT_TRUE(judged[0].met);
}

TEST(JudgedCriteria, OfALimitThatIsTooWideToBeJudgedSayWhatIsWithinIt) {
  auto run = run_with("made");
  run.loaded.spec.references[0].tolerance = 50;
  ASSERT_EQ(evaluate(run, {}).verdicts[0].status, VerdictStatus::not_run);
  EXPECT_TRUE(judged_criteria(run).at(0).met);
  EXPECT_NEAR(judged_criteria(run).at(0).value, 0.1, 1e-12);
  run.loaded.references[0].cable.length = 3;
  EXPECT_FALSE(judged_criteria(run).at(0).met) << "it is of another cable";
}

}  // namespace sensitivity_results_test
}  // namespace plumb
