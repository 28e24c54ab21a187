#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "render/gl/utf8.h"
#include "report/base/base64.h"
#include "report/base/escape.h"
#include "report/document/case_json.h"
#include "report/document/junit_suites.h"
#include "report/figure/figures.h"
#include "report/index/run_index.h"
#include "report/page/page.h"
#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace report_writing_test {

TEST(SeriesError, IsTheDistanceAtTheReferenceTimes) {
  const plumb::Run run = run_with("a");
  const std::vector<SeriesError> errors = series_errors(run);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NEAR(errors[0].max, 0.1, 1e-15);
  EXPECT_EQ(errors[0].max_time, 1);
  EXPECT_NEAR(errors[0].rms, 0.1 / std::sqrt(3), 1e-15);
  EXPECT_NEAR(errors[0].difference[2], -0.1, 1e-15) << "the difference is run minus reference";
  EXPECT_EQ(errors[0].coverage.interpolated, 0u);
  EXPECT_EQ(errors[0].coverage.demanded, 3u);
  EXPECT_EQ(errors[0].coverage.compared, 3u);
}

/// The run with nine outputs in place of three.
plumb::Run run_with_more_outputs() {
  plumb::Run run = run_with("a");
  Trajectory& motion = run.trajectory;
  const Eigen::VectorXd q = motion.q[0], v = motion.v[0];
  motion.times.clear();
  motion.q.clear();
  motion.v.clear();
  motion.energies.assign(9, motion.energies[0]);
  for (int k = 0; k <= 8; ++k) {
    const double t = k / 8.0;
    motion.times.push_back(t);
    motion.q.push_back(q);
    motion.v.push_back(v);
    motion.q.back()[7] = -t * t;
    motion.v.back()[7] = -2 * t;
  }
  run.probes = probe(run.loaded.spec, motion);
  return run;
}

TEST(SeriesError, InterpolatesBetweenOutputsAndCountsIt) {
  plumb::Run run = run_with_more_outputs();
  run.loaded.references[0].times[1] = 0.7;
  run.loaded.references[0].series[0].values[1] = -0.7 * 0.7;
  const std::vector<SeriesError> errors = series_errors(run);
  EXPECT_EQ(errors[0].coverage.interpolated, 1u);
  EXPECT_NEAR(errors[0].difference[1], 0, 1e-15);
}

TEST(Verdict, PassesAtItsLimitAndFailsBeyondIt) {
  plumb::Run run = run_with("a");
  const std::vector<SeriesError> errors = series_errors(run);
  run.loaded.spec.references[0].tolerance = errors[0].max;
  EXPECT_EQ(verdicts(run, errors)[0].status, VerdictStatus::passed);
  run.loaded.spec.references[0].tolerance = errors[0].max * (1 - 1e-12);
  EXPECT_EQ(verdicts(run, errors)[0].status, VerdictStatus::failed);
}

TEST(Verdict, ThatCouldNotBeReachedIsNotRunAndDoesNotPass) {
  plumb::Run run = run_with("a");
  run.trajectory.times.pop_back();
  run.trajectory.outcome = Outcome::diverged;
  run.trajectory.end_time = 0.6;
  const std::vector<SeriesError> errors = series_errors(run);
  const std::vector<Verdict> found = verdicts(run, errors);
  EXPECT_EQ(errors[0].coverage.compared, 2u);
  EXPECT_EQ(found[0].status, VerdictStatus::not_run);
  EXPECT_EQ(found[0].value, -1);
  EXPECT_FALSE(all_passed(found));
}

TEST(Verdict, ReferenceBeyondTheRunIsNotRun) {
  plumb::Run run = run_with("a");
  run.loaded.references[0].times = {7, 8, 9};
  const std::vector<Verdict> found = verdicts(run, series_errors(run));
  EXPECT_EQ(found[0].status, VerdictStatus::not_run);
  EXPECT_EQ(found[0].message,
            "only 0 of 3 times of the reference can be compared: Plumb does not have t = 7 s: it is from 0 "
            "to 1 s, and "
            "nothing is extrapolated");
}

