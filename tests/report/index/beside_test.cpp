#include "report/index/beside.h"

#include <gtest/gtest.h>

#include "render/image/png.h"
#include "report/page/page_template.h"
#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace beside_test {

Document made() {
  static const Document document = document_of(evaluate(run_with("made"), {}), {});
  return document;
}

/// Probes of these values at these times.
void set_probe(Document& document, const std::string& name, const std::string& unit,
               const std::vector<double>& times, const std::vector<double>& values) {
  document["probes"] = {{"t", {{"unit", "s"}, {"values", times}}},
                        {name, {{"unit", unit}, {"values", values}}}};
}

const Document* found(const Document& list, const char* key, const std::string& value) {
  for (const Document& one : list)
    if (one.at(key) == value) return &one;
  return nullptr;
}

TEST(Beside, ReportsThatAreTheSameDifferInNothing) {
  const Document beside = beside_of(made(), "a", made(), "b");
  EXPECT_TRUE(beside.at("case").empty()) << beside.at("case");
  EXPECT_TRUE(beside.at("not_compared").empty()) << beside.at("not_compared");
  ASSERT_FALSE(beside.at("verdicts").empty());
  for (const Document& verdict : beside.at("verdicts")) EXPECT_EQ(verdict.at("first"), verdict.at("second"));
  ASSERT_FALSE(beside.at("probes").empty());
  for (const Document& probe : beside.at("probes")) EXPECT_EQ(probe.at("greatest"), 0) << probe;
  EXPECT_NE(text_of(beside, "headline").find("alike; all curves are identical."), std::string::npos)
      << beside.at("headline");
}

TEST(Beside, VerdictsAndNumbersHaveTheirDifferences) {
  Document first = made(), second = made();
  first["solve"]["steps"] = 100;
  Document& verdict = second["verdicts"][0];
  const double before = verdict.at("value").get<double>();
  verdict["value"] = before + 0.25;
  verdict["status"] = verdict.at("status") == "failed" ? "passed" : "failed";
  second["solve"]["steps"] = 107;
  second["case"]["cable"]["elements"] = 99;
  const Document beside = beside_of(first, "a", second, "b");
  EXPECT_NEAR(beside.at("verdicts").at(0).at("difference").get<double>(), 0.25, 1e-12);
  EXPECT_NE(text_of(beside, "headline").find("1 of"), std::string::npos) << beside.at("headline");
  EXPECT_NE(text_of(beside, "headline").find("ends differently"), std::string::npos) << beside.at("headline");
  EXPECT_EQ(text_of(beside, "headline").find("tolerance"), std::string::npos) << beside.at("headline");
  const Document* steps = found(beside.at("numbers"), "name", "steps");
  ASSERT_NE(steps, nullptr) << beside.at("numbers");
  EXPECT_EQ(steps->at("difference"), 7) << *steps;
  const Document* elements = found(beside.at("case"), "what", "cable.elements");
  ASSERT_NE(elements, nullptr) << beside.at("case");
  EXPECT_EQ(elements->at("now"), "99");
}

TEST(Beside, TolerancesThatDifferAreInTheHeadlineAndTheTable) {
  const Document first = made();
  Document second = made();
  second["verdicts"][0]["limit"] = 0.375;
  const Document beside = beside_of(first, "a", second, "b");
  const std::string headline = text_of(beside, "headline"),
                    name = text_of(first.at("verdicts").at(0), "name");
  EXPECT_NE(headline.find("; the tolerance of " + name + " differs, "), std::string::npos) << headline;
  EXPECT_NE(headline.find(" in a and 0.375"), std::string::npos) << headline;
  const std::string html = beside_html(beside, "", {}, 0);
  EXPECT_NE(html.find(" | 0.375"), std::string::npos) << html;
}

