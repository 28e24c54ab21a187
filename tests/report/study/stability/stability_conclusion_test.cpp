#include "report/study/stability/stability_conclusion.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/study/stability/step_in_words.h"
#include "report/base/escape.h"
#include "report/study/stability/stability_bars.h"
#include "tests/report/study/stability/made_stability.h"

namespace plumb {
namespace stability_conclusion_test {

Outcome outcome_of(char letter) {
  switch (letter) {
    case 'a':
      return Outcome::accurate;
    case 'i':
      return Outcome::inaccurate;
    case 'T':
      return Outcome::out_of_time;
    case 'D':
      return Outcome::diverged;
    default:
      return Outcome::unstable;
  }
}

/// Over the parameter, of one row of outcomes a value; settings are 1e-4, 2e-4, 4e-4 …
OutcomeMap map_of(const std::string& label, const std::vector<std::string>& rows, bool by_step = true) {
  OutcomeMap map;
  map.label = label;
  map.by_step = by_step;
  for (std::size_t k = 0; k < rows.front().size(); ++k) map.settings.push_back(1e-4 * std::pow(2.0, k));
  for (std::size_t value = 0; value < rows.size(); ++value) {
    map.values.push_back(value == 0 ? 5 : 5 + 10 * static_cast<double>(value));
    for (const char letter : rows[value]) map.points.emplace_back().outcome = outcome_of(letter);
  }
  return map;
}

Stability study_of(std::vector<OutcomeMap> maps) {
  Stability study;
  study.parameter = "f";
  study.parameter_value = 5;
  study.elements = 4;
  study.end = 2;
  study.tolerance = 0.01;
  study.maps = std::move(maps);
  return study;
}

TEST(StabilityConclusion, NamesTheMethodThatBearsTheGreatestStepAndTheFirstToFail) {
  const StabilityConclusion found = conclude(study_of(
      {map_of("hht, α = -0.3, fixed step", {"aaaiU"}), map_of("rk4", {"aaDDU"}), map_of("verlet", {"aUUUU"}),
       map_of("euler", {"iiiii"}), map_of("bdf, controlled step", {"aaaii"}, false)}));
  EXPECT_EQ(
      found.sentence,
      "At f = 5, 4 elements, 2 s: hht (α = -0.3) bears the greatest step of 4 methods and stays accurate to "
      "0.01 m up to a step of 4.0e-4 s.");
  EXPECT_EQ(
      found.details,
      "3 of 4 methods fail within the steps tried, the first verlet at 2.0e-4 s (unstable), rk4 at 4.0e-4 s "
      "(diverged) and hht (α = -0.3) at 1.6e-3 s (unstable). Of those that choose their steps, bdf, the only "
      "method, stays accurate to 0.01 m up to rtol 4.0e-4.");
}

TEST(StabilityConclusion, OfMethodsThatAreAlikeNamesThemAll) {
  const StabilityConclusion found =
      conclude(study_of({map_of("a", {"aaU"}), map_of("b", {"aaD"}), map_of("c", {"aiU"})}));
  EXPECT_NE(found.sentence.find("2 of 3 methods stay accurate to 0.01 m up to a step of 2.0e-4 s: a and b."),
            found.sentence.npos)
      << found.sentence;
  const StabilityConclusion all = conclude(study_of({map_of("a", {"aaa"}), map_of("b", {"aaa"})}));
  EXPECT_NE(
      all.sentence.find("all 2 methods stay accurate to 0.01 m up to a step of 4.0e-4 s, the greatest that "
                        "was tried."),
      all.sentence.npos)
      << all.sentence;
  EXPECT_EQ(all.details, "They fail at no step that was tried.");
}

TEST(StabilityConclusion, IsTrueWhereNoneIsAccurateOrNothingWasRun) {
  const StabilityConclusion none = conclude(study_of({map_of("a", {"iiU"}), map_of("b", {"UUU"})}));
  EXPECT_NE(none.sentence.find("no method is accurate to 0.01 m with any step that was tried."),
            none.sentence.npos)
      << none.sentence;
  EXPECT_EQ(
      none.details,
      "2 of 2 methods fail within the steps tried, the first b at 1.0e-4 s (unstable) and a at 4.0e-4 s "
      "(unstable).");
  EXPECT_EQ(conclude(study_of({})).sentence, "No run was made, so nothing can be said of any method.");
  const StabilityConclusion tolerances = conclude(study_of({map_of("ida", {"aaU"}, false)}));
  EXPECT_EQ(tolerances.sentence,
            "At f = 5, 4 elements, 2 s: ida, the only method, stays accurate to 0.01 m up to rtol 2.0e-4.");
}

TEST(StabilityConclusion, ARunThatIsOutOfTimeIsNoFailure) {
  const StabilityConclusion slow = conclude(study_of({map_of("a", {"Taa"}), map_of("b", {"aaT"})}));
  EXPECT_EQ(slow.details, "They fail at no step that was tried.");
  Stability unknown = study_of({map_of("a", {"aaa"})});
  unknown.maps[0].points[2].outcome = Outcome::completed;
  EXPECT_EQ(conclude(unknown).details, "It fails at no step that was tried.");
}

TEST(StabilityConclusion, AMethodThatFailsWithShortStepsOnlyFailsAllTheSame) {
  const StabilityConclusion found = conclude(study_of({map_of("bdf", {"Uaai"}), map_of("rk4", {"aaaU"})}));
  EXPECT_EQ(
      found.details,
      "2 of 2 methods fail within the steps tried, the first bdf at 1.0e-4 s (unstable) and rk4 at 8.0e-4 s "
      "(unstable).");
}

TEST(StabilityConclusion, HoldsThePredictedLimitsAgainstThoseFound) {
  Stability study = made_stability();
  study.critical_steps[0].predicted.at_worst = 1.2e-3;
  const StabilityConclusion found = conclude(study);
  EXPECT_NE(found.details.find("The 2 critical steps found are within 16 % of the ones predicted."),
            found.details.npos)
      << found.details;
}

TEST(StabilityConclusion, JsonHasTheReachOfEachMethod) {
  const nlohmann::ordered_json json =
      stability_conclusion_json(study_of({map_of("a", {"aiU"}), map_of("b", {"UUU"})}));
  EXPECT_EQ(json["axis"], "parameter");
  EXPECT_EQ(json["value"], 5);
  ASSERT_EQ(json["methods"].size(), 2U);
  EXPECT_EQ(json["methods"][0]["label"], "a");
  EXPECT_EQ(json["methods"][0]["accurate_up_to"], 1e-4);
  EXPECT_EQ(json["methods"][0]["stable_up_to"], 2e-4);
  EXPECT_EQ(json["methods"][0]["fails_at"], 4e-4);
  EXPECT_EQ(json["methods"][0]["then"], "unstable");
  EXPECT_EQ(json["methods"][1]["accurate_up_to"], -1);
  EXPECT_EQ(json["methods"][1]["fails_at"], 1e-4);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + what.size())) ++found;
  return found;
}