TEST(Verdict, DistanceThatIsNotANumberFails) {
  const plumb::Run run = run_with("a");
  std::vector<SeriesError> errors = series_errors(run);
  errors[0].max = std::nan("");
  EXPECT_EQ(verdicts(run, errors)[0].status, VerdictStatus::failed);
}

TEST(SeriesError, OfANumberThatIsNoneIsNone) {
  plumb::Run run = run_with("a");
  run.trajectory.q[1][7] = std::nan("");
  const std::vector<SeriesError> errors = series_errors(run);
  EXPECT_TRUE(std::isnan(errors[0].max));
  EXPECT_TRUE(std::isnan(errors[0].rms));
  EXPECT_EQ(verdicts(run, errors)[0].status, VerdictStatus::failed);
}

TEST(SeriesError, DoesNotOverflow) {
  plumb::Run run = run_with("a");
  run.loaded.references[0].series[0].values[2] = 1e200;
  EXPECT_NEAR(series_errors(run)[0].rms / (1e200 / std::sqrt(3)), 1, 1e-12);
}

TEST(Verdict, SaysHowManyTimesWereInterpolated) {
  plumb::Run run = run_with_more_outputs();
  run.loaded.references[0].times[1] = 0.7;
  EXPECT_EQ(
      verdicts(run, series_errors(run))[0].detail,
      "the greatest at 0.7 s; over 3 of 3 times from 0 to 1 s, outputs at most 0.125 s apart; 1 of them "
      "interpolated, which may be 0 m off (every second output left out)");
}

TEST(Verdict, RunOfAnotherCableIsNotHeldAgainstAReference) {
  plumb::Run run = run_with("a");
  run.loaded.references[0].cable = {
      .length = 2, .axial_stiffness = 1, .bending_stiffness = {}, .mass_per_length = 1e-3};
  EXPECT_EQ(verdicts(run, series_errors(run))[0].status, VerdictStatus::passed);
  run.loaded.references[0].cable.axial_stiffness = 1.00001;
  const std::vector<Verdict> found = verdicts(run, series_errors(run));
  EXPECT_EQ(found[0].status, VerdictStatus::not_run);
  EXPECT_EQ(found[0].detail,
            "the reference is for another cable: EA is 1 N, that of the reference 1.00001 N");
}

TEST(Verdict, OnlyPublishedFiguresValidate) {
  plumb::Run run = run_with("a");
  EXPECT_EQ(verdicts(run, series_errors(run))[0].kind, VerdictKind::validation);
  run.loaded.references[0].kind = ReferenceKind::computed;
  EXPECT_EQ(verdicts(run, series_errors(run))[0].kind, VerdictKind::verification);
}

TEST(Headline, ClaimsOnlyWhatWasEvaluated) {
  plumb::Run run = run_with("a");
  EXPECT_EQ(headline(evaluate(run, {})),
            "Accurate. The one criterion is met: the run with 1 element is at most 0.1 m from the published "
            "figures (at 3 of 3 times).");
  run.loaded.spec.references[0].tolerance = 0.05;
  EXPECT_EQ(
      headline(evaluate(run, {})),
      "Inaccurate: known: tip.y is not met. 1 of 1 criterion not met: the run with 1 element is at most "
      "0.1 m from the published figures (at 3 of 3 times).");
  run.loaded.references[0].cable.length = 3;
  EXPECT_EQ(headline(evaluate(run, {})),
            "Completed, but not held against anything. Of 1 criterion, 0 not met and 1 not run.");
  run.trajectory.outcome = Outcome::diverged;
  run.trajectory.message = "it broke";
  EXPECT_EQ(headline(evaluate(run, {})), "The integration did not finish (diverged): it broke.");
}

