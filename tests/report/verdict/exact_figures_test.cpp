#include <gtest/gtest.h>

#include <cmath>

#include "report/document/document.h"
#include "report/page/conclusion.h"
#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace exact_figures_test {

// The tip falls as −t²; printed is −0.9 where it is −1 at 1 s.
constexpr const char* exact = R"([exact]
obtained = "by hand: y = -t^2"
uncertainty = 1e-12
uncertainty_basis = "closed form"
rows = [[0, 0], [0.5, -0.25], [1, -1.0]]
)";
constexpr const char* other_model = R"([model]
differences = ["the source has a point mass"]
error = { y = 0.1 }
error_basis = "of the source"
)";

TEST(ExactFigures, AreJudgedApartFromThePrintWhoseErrorIsAFinding) {
  const plumb::Run run = run_with("a", "", exact);
  const Results results = evaluate(run, {});
  ASSERT_EQ(results.verdicts.size(), 2u);
  const Verdict &print = results.verdicts[0], &against_exact = results.verdicts[1];
  EXPECT_EQ(print.kind, VerdictKind::validation);
  EXPECT_EQ(print.name, "known: tip.y");
  EXPECT_NEAR(print.value, 0.1, 1e-15);
  EXPECT_NEAR(print.limit, 0.125 + 0.1, 1e-15) << "the tolerance of the case and what the print is off by";
  EXPECT_NE(
      print.detail.find("the print is up to 0.1 m (10 % of the greatest) off the exact figures, at 1 s"),
      std::string::npos)
      << print.detail;
  EXPECT_EQ(against_exact.kind, VerdictKind::verification);
  EXPECT_EQ(against_exact.name, "known: exact: tip.y");
  EXPECT_EQ(against_exact.value, 0);
  EXPECT_EQ(against_exact.limit, 0.125);
  EXPECT_EQ(results.outcome, Outcome::accurate);
}

TEST(ExactFigures, FailARunThatIsRightInPrintAlone) {
  plumb::Run run = run_with("a", "", exact);
  run.loaded.spec.references[0].tolerance = 0.05;
  for (Eigen::VectorXd& q : run.trajectory.q) q[7] *= 0.9;
  run.probes = probe(run.loaded.spec, run.trajectory);
  const Results results = evaluate(run, {});
  EXPECT_EQ(results.verdicts[0].status, VerdictStatus::passed) << results.verdicts[0].message;
  EXPECT_EQ(results.verdicts[1].status, VerdictStatus::failed) << results.verdicts[1].message;
  EXPECT_EQ(results.outcome, Outcome::inaccurate);
}

TEST(ExactFigures, AreInTheDocumentWithWhatThePrintIsOffBy) {
  const plumb::Run run = run_with("a", "", exact);
  const Document document = document_of(evaluate(run, {}), {});
  EXPECT_EQ(document["errors"][0]["against"], "printed");
  EXPECT_NEAR(document["errors"][0]["print"]["max"].get<double>(), 0.1, 1e-15);
  EXPECT_EQ(document["errors"][1]["against"], "exact");
  EXPECT_EQ(document["errors"][1]["reference_uncertainty"], 1e-12);
  EXPECT_EQ(document["references"][0]["exact"], "by hand: y = -t^2");
}

TEST(Uncertainty, ThatIsNoLessThanTheFiguresThemselvesPassesNothing) {
  plumb::Run run = run_with("a", "", exact);
  ReferenceSeries& series = run.loaded.references[0].series[0];
  for (const double half_width : {0.5, 0.9, 1e308}) {
    series.uncertainty = series.exact_uncertainty = half_width;
    for (const Verdict& verdict : evaluate(run, {}).verdicts) {
      constexpr double greatest = 0.9;  // printed
      EXPECT_EQ(verdict.status, half_width < greatest ? VerdictStatus::passed : VerdictStatus::not_run)
          << verdict.name << ", " << half_width << ": " << verdict.message;
    }
  }
}

TEST(OtherModel, IsShownAndNeitherPassesNorFails) {
  plumb::Run run = run_with("a", "", other_model);
  run.loaded.spec.references[0].tolerance = 1e-6;
  const Results results = evaluate(run, {});
  const Verdict& verdict = results.verdicts.at(0);
  EXPECT_EQ(verdict.status, VerdictStatus::another_model);
  EXPECT_NEAR(verdict.value, 0.1, 1e-15);
  EXPECT_NE(verdict.message.find(
                "of another model: the source has a point mass; this moves it by 0.1 m (of the source)"),
            std::string::npos)
      << verdict.message;
  EXPECT_TRUE(all_passed(results.verdicts));
  EXPECT_FALSE(all_met(results.verdicts)) << "nothing was judged";
  EXPECT_EQ(results.outcome, Outcome::completed);
  EXPECT_EQ(outcome_reason(results), "held against figures of another model only");
  const Document document = document_of(results, {});
  EXPECT_FALSE(document["all_criteria_met"].get<bool>());
  EXPECT_EQ(verdicts_of(document).at(0).status, VerdictStatus::another_model);
  EXPECT_NE(conclusion_of(document).sentence.find("which are of another model"), std::string::npos)
      << conclusion_of(document).sentence;
}

TEST(OtherModel, LeavesExactFiguresOfTheRunsOwnToBeJudged) {
  plumb::Run run = run_with("a", "", std::string(exact) + other_model);
  run.loaded.spec.references[0].tolerance = 1e-6;
  const Results results = evaluate(run, {});
  EXPECT_EQ(results.verdicts.at(0).status, VerdictStatus::another_model);
  EXPECT_EQ(results.verdicts.at(1).status, VerdictStatus::passed) << results.verdicts[1].message;
  EXPECT_EQ(results.outcome, Outcome::accurate);
  EXPECT_TRUE(all_met(results.verdicts));
}

}  // namespace exact_figures_test
}  // namespace plumb