TEST(Beside, RunsWithOtherOutputTimesAreComparedWhereTheyOverlap) {
  Document first = made(), second = made();
  // A cubic, which is interpolated without an error, and the same 0.1 higher.
  const auto cubic = [](double t) { return t * t * t - t; };
  std::vector<double> times, values, others, shifted;
  for (int k = 0; k <= 20; ++k) times.push_back(0.1 * k);
  for (int k = 0; k <= 9; ++k) others.push_back(0.5 + 0.13 * k);
  for (const double t : times) values.push_back(cubic(t));
  for (const double t : others) shifted.push_back(cubic(t) + 0.1);
  set_probe(first, "p.x", "m", times, values);
  set_probe(second, "p.x", "m", others, shifted);
  const Document beside = beside_of(first, "a", second, "b");
  ASSERT_EQ(beside.at("probes").size(), 1U);
  const Document& probe = beside["probes"][0];
  EXPECT_NEAR(probe.at("greatest").get<double>(), 0.1, 1e-12) << probe;
  EXPECT_EQ(probe.at("from"), 0.5);
  EXPECT_NEAR(probe.at("to").get<double>(), 0.5 + 9 * 0.13, 1e-12);
  EXPECT_EQ(probe.at("interpolated"), true);
}

TEST(Beside, WhatCannotBeComparedIsSaidWithTheReason) {
  Document first = made(), second = made();
  set_probe(first, "p.x", "m", {0, 1}, {0, 1});
  set_probe(second, "p.x", "N", {0, 1}, {0, 1});
  first["verdicts"] = Document::array();
  second["solve"]["newton_iterations"] = 3;
  first["solve"]["newton_iterations"] = -1;
  const Document beside = beside_of(first, "a", second, "b");
  const Document& left = beside.at("not_compared");
  const Document* column = found(left, "what", "p.x");
  ASSERT_NE(column, nullptr) << left;
  EXPECT_EQ(column->at("why"), "in m and in N");
  const Document* count = found(left, "what", "Newton iterations");
  ASSERT_NE(count, nullptr) << left;
  EXPECT_EQ(count->at("why"), "only b has it");
  EXPECT_EQ(std::ssize(left), 2 + std::ssize(second.at("verdicts"))) << left;

  set_probe(second, "q.x", "m", {0, 1}, {0, 1});
  EXPECT_NE(found(beside_of(first, "a", second, "b").at("not_compared"), "what", "q.x"), nullptr);
  set_probe(second, "p.x", "m", {2, 3}, {0, 1});
  const Document apart = beside_of(first, "a", second, "b");
  ASSERT_NE(found(apart.at("not_compared"), "what", "p.x"), nullptr);
  EXPECT_NE(text_of(*found(apart.at("not_compared"), "what", "p.x"), "why").find("no span of time"),
            std::string::npos);
  EXPECT_TRUE(apart.at("probes").empty());
  set_probe(first, "p.x", "m", {0, 1, 1, 2}, {0, 1, 2, 3});
  set_probe(second, "p.x", "m", {0, 1}, {0, 1});
  const Document back = beside_of(first, "a", second, "b");
  ASSERT_NE(found(back.at("not_compared"), "what", "p.x"), nullptr);
  EXPECT_NE(text_of(*found(back.at("not_compared"), "what", "p.x"), "why").find("do not rise"),
            std::string::npos);
}

TEST(Beside, PicturesThatHaveNoRoomAreCounted) {
  const std::string png = encode_png({2, 1, {255, 255, 255, 0, 0, 0}});
  const Document beside = beside_of(made(), "a<b", made(), "b");
  const std::vector<PicturePair> pairs{{"one", png, png}, {"two", png, png}};
  const std::string all = beside_html(beside, "<p>curves</p>", pairs, 1000000),
                    some = beside_html(beside, "<p>curves</p>", pairs, 2 * data_uri(png).size());
  EXPECT_NE(all.find("<p>curves</p>"), std::string::npos);
  EXPECT_EQ(all.find("there is no room"), std::string::npos);
  EXPECT_NE(all.find("alt=\"two, of a&lt;b\""), std::string::npos) << all;
  EXPECT_NE(some.find("For 1 picture there is no room"), std::string::npos) << some;
}

}  // namespace beside_test
}  // namespace plumb