TEST(Outcome, OfARunThatCompletedIsWhatItsReferencesSay) {
  plumb::Run run = run_with("a",
                            "[[reference]]\nname = \"again\"\nfile = \"known.toml\"\ncompare = { y = "
                            "\"tip.y\" }\ntolerance = 0.125\n");
  EXPECT_EQ(evaluate(run, {}).outcome, Outcome::accurate);
  EXPECT_EQ(outcome_reason(evaluate(run, {})), "every criterion is met");
  run.loaded.spec.references[1].tolerance = 0.05;
  EXPECT_EQ(evaluate(run, {}).outcome, Outcome::inaccurate);
  EXPECT_EQ(outcome_reason(evaluate(run, {})), "again: tip.y is not met");
  run.loaded.spec.references[0].tolerance = 0.05;
  EXPECT_EQ(outcome_reason(evaluate(run, {})), "known: tip.y and 1 other criterion are not met");
  run.loaded.spec.references[0].tolerance = run.loaded.spec.references[1].tolerance = 0.125;
  run.loaded.references[0].cable.length = 3;
  EXPECT_EQ(evaluate(run, {}).outcome, Outcome::completed) << "not all of its references were compared";
  EXPECT_EQ(outcome_reason(evaluate(run, {})), "not held against every reference");
  run.loaded.references[1].cable.length = 3;
  EXPECT_EQ(evaluate(run, {}).outcome, Outcome::completed);
  EXPECT_EQ(outcome_reason(evaluate(run, {})), "not held against anything");
  run.loaded.references.clear();
  run.loaded.spec.references.clear();
  EXPECT_EQ(evaluate(run, {}).outcome, Outcome::completed);
  EXPECT_EQ(headline(evaluate(run, {})),
            "Completed, but not held against anything. The case names no criterion, so nothing is claimed.");
}

TEST(Outcome, OfARunThatFailedIsItsOwn) {
  plumb::Run run = run_with("a");
  for (const Outcome outcome : {Outcome::unstable, Outcome::diverged, Outcome::no_convergence,
                                Outcome::singular, Outcome::out_of_time}) {
    run.trajectory.outcome = outcome;
    run.trajectory.message = "it broke";
    EXPECT_EQ(evaluate(run, {}).outcome, outcome);
    EXPECT_EQ(outcome_reason(evaluate(run, {})), "it broke");
  }
}

TEST(Outcome, IsInEveryPartOfTheReport) {
  plumb::Run run = run_with("a");
  for (const auto& [tolerance, word] : {std::pair{0.125, "accurate"}, {0.05, "inaccurate"}}) {
    run.loaded.spec.references[0].tolerance = tolerance;
    const Results results = evaluate(run, {});
    const nlohmann::json json = nlohmann::json::parse(to_json(document_of(results, {})));
    EXPECT_EQ(json["outcome"], word);
    EXPECT_EQ(json["outcome_reason"], outcome_reason(results));
    EXPECT_EQ(json["complete"], true);
    EXPECT_EQ(json["solve"]["outcome"], "completed") << "what the integration alone can say";
    EXPECT_NE(to_summary(document_of(results, {})).find("Outcome: **" + std::string(word) + "**"),
              std::string::npos);
    EXPECT_NE(to_junit(document_of(results, {}))
                  .find("<property name=\"outcome\" value=\"" + std::string(word) + "\"/>"),
              std::string::npos);
    EXPECT_NE(to_page(document_of(results, {}), {})
                  .find(word == std::string("accurate")
                            ? "The 1-element run agrees with the published figures to 0.1 m"
                            : "1 of 1 criterion not met: the 1-element run is 0.1 m from"),
              std::string::npos);
  }
}

TEST(Verdict, OfARunThatFailedIsNotRunEvenWhereItReachedEveryReferenceTime) {
  plumb::Run run = run_with("a");
  EXPECT_EQ(verdicts(run, series_errors(run))[0].status, VerdictStatus::passed);
  run.trajectory.outcome = Outcome::unstable;
  const std::vector<Verdict> found = verdicts(run, series_errors(run));
  EXPECT_EQ(found[0].status, VerdictStatus::not_run);
  EXPECT_EQ(found[0].message, "the run ended early, unstable at 1 s");
}

