#include "report/study/variants/variants_results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/study/variants/variants_figures.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace variants_results_test {

VariantResult made(const std::string& name, Outcome outcome, double end) {
  VariantResult variant;
  variant.spec.name = name;
  variant.spec.overrides = {"method.step=" + name};
  variant.spec.outcome = "unstable";
  variant.run = run_with("made").loaded.spec;
  Trajectory& t = variant.trajectory;
  t.outcome = outcome;
  t.message = outcome == Outcome::completed ? "" : "it grew <and> grew";
  t.end_time = end;
  t.times = {0, end};
  t.energies = {{2, 0, 0, 0}, {3, 0, 0, 0}};
  variant.probes.times = t.times;
  variant.probes.columns = {{"tip.x", "m", {1, 2}}};
  variant.expectations = {{{"end-time", "", 1.2, 0.05, "a closed form"}, "s", end}};
  variant.spec.expectations = {variant.expectations[0].expected};
  return variant;
}

VariantsStudy study_of(std::vector<VariantResult> variants) {
  return {run_with("made").loaded, {"Made", std::move(variants), {{"program", "test"}}}};
}

TEST(VariantsResults, AFailureThatIsExpectedPassesAndOneThatIsNotFails) {
  const VariantsStudy study =
      study_of({made("0.1", Outcome::unstable, 1.21), made("0.2", Outcome::unstable, 1.3),
                made("0.3", Outcome::completed, 1.2)});
  const StudyReport results = evaluate_variants(study, {});
  ASSERT_EQ(results.verdicts.size(), 3U);
  EXPECT_EQ(results.verdicts[0].status, VerdictStatus::passed) << results.verdicts[0].message;
  EXPECT_EQ(results.verdicts[1].status, VerdictStatus::failed) << "its figure is off";
  EXPECT_EQ(results.verdicts[2].status, VerdictStatus::failed) << "its outcome is another";
  EXPECT_EQ(results.verdicts[0].kind, VerdictKind::verification);
  EXPECT_NEAR(results.verdicts[0].value, 0.2, 1e-12);
  EXPECT_EQ(results.verdicts[0].criterion, "unstable; end-time = 1.200 ± 0.05 s");
  EXPECT_EQ(results.headline, "Not as expected: 2 of 3 variants: \"0.2\" and \"0.3\".");
  EXPECT_EQ(results.details, "\"0.2\" was expected to be unstable; end-time = 1.200 ± 0.05 s, and is " +
                                 results.verdicts[1].message + ".");
  EXPECT_EQ(results.counts, "3 variants: 1 completed, 2 unstable.");
}

TEST(VariantsResults, WhereAllIsAsExpectedSayHowCloseItIs) {
  const VariantsStudy study =
      study_of({made("0.1", Outcome::unstable, 1.21), made("0.2", Outcome::unstable, 1.24)});
  const StudyReport results = evaluate_variants(study, {});
  EXPECT_EQ(results.headline, "It fails where it should: all 2 variants end as expected.");
  EXPECT_EQ(results.details,
            "Every figure known of them is met; the closest, of \"0.2\", uses 80 % of its margin.");
}

TEST(VariantsResults, SaysOfFailuresOnlyWhereThereAreSome) {
  VariantResult holds = made("0.2", Outcome::completed, 1.2);
  holds.spec.outcome = "completed";
  const StudyReport both = evaluate_variants(study_of({made("0.1", Outcome::unstable, 1.2), holds}), {});
  EXPECT_EQ(both.headline, "It fails and holds where it should: all 2 variants end as expected.");
  EXPECT_EQ(both.subject, "where it fails");
  const VariantsStudy completed = study_of({holds, holds});
  const StudyReport results = evaluate_variants(completed, {});
  EXPECT_EQ(results.headline, "As expected, all 2 variants run to the end.");
  EXPECT_EQ(results.subject, "variants compared");
  const std::vector<Picture> pictures{{"figures/a.png", "Energy", "Alt", false, "P"}};
  const std::string page = to_page(results, shown_variants(completed.result, pictures));
  for (const char* text : {"fail", "What it said", "nothing expected of it", "A cross is"})
    EXPECT_EQ(page.substr(page.find("<main")).find(text), std::string::npos) << text << "\n" << page;
  VariantResult free = holds;
  free.spec.outcome.clear();
  free.spec.expectations.clear();
  free.expectations.clear();
  const VariantsStudy one = study_of({holds, free});
  EXPECT_EQ(evaluate_variants(one, {}).headline,
            "As expected, the one variant with an expectation runs to the end.");
  EXPECT_NE(shown_variants(one.result, {}).html.find("nothing expected of it"), std::string::npos);
}