TEST(StabilityBars, HaveABarForEachMethodAndValueAndTheCaseIsChosen) {
  const Stability study =
      study_of({map_of("rk4 <b>", {"aaUU", "aUUU"}), map_of("ida", {"aaaU", "aaUU"}, false)});
  const std::string html = stability_bars(study);
  EXPECT_EQ(count(html, "type=\"radio\""), 2U);
  EXPECT_NE(html.find("id=\"bars-0\" checked><label for=\"bars-0\">f = 5, the case"), html.npos) << html;
  EXPECT_EQ(count(html, "role=\"img\""), 4U);
  EXPECT_EQ(html.find("<b>"), html.npos);
  for (const OutcomeMap& map : study.maps)
    for (std::size_t at = 0; at < 2; ++at)
      EXPECT_NE(html.find("aria-label=\"" + escape_xml(step_in_words(map, at)) + "\""), html.npos)
          << step_in_words(map, at);
  EXPECT_EQ(count(html, "<rect"), 8U) << "neighbours of one outcome are one part";
  EXPECT_EQ(count(stability_bars_css(study), ":checked ~ div:nth-of-type("), 2U);
}

TEST(StabilityBars, OfOneValueNeedNoSwitch) {
  const Stability study = study_of({map_of("rk4", {"aaUU"})});
  EXPECT_EQ(stability_bars(study).find("radio"), std::string::npos);
  EXPECT_EQ(stability_bars_css(study), "") << "nothing is hidden";
}

TEST(StabilityBars, OfManyValuesShowADozenWithTheCase) {
  Stability study = study_of({map_of("rk4", std::vector<std::string>(40, "aaUU"))});
  study.parameter_value = study.maps[0].values[17];
  const std::string html = stability_bars(study);
  EXPECT_LE(count(html, "type=\"radio\""), 12U);
  EXPECT_EQ(count(html, " checked>"), 1U);
}

// The bar goes from half a step below 1e-4 s to half a step above 8e-4 s, by ratio: 2⁴.
TEST(StabilityBars, MarkThePredictedLimitAndTheStepFoundWhereTheyAre) {
  Stability study = study_of({map_of("rk4", {"aaUU"})});
  study.maps[0].limit_kind = LimitKind::vibration;
  study.maps[0].limits = {{1e-3, 2e-4 * std::sqrt(2)}};
  CriticalStep& step = study.critical_steps.emplace_back();
  step.label = "rk4";
  step.parameter = 5;
  step.elements = 4;
  step.stable = step.unstable = 4e-4 * std::sqrt(2);
  const std::string html = stability_bars(study);
  EXPECT_NE(html.find("class=\"limit\" x1=\"50.00%\""), html.npos) << html;
  EXPECT_NE(html.find("class=\"found\" cx=\"75.00%\""), html.npos) << html;
  study.maps[0].limits = {{1, 1}};
  EXPECT_EQ(stability_bars(study).find("class=\"limit\""), std::string::npos) << "beyond the axis";
}

}  // namespace stability_conclusion_test
}  // namespace plumb