TEST(Verdict, OnlyADistanceThatIsAFiniteNumberIsWithinItsLimit) {
  EXPECT_TRUE(within(0, 1));
  EXPECT_TRUE(within(1, 1));
  EXPECT_FALSE(within(std::nextafter(1, 2), 1));
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(), -1.0})
    EXPECT_FALSE(within(value, 1)) << value;
  EXPECT_FALSE(within(0.5, std::nan("")));
}

/// The numbers of a JSON value, and its nulls.
void count(const nlohmann::json& json, long& nulls) {
  if (json.is_null()) ++nulls;
  EXPECT_TRUE(!json.is_number_float() || std::isfinite(json.get<double>()));
  if (json.is_structured())
    for (const nlohmann::json& item : json) count(item, nulls);
}

TEST(Results, WhatIsNotFiniteIsNoNumberInJsonAndPassesNothing) {
  for (const double bad :
       {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    plumb::Run run = run_with("a");
    run.trajectory.q[1][7] = bad;
    run.trajectory.energies[1].bending = bad;
    run.probes = probe(run.loaded.spec, run.trajectory);
    const Results results = evaluate(run, {});
    EXPECT_EQ(results.outcome, Outcome::inaccurate);
    const std::string text = to_json(document_of(results, {}));
    const nlohmann::json json = nlohmann::json::parse(text);
    EXPECT_TRUE(json["energy"]["bending"][1].is_null()) << json["energy"]["bending"];
    EXPECT_TRUE(json["probes"]["tip.y"]["values"][1].is_null());
    EXPECT_TRUE(json["errors"][0]["max"].is_null());
    EXPECT_TRUE(json["verdicts"][0]["value"].is_null());
    EXPECT_EQ(json["verdicts"][0]["status"], "failed");
    EXPECT_EQ(json["all_criteria_met"], false);
    long nulls = 0;
    count(json, nulls);
    EXPECT_GT(nulls, 4);
  }
}

TEST(Figures, OfARunThatFailedShowWhereItEnded) {
  plumb::Run run = run_with("a", "[[figure]]\nname = \"height\"\ny = \"tip.y\"\nreference = \"known\"\n");
  const auto endings = [](const Panel& panel) {
    return std::count_if(panel.rules.begin(), panel.rules.end(),
                         [](const Rule& rule) { return rule.upright; });
  };
  for (const Figure& figure : figures(run, series_errors(run)))
    for (const Panel& panel : figure.plot.panels) EXPECT_EQ(endings(panel), 0) << figure.name;
  run.trajectory.outcome = Outcome::unstable;
  run.trajectory.end_time = 0.6;
  run.trajectory.times.pop_back();
  run.trajectory.q.pop_back();
  run.trajectory.v.pop_back();
  run.trajectory.energies.pop_back();
  run.probes = probe(run.loaded.spec, run.trajectory);
  const std::vector<Figure> found = figures(run, series_errors(run));
  ASSERT_EQ(found.size(), 5U);
  for (const Figure& figure : found) {
    EXPECT_NE(figure.title.find("only to 0.6 s: unstable"), std::string::npos) << figure.title;
    for (const Panel& panel : figure.plot.panels) {
      if (panel.x.label == "distance along the cable [m]") continue;
      ASSERT_EQ(endings(panel), 1) << figure.name;
      const Rule& ending = panel.rules.back();
      EXPECT_EQ(ending.from, 0.6);
      EXPECT_EQ(ending.to, 1);
      EXPECT_EQ(ending.label, "unstable at 0.6 s of 1 s");
      EXPECT_EQ(panel.x.range, (std::array<double, 2>{0, 1})) << "what is missing must be seen";
    }
  }
  run.trajectory.end_time = 0.01;
  EXPECT_EQ(figures(run, {})[0].plot.panels[0].x.range, (std::array<double, 2>{0, 0.02})) << "or nothing is";
  run.trajectory.end_time = 0.6;
  const std::string page = to_page(document_of(evaluate(run, {}), {}), {});
  const std::string mark = "Only the 0.6 s of 1 s before the run ended (unstable)";
  long marks = 0;
  for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + 1)) ++marks;
  EXPECT_EQ(marks, 3) << "figures with the animation, errors and energies";
  EXPECT_EQ(nlohmann::json::parse(to_json(document_of(evaluate(run, {}), {})))["complete"], false);
}