TEST(VariantsResults, ANumberThatIsMissingFails) {
  VariantResult variant = made("0.1", Outcome::unstable, 1.2);
  variant.expectations[0].found = std::numeric_limits<double>::quiet_NaN();
  const VariantsStudy study = study_of({variant});
  const StudyReport results = evaluate_variants(study, {});
  EXPECT_EQ(results.verdicts.at(0).status, VerdictStatus::failed);
  EXPECT_NE(results.verdicts[0].message.find("end-time = none"), std::string::npos);
}

TEST(VariantsResults, MessageMustSayWhatIsExpectedOfIt) {
  VariantResult variant = made("0.1", Outcome::unstable, 1.2);
  variant.spec.says = "limit point";
  EXPECT_FALSE(variant.met());
  variant.spec.says = "grew";
  EXPECT_TRUE(variant.met());
}

TEST(VariantsResults, WhatNothingIsExpectedOfHasNoVerdict) {
  VariantResult variant = made("0.1", Outcome::completed, 1);
  variant.spec.outcome.clear();
  variant.spec.expectations.clear();
  variant.expectations.clear();
  const VariantsStudy study = study_of({variant});
  const StudyReport results = evaluate_variants(study, {});
  EXPECT_TRUE(results.verdicts.empty());
  EXPECT_NE(results.headline.find("nothing is claimed"), std::string::npos);
}

TEST(VariantsResults, NumbersHaveTheDigitsOfTheirMargin) {
  EXPECT_EQ(with_margin(1.2, 0.05), "1.200 ± 0.05");
  EXPECT_EQ(with_margin(1.208398131108, 1e-9), "1.2083981311 ± 1e-09");
  EXPECT_EQ(with_margin(0, 1e-14), "0 ± 1e-14");
  EXPECT_EQ(to_margin(9.1e-15, 1e-10), "9.1e-15") << "what is within the margin of 0";
  EXPECT_EQ(to_margin(93.2, 20), "93");
}

TEST(VariantsResults, JunitHasATestCaseForEachWithWhatWasExpectedAndFound) {
  const VariantsStudy study =
      study_of({made("0.1", Outcome::unstable, 1.21), made("0.2", Outcome::unstable, 1.3)});
  const std::string xml = report_formats()[1].text(content_of(evaluate_variants(study, {})));
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("expected: unstable; end-time = 1.200 ± 0.05 s; found: unstable; end-time = 1.300 s"),
            std::string::npos)
      << xml;
}

TEST(VariantsResults, JsonHasEveryFigure) {
  const VariantsStudy study = study_of({made("0.1", Outcome::unstable, 1.21)});
  const auto json = content_of(evaluate_variants(study, {})).document;
  EXPECT_EQ(json["all_criteria_met"], true);
  const auto& variant = json["variants"][0];
  EXPECT_EQ(variant["solve"]["outcome"], "unstable");
  EXPECT_EQ(variant["figures"][0]["found"], 1.21);
  EXPECT_EQ(variant["figures"][0]["expected"], 1.2);
  EXPECT_EQ(variant["figures"][0]["source"], "a closed form");
}

TEST(VariantsPage, ShowsEachVariantWithItsFiguresAndEscapesWhatTheySay) {
  VariantResult variant = made("0.1", Outcome::unstable, 1.21);
  variant.spec.reason = "<script>";
  const VariantsStudy study = study_of({variant});
  const std::string page =
      to_page(evaluate_variants(study, {}),
              shown_variants(study.result, {{"figures/a.png", "Energy", "Alt", false, "P"}}));
  for (const char* text : {"method.step=0.1", "it grew &lt;and&gt; grew", "a closed form", "±0.05",
                           "&lt;script&gt;", "data:image/png;base64,UA==", "1.21"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
}

TEST(VariantsFigures, HaveALineAVariantAndACrossWhereOneEndedEarly) {
  const VariantsStudy study =
      study_of({made("0.1", Outcome::unstable, 1.21), made("0.2", Outcome::completed, 2)});
  const std::vector<Figure> figures = variants_figures(study.result);
  ASSERT_EQ(figures.size(), 2U);
  const std::vector<Series>& series = figures[0].plot.panels.at(0).series;
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[0].y, (std::vector<double>{0, 0.5})) << "over the first kinetic energy";
  EXPECT_EQ(series[1].marker, Marker::cross);
  EXPECT_EQ(series[1].x, std::vector<double>{1.21});
  EXPECT_EQ(figures[1].plot.panels.at(0).y.label, "tip.x [m]");
}

}  // namespace variants_results_test
}  // namespace plumb
