#include "report/index/run_index.h"

#include <gtest/gtest.h>

#include "render/image/png.h"
#include "report/base/escape.h"
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

TEST(RunIndex, NamesAreFoldersWithoutWhatLeadsToThemAll) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of(Names{"../../a/run", "../../b"}), (Names{"a/run", "b"}));
  EXPECT_EQ(names_of(Names{"../run", "run"}), (Names{"../run", "run"})) << "they would be called alike";
  EXPECT_EQ(names_of(Names{"..", "../run"}), (Names{"..", "../run"}));
  EXPECT_EQ(names_of(Names{}), Names{});
  const std::vector<IndexedReport> reports{report_with("../good", "passed"), report_with("../bad", "failed")};
  const Document index = index_of(reports, {});
  EXPECT_TRUE(says(index.at("headline"), ": bad.")) << index.at("headline");
  EXPECT_EQ(state(index, "../bad"), "failed");
  const std::string page = index_page(index, {}, reports);
  EXPECT_TRUE(says(page, ">good</a>")) << page;
  EXPECT_TRUE(says(page, "href=\"../good/index.html\"")) << page;
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

TEST(RunIndex, GroupsReportsByTheirEvidenceAfterThoseThatFailed) {
  IndexedReport solution = report_with("solution", "passed");
  solution.document["verdicts"][0]["kind"] = "verification";
  const std::vector<IndexedReport> reports{report_with("free", ""),
                                           solution,
                                           report_with("good", "passed"),
                                           report_with("bad", "failed"),
                                           {"gone"}};
  const Document index = index_of(reports, {});
  for (const Document& report : index.at("reports")) {
    const std::string folder = report.at("folder");
    EXPECT_EQ(report.at("kind"), folder == "solution"                   ? "verification"
                                 : folder == "free" || folder == "gone" ? ""
                                                                        : "validation")
        << folder;
  }
  const std::string page = index_page(index, {}, reports);
  const std::string strip =
      page.substr(page.find("id=\"strip\""), page.find("id=\"reports\"") - page.find("id=\"strip\""));
  std::size_t last = 0;
  for (const char* part :
       {"Failed first", "data-case=\"gone\"", "data-case=\"bad\"", ">Validation ", "data-case=\"good\"",
        ">Verification ", "data-case=\"solution\"", ">Not held against anything ", "data-case=\"free\""}) {
    const std::size_t at = strip.find(part);
    ASSERT_NE(at, strip.npos) << part;
    EXPECT_GT(at, last) << part;
    last = at;
  }
  EXPECT_TRUE(says(strip, "known: tip.y: 0.1 m found, 0.125 m allowed, at 1 s")) << strip;
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

TEST(RunIndex, ASummaryOfHundredsIsBelow64KiBAndLeavesNoneOut) {
  std::vector<IndexedReport> reports;
  for (int k = 0; k < 300; ++k) {
    reports.push_back(report_with("a_case_with_a_name_of_some_length_" + std::to_string(k), "failed"));
    Document& document = reports.back().document;
    document["headline"] = "<b>1</b> of 9 criteria not met: " + std::string(k == 7 ? 100'000 : 300, '|');
  }
  const std::string summary = index_summary(index_of(reports, {}));
  EXPECT_LT(summary.size(), 64U * 1024);
  EXPECT_FALSE(says(summary, " more reports are in results.json"));
  std::size_t short_rows = 0;
  for (const IndexedReport& report : reports) {
    const std::string cell = "\n| " + escape_markdown(report.folder) + " | ";
    const std::size_t row = summary.find(cell);
    ASSERT_NE(row, summary.npos) << report.folder;
    const std::string line = summary.substr(row + 1, summary.find('\n', row + 1) - row - 1);
    EXPECT_TRUE(line.ends_with("… |")) << line;
    EXPECT_TRUE(says(line, "&lt;b\\>1")) << "what a headline begins with is there: " << line;
    ++short_rows;
  }
  EXPECT_EQ(short_rows, 300U);
}

TEST(RunIndex, ASummaryOfTooManyHasTheWorstAndCountsTheRest) {
  std::vector<IndexedReport> reports;
  for (int k = 0; k < 2000; ++k)
    reports.push_back(report_with("case_" + std::to_string(k), k < 100 ? "failed" : "passed"));
  const std::string summary = index_summary(index_of(reports, {}));
  EXPECT_LT(summary.size(), 64U * 1024);
  for (int k = 0; k < 100; ++k)
    EXPECT_TRUE(says(summary, "\n| case\\_" + std::to_string(k) + " | ")) << "failed, and is left out: " << k;
  const auto rows = static_cast<std::size_t>(std::count(summary.begin(), summary.end(), '\n'));
  EXPECT_GT(rows, 400U);
  EXPECT_TRUE(says(summary, " more reports are in results.json.\n")) << summary.substr(summary.size() - 300);
}

TEST(RunIndex, ASummaryOfAFewSaysAllOfEach) {
  const std::vector<IndexedReport> reports{report_with("a", "failed"), report_with("b", "passed")};
  const std::string summary = index_summary(index_of(reports, {}));
  for (const IndexedReport& report : reports)
    EXPECT_TRUE(says(summary, escape_markdown(report.document.at("headline").get<std::string>()) + " |\n"))
        << summary;
}

TEST(Summary, OfARunWithManyLongVerdictsIsBelow64KiBWithTheFailedOnesFirst) {
  Document document = document_of(evaluate(run_with("made"), {}), {});
  const Document passed = document["verdicts"][0];
  Document failed = passed;
  failed["status"] = "failed";
  document["verdicts"] = Document::array();
  for (int k = 0; k < 600; ++k) {
    Document& verdict = document["verdicts"].emplace_back(k >= 400 ? failed : passed);
    verdict["criterion"] = "criterion " + std::to_string(k) + ".";
    verdict["message"] = std::string(k == 420 ? 200'000 : 40, '*');
  }
  document["headline"] = document["title"] = document["outcome_reason"] = std::string(50'000, '<');
  const std::string summary = to_summary(document);
  EXPECT_LT(summary.size(), 64U * 1024);
  for (int k = 400; k < 600; ++k)
    EXPECT_TRUE(says(summary, "| criterion " + std::to_string(k) + ". |"))
        << "failed, and is left out: " << k;
  EXPECT_TRUE(says(summary, "more criteria are in results.json"));
  EXPECT_TRUE(says(summary, "energy drift")) << "what the run cost is at its end";
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