TEST(Page, EscapesWhatTheCaseSays) {
  const plumb::Run run = run_with(R"(<script>alert('x')</script> & \"quotes\")");
  const std::string page = to_page(document_of(evaluate(run, {}), {}), {});
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;quotes&quot;"),
            std::string::npos);
  EXPECT_NE(page.find("known &lt;b&gt;"), std::string::npos);
  EXPECT_EQ(page.find("known <b>"), std::string::npos);
  EXPECT_EQ(page.find("by<hand>"), std::string::npos);
}

TEST(Page, AsksNothingOfAnywhere) {
  const std::string whole = to_page(document_of(evaluate(run_with("a"), {}), {}), {});
  const std::string page = whole.substr(0, whole.find("<script"));
  for (const char* word : {"http://", "https://", "src=\"/", "@import", "url("})
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  EXPECT_NE(page.find("Content-Security-Policy"), std::string::npos);
}

TEST(Page, LeavesNoTemplateTagBehind) {
  const std::string whole = to_page(document_of(evaluate(run_with("a"), {}), {}), {});
  const std::string page = whole.substr(0, whole.find("<script"));
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_EQ(page.find("}}"), std::string::npos);
}

TEST(Page, SaysWhatTheCableIsModelledAsAndWhetherItMoves) {
  plumb::Run run = run_with("a");
  const auto says = [&](const char* text) {
    return to_page(document_of(evaluate(run, {}), {}), {}).find(text) != std::string::npos;
  };
  EXPECT_TRUE(says("The gradient-deficient element"));
  EXPECT_TRUE(says("The equations of motion are"));
  EXPECT_FALSE(says("A chain of straight links"));
  run.loaded.spec.cable.model = CableModel::chain;
  EXPECT_FALSE(says("The gradient-deficient element"));
  EXPECT_TRUE(says("The equations of motion are"));
  EXPECT_TRUE(says("A chain of straight links"));
  EXPECT_FALSE(says("There is no motion"));
  run.loaded.spec.method.name = "statics";
  EXPECT_FALSE(says("The equations of motion are"));
  EXPECT_FALSE(says("The first kinetic energy"));
  EXPECT_TRUE(says("There is no motion"));
}

TEST(Results, JsonHoldsTheLoadsAndTheModel) {
  const plumb::Run run = run_with("a",
                                  "[loads]\nend_force = [1, 2, 3]\n[start]\naxial_speed = 4\n"
                                  "[supports]\nfirst = \"pinned\"\n");
  const nlohmann::json json = nlohmann::json::parse(to_json(document_of(evaluate(run, {}), {})))["case"];
  EXPECT_EQ(json["loads"]["end_force"], (nlohmann::json{1.0, 2.0, 3.0})) << json["loads"];
  EXPECT_EQ(json["start"]["axial_speed"], 4.0);
  EXPECT_EQ(json["cable"]["model"], "cable");
}

TEST(Results, JsonHoldsEveryNumberOfTheVerdict) {
  const nlohmann::json json = nlohmann::json::parse(to_json(document_of(evaluate(run_with("a"), {}), {})));
  EXPECT_EQ(json["schema_version"], results_version);
  EXPECT_NEAR(json["verdicts"][0]["value"].get<double>(), 0.1, 1e-15);
  EXPECT_EQ(json["verdicts"][0]["limit"], 0.125);
  EXPECT_EQ(json["errors"][0]["reference_uncertainty"], 0.01);
  EXPECT_NEAR(json["errors"][0]["max_relative_to_length"].get<double>(), 0.05, 1e-15);
  EXPECT_NEAR(json["energy"]["drift"].get<double>(), 0.1, 1e-15);
  EXPECT_EQ(json["solve"]["steps"], -1) << "what was not counted is not 0";
}

