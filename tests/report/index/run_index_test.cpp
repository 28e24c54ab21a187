#include "report/index/run_index.h"

#include <gtest/gtest.h>

#include "render/image/png.h"
#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace run_index_test {

/// A report whose one verdict has this status; empty: none at all.
IndexedReport report_with(const std::string& folder, const std::string& status) {
  static const Document made = document_of(evaluate(run_with("made"), {}), {});
  Document document = made;
  if (status.empty())
    document["verdicts"] = Document::array();
  else
    document["verdicts"][0]["status"] = status;
  document["all_criteria_met"] = status == "passed";
  return indexed(folder, document);
}

std::string state(const Document& index, const std::string& folder) {
  for (const Document& report : index.at("reports"))
    if (report.at("folder") == folder) return report.at("state");
  return "not there";
}

bool says(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

TEST(RunIndex, WhatFailedIsFirstAndWhatNothingWasSaidOfIsLast) {
  const Document index = index_of({report_with("free", ""),
                                   report_with("other", "another model"),
                                   report_with("good", "passed"),
                                   report_with("open", "not run"),
                                   report_with("bad", "failed"),
                                   {"gone"}},
                                  {});
  std::string order;
  for (const Document& report : index.at("reports")) order += report.at("folder").get<std::string>() + " ";
  EXPECT_EQ(order, "gone bad open good other free ");
  EXPECT_EQ(state(index, "gone"), "failed to run");
  EXPECT_EQ(state(index, "bad"), "failed");
  EXPECT_EQ(state(index, "open"), "not run");
  EXPECT_EQ(state(index, "good"), "passed");
  EXPECT_EQ(state(index, "other"), "another model");
  EXPECT_EQ(state(index, "free"), "not held against anything");
  EXPECT_FALSE(index.at("all_criteria_met"));
  EXPECT_TRUE(
      says(index.at("headline"), "3 of 6 reports do not meet all of their criteria: gone, bad, open."))
      << index.at("headline");
}

TEST(RunIndex, IsGreenOnlyWhereSomethingPassedAndGreyWhereNothingWasJudged) {
  const auto page_of = [](const std::vector<IndexedReport>& reports) {
    return index_page(index_of(reports, {}), {}, reports);
  };
  EXPECT_TRUE(says(page_of({report_with("a", "passed"), report_with("b", "")}), "class=\"headline good\""));
  const std::string nothing = page_of({report_with("a", "another model"), report_with("b", "")});
  EXPECT_TRUE(says(nothing, "class=\"headline plain\""));
  EXPECT_TRUE(says(nothing, "tag not-held-against-anything"));
  EXPECT_TRUE(says(nothing, "tag another-model"));
  EXPECT_FALSE(says(nothing, "class=\"tag passed\""));
  EXPECT_TRUE(
      says(page_of({report_with("a", "passed"), report_with("b", "not run")}), "class=\"headline bad\""));
}

TEST(RunIndex, SaysWhyThereIsNoReport) {
  IndexedReport gone{"gone"};
  gone.fault = "crashed (signal 11)";
  const std::vector<IndexedReport> reports{gone, report_with("good", "passed")};
  const Document index = index_of(reports, {});
  EXPECT_EQ(index.at("reports")[0].at("headline"), "The run left no report: crashed (signal 11).");
  EXPECT_TRUE(says(index_page(index, {}, reports), "crashed (signal 11)"));
  EXPECT_TRUE(says(index_suites(reports)[0].cases[0].message, "crashed (signal 11)"));
}

TEST(RunIndex, MarksOfTheScatterLeadToTheirReports) {
  const std::vector<IndexedReport> reports{report_with("a b", "failed")};
  const std::string page = index_page(index_of(reports, {}), {}, reports);
  EXPECT_TRUE(says(page, R"(<a href="a%20b/index.html"><circle class="validation" data-case="a b")"));
}

TEST(RunIndex, NamesNoMoreThanAFewInItsHeadline) {
  std::vector<IndexedReport> reports;
  for (int k = 0; k < 30; ++k) reports.push_back(report_with("case_" + std::to_string(k), "failed"));
  const std::string headline = index_of(reports, {}).at("headline");
  EXPECT_TRUE(says(headline, "case_7 and 22 more.")) << headline;
}

TEST(RunIndex, OfFiveHundredReportsKeepsItsPageBelowFiveMegabytes) {
  Image noise{.width = 70, .height = 50, .rgb = {}};
  for (int k = 0; k < 3 * 70 * 50; ++k)
    noise.rgb.push_back(static_cast<std::uint8_t>(k * k % 65521 * 7919 >> 5));
  std::vector<IndexedReport> reports;
  for (int k = 0; k < 500; ++k) {
    reports.push_back(report_with("case_" + std::to_string(k), k % 2 ? "passed" : "failed"));
    reports.back().thumbnail = encode_png(noise);
  }
  ASSERT_GT(500 * reports[0].thumbnail.size(), 3'000'000U);
  const std::string page = index_page(index_of(reports, {}), {}, reports);
  EXPECT_LT(page.size(), 5'000'000U);
  EXPECT_TRUE(says(page, "data:image/png"));
  EXPECT_TRUE(says(page, "case_499/index.html"));
}

TEST(RunIndex, ShowsTheHistoryOfEachCaseAlone) {
  std::vector<IndexedReport> reports{report_with("a", "failed")};
  Document entry = history_entry(reports[0].document), other = entry;
  entry["revision"] = "older1234";
  other["case"] = "another";
  const Document index = index_of(reports, {}, 2, History{{entry, other, entry}, {}});
  ASSERT_EQ(index.at("reports")[0].at(history_key).size(), 2U);
  const std::string page = index_page(index, {}, reports);
  EXPECT_TRUE(says(page, "older1234"));
  EXPECT_TRUE(says(page, "Up to 2 ran side by side"));
}

TEST(RunIndex, OfTwoRunsTheDifferenceIsBelowTheirCurves) {
  const auto with_probe = [](const std::string& folder, const std::vector<double>& times, double higher) {
    IndexedReport report = report_with(folder, "passed");
    std::vector<double> values;
    for (const double t : times) values.push_back(t * t + higher);
    report.document["probes"] = {{"t", {{"unit", "s"}, {"values", times}}},
                                 {"p.x", {{"unit", "m/s"}, {"values", values}}}};
    return report;
  };
  const std::vector<Figure> two =
      shared_figures({with_probe("a", {0, 1, 2, 3}, 0), with_probe("b", {1, 1.5, 2, 2.5, 4}, 0.5)});
  ASSERT_EQ(two.size(), 1U);
  ASSERT_EQ(two[0].plot.panels.size(), 2U);
  EXPECT_EQ(two[0].times.size(), 2U);
  const Series& difference = two[0].plot.panels[1].series.at(0);
  EXPECT_EQ(difference.x, (std::vector<double>{1, 1.5, 2, 2.5, 3}));
  for (const double value : difference.y) EXPECT_NEAR(value, 0.5, 1e-12);
  EXPECT_EQ(two[0].plot.panels[1].y.label, "difference [m s^{-1}]");
  const std::vector<Figure> three =
      shared_figures({with_probe("a", {0, 1}, 0), with_probe("b", {0, 1}, 0), with_probe("c", {0, 1}, 0)});
  EXPECT_EQ(three.at(0).plot.panels.size(), 1U);
  EXPECT_EQ(shared_figures({with_probe("a", {0, 1}, 0), with_probe("b", {2, 3}, 0)}).at(0).plot.panels.size(),
            1U)
      << "nothing is known of both at one time";
}

}  // namespace run_index_test
}  // namespace plumb