TEST(Results, JunitEscapesAndCounts) {
  plumb::Run run = run_with("a <&> \\\"b\\\"");
  run.loaded.spec.references[0].tolerance = 0.05;
  const std::string xml = to_junit(document_of(evaluate(run, {}), {}));
  EXPECT_NE(
      xml.find(
          "<testsuites name=\"a &lt;&amp;&gt; &quot;b&quot;\" tests=\"2\" failures=\"1\" skipped=\"0\">"),
      std::string::npos)
      << xml;
  EXPECT_NE(xml.find("<testsuite name=\"validation\" tests=\"1\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("0.1 m of 0.05 m allowed"), std::string::npos) << xml;
}

TEST(Results, SummaryStaysBelowItsSizeWhateverTheCase) {
  const plumb::Run run = run_with("a");
  Results results = evaluate(run, {});
  results.verdicts.resize(5000, results.verdicts.front());
  const std::string text = to_summary(document_of(results, {}));
  EXPECT_LT(text.size(), 64u * 1024);
  EXPECT_NE(text.find("more criteria are in results.json"), std::string::npos);
}

/// Controls, bytes that are no UTF-8, code points that are no characters, and marks of every kind.
const std::string nasty =
    std::string("a\0b", 3) +
    "\x01\x08\x0b\x1b[31m\x7f\xc2\x80\xc2\x9f|\xef\xbf\xbe\xef\xbf\xbf\xef\xb7\x90\xf0\x9f\xbf\xbf"
    "\xed\xa0\x80\xff\xc0\xaf\xe2\x82<script>]]>&\"'`![x](http://y)\n# h | \xc3\xa9\xf0\x9f\x98\x80";

/// The code points of a text that is valid UTF-8, or a failure.
std::u32string points_of(const std::string& text) {
  const std::u32string points = decode_utf8(text);
  std::string again;
  for (const char32_t point : points) append_utf8(again, point);
  EXPECT_EQ(again, text) << "it is no UTF-8";
  return points;
}

TEST(Escape, XmlHasNoForbiddenCharacterLeft) {
  EXPECT_EQ(escape_xml("a<b>&\"c'\n\x01"), "a&lt;b&gt;&amp;&quot;c&#39;\n\uFFFD");
  EXPECT_EQ(escape_xml("\xef\xbf\xbe\xef\xbf\xbf"), "\uFFFD\uFFFD") << "U+FFFE and U+FFFF";
  EXPECT_EQ(escape_xml("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
  EXPECT_EQ(escape_xml("\u00e9\U0001F600\u20ac"), "\u00e9\U0001F600\u20ac");
  for (const char32_t point : points_of(escape_xml(nasty))) {
    EXPECT_FALSE(point < 0x20 && point != '\n') << static_cast<unsigned>(point);
    EXPECT_NE(point & 0xFFFEU, 0xFFFEU) << static_cast<unsigned>(point);
  }
}

TEST(Escape, MarkdownCellStaysOneCell) {
  EXPECT_EQ(escape_markdown("a|b\nc<d>"), "a\\|b c&lt;d\\>");
  EXPECT_EQ(escape_markdown("see https://x.y, www.z"), "see https\\://x.y, www\\.z");
  EXPECT_EQ(escape_markdown("1.5: a"), "1.5: a");
  const std::string cell = escape_markdown(nasty);
  points_of(cell);
  for (std::size_t i = 0; i < cell.size(); ++i)
    if (std::string_view("|`<\n\x1b[]").find(cell[i]) != std::string_view::npos) {
      EXPECT_TRUE(cell[i] != '\n' && cell[i] != '<' && i > 0 && cell[i - 1] == '\\') << cell.substr(i);
    }
}

TEST(Escape, MarkdownThatIsTooLongIsCutBetweenCharacters) {
  const std::string text = "a<ρ|é&*…_中~" + std::string("😀") + "end";
  const std::string whole = escape_markdown(text);
  EXPECT_EQ(escape_markdown(text, whole.size()), whole);
  for (std::size_t most = 8; most < whole.size(); ++most) {
    const std::string cut = escape_markdown(text, most);
    EXPECT_LE(cut.size(), most);
    ASSERT_TRUE(cut.ends_with("…")) << most << ": " << cut;
    const std::string kept = cut.substr(0, cut.size() - std::string_view("…").size());
    EXPECT_EQ(whole.substr(0, kept.size()), kept) << most;
    EXPECT_EQ(escape_markdown(kept).find("\uFFFD"), std::string::npos) << "half a character: " << cut;
    EXPECT_FALSE(kept.ends_with("\\") || kept.ends_with("&lt")) << "half an escape: " << cut;
  }
}

TEST(Escape, MarkdownCodeStaysCode) {
  EXPECT_EQ(markdown_code("plumb run a"), "`plumb run a`");
  EXPECT_EQ(markdown_code("a`b``c\nd"), "``` a`b``c d ```");
}

TEST(Results, WhatTheCaseIsCalledBreaksNoFileOfTheReport) {
  const plumb::Run run = run_with("a");
  Document document = document_of(evaluate(run, {}), {});
  for (const char* key : {"title", "headline", "outcome", "outcome_reason"}) document[key] = nasty;
  for (const char* key : {"name", "criterion", "message", "detail", "reason", "unit"})
    document["verdicts"][0][key] = nasty;
  document["solve"]["method"] = nasty;
  document["solve"]["message"] = nasty;
  document["energy"]["drift_in_words"] = nasty;
  const std::string index = junit_xml("Plumb", index_suites({{nasty, document}}));
  for (const std::string& xml : {to_junit(document), index}) {
    for (const char32_t point : points_of(xml)) {
      EXPECT_FALSE(point < 0x20 && point != '\n') << static_cast<unsigned>(point);
      EXPECT_NE(point & 0xFFFEU, 0xFFFEU) << static_cast<unsigned>(point);
    }
    EXPECT_EQ(xml.find("<script"), std::string::npos);
    EXPECT_EQ(std::count(xml.begin(), xml.end(), '<'), std::count(xml.begin(), xml.end(), '>'));
  }
  for (const std::string& text :
       {to_summary(document), index_summary(index_of({indexed(nasty, document)}, {}))}) {
    points_of(text);
    EXPECT_EQ(text.find("<script"), std::string::npos) << text;
    EXPECT_EQ(text.find("http://"), std::string::npos) << text;
    EXPECT_EQ(text.find("\n# h"), std::string::npos) << text;
  }
}

TEST(Base64, FollowsTheStandardsExamples) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xFF\xFE\x00", 3)), "//4A");
}

TEST(Page, ShowsReactionAndDriftOfTheJointWhereTheyWereComputedOnly) {
  plumb::Run run = run_with("a", "[supports]\nfirst = \"pinned\"\n");
  const std::string without = to_page(document_of(evaluate(run, {}), {}), {});
  EXPECT_EQ(without.find("greatest reaction at the joint"), std::string::npos);
  EXPECT_EQ(solve_json(run)["greatest_reaction"], -1);
  EXPECT_EQ(solve_json(run)["constraint_drift"], -1);
  run.trajectory.multipliers.assign(3, Eigen::Vector3d(3, 0, 4));
  run.trajectory.constraint_drift = 2e-15;
  const std::string with = to_page(document_of(evaluate(run, {}), {}), {});
  EXPECT_NE(with.find("greatest reaction at the joint"), std::string::npos);
  EXPECT_NE(with.find("5 N"), std::string::npos);
  EXPECT_NE(with.find("greatest drift of the joint"), std::string::npos);
  EXPECT_NE(with.find("2e-15 m"), std::string::npos);
  EXPECT_EQ(solve_json(run)["greatest_reaction"], 5);
  EXPECT_EQ(solve_json(run)["constraint_drift"], 2e-15);
}

}  // namespace report_writing_test
}  // namespace plumb
