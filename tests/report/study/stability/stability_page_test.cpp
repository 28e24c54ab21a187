#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "report/figure/outcome_style.h"
#include "report/study/stability/stability_figures.h"
#include "report/study/stability/stability_results.h"
#include "tests/report/study/stability/made_stability.h"

namespace plumb {
namespace stability_page_test {

// Stand-ins of one byte for the drawn figures.
std::vector<Picture> pictures(const Stability& study) {
  std::vector<Picture> result;
  for (const Figure& figure : stability_figures(study))
    result.push_back({"figures/" + figure.name + ".png", figure.title, figure.alt, false, "P"});
  return result;
}

std::string page_of(const Stability& study) {
  StabilityStudyFile file{tiny_stability_case(), study};
  file.loaded.spec.title = study.title;
  return to_page(evaluate_stability(file, {}), shown_stability(study, pictures(study)));
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + what.size())) ++found;
  return found;
}

nlohmann::json data_in(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"stability-data\">";
  const std::size_t from = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(StabilityPage, MapsOfTheScriptAreThoseOfTheStudy) {
  const Stability study = made_stability();
  const nlohmann::json json = data_in(page_of(study));
  ASSERT_EQ(json["maps"].size(), study.maps.size());
  for (std::size_t m = 0; m < study.maps.size(); ++m) {
    const OutcomeMap& map = study.maps[m];
    const nlohmann::json& shown = json["maps"][m];
    EXPECT_EQ(shown["label"], map.label);
    EXPECT_EQ(shown["settings"], map.settings);
    ASSERT_EQ(shown["points"].size(), map.points.size());
    for (std::size_t k = 0; k < map.points.size(); ++k) {
      const nlohmann::json& point = shown["points"][k];
      EXPECT_EQ(json["outcomes"][point["o"].get<std::size_t>()]["name"], word(map.points[k].outcome));
      EXPECT_EQ(point["e"].is_null(), map.points[k].error < 0) << "what was not judged has no error";
      EXPECT_EQ(point.value("m", ""), map.points[k].message);
    }
  }
}

TEST(StabilityPage, SaysFirstWhichStepAUserWants) {
  const std::string page = page_of(made_stability());
  const std::size_t words = page.find("id=\"stability-words\""), maps = page.find("id=\"stability-maps\"");
  ASSERT_NE(words, page.npos);
  EXPECT_LT(words, maps);
  const std::string part = page.substr(words, maps - words);
  EXPECT_NE(part.find("accurate up to a step of 1.0e-4 s, stable up to 2.0e-4 s; unstable at 4.0e-4 s; the "
                      "predicted limit is 1.90e-4 s"),
            part.npos)
      << part;
  EXPECT_NE(part.find("f = 1"), part.npos);
  EXPECT_NE(part.find("f = 5"), part.npos);
}

TEST(StabilityPage, ShowsEveryPart) {
  const std::string page = page_of(made_stability());
  for (const char* text : {"where methods fail", "it ended so", "it grew", "Critical steps", "until 1.75 s",
                           "energies and statistics are compared", "out-of-time", "test data",
                           "figures/stability_parameter.png", "figures/stability_parameter_tolerance.png",
                           "figures/stability_limits.png", "figures/stability_energy.png",
                           "figures/stability_amplification.png", "figures/stability_separation.png"})
    EXPECT_NE(page.find(text), page.npos) << text;
  EXPECT_NE(page.find("-1.5 %"), page.npos) << "1.005e-3 s found, 1.02e-3 s predicted";
}

TEST(StabilityPage, SaysWhereComparisonsMeanSomethingThroughout) {
  Stability study = made_stability();
  for (TrajectoryDivergence& divergence : study.divergences) divergence.beyond_end = true;
  EXPECT_NE(page_of(study).find("Comparing trajectories means something throughout"), std::string::npos);
}

TEST(StabilityPage, PolicyAllowsJustItsOwnScript) {
  const std::string page = page_of(made_stability());
  const std::size_t at = page.find("Content-Security-Policy");
  ASSERT_NE(at, page.npos);
  const std::string policy = page.substr(at, page.find('>', at) - at);
  EXPECT_NE(policy.find("default-src 'none'"), policy.npos) << policy;
  const std::regex hash("'sha256-[A-Za-z0-9+/]{43}='");
  EXPECT_EQ(std::distance(std::sregex_iterator(policy.begin(), policy.end(), hash), std::sregex_iterator()),
            1);
  EXPECT_EQ(count(page, "<script"), 2U) << "the data and the script";
  for (const char* word : {"https://", "src=\"http", "href=\"http", "@import", "url(", "fetch("})
    EXPECT_EQ(page.find(word), page.npos) << word;
}

TEST(StabilityPage, EscapesWhatLabelsAndMessagesSay) {
  const std::string evil = "</script><script>alert(\"1\")</script><!-- & '";
  Stability study = made_stability();
  study.title = study.maps[0].label = study.maps[0].points[3].message = evil;
  study.energies[0].message = study.critical_steps[0].label = study.references[0].first = evil;
  study.parameter = "<b>";
  const std::string page = page_of(study);
  EXPECT_EQ(count(page, "<script"), 2U);
  EXPECT_EQ(page.find("alert(\"1\")"), page.npos);
  EXPECT_EQ(page.find("<b>"), page.npos);
  EXPECT_EQ(data_in(page)["maps"][0]["points"][3]["m"], evil);
}

TEST(StabilityPage, LeavesNoTemplateTagOrNotANumberBehind) {
  Stability without = made_stability();
  without.parameter.clear();
  std::erase_if(without.maps, [](const OutcomeMap& map) { return map.axis == MapAxis::parameter; });
  Stability strange = made_stability();
  strange.critical_steps[0].stable = -1;
  strange.critical_steps[1].predicted = {INFINITY, INFINITY};
  strange.divergences[0].exponent = NAN;
  strange.maps[0].points[3].energy_change = NAN;
  for (const Stability& study : {made_stability(), without, strange, Stability{}}) {
    const std::string page = page_of(study);
    const std::string body = page.substr(0, page.find("<script"));
    EXPECT_EQ(body.find("{{"), body.npos);
    EXPECT_FALSE(std::regex_search(body, std::regex("\\b(nan|inf)\\b")));
  }
}

TEST(OutcomeStyles, AreTheirOwnForEveryOutcomeThatARunCanHave) {
  for (const Outcome outcome : outcomes())
    EXPECT_EQ(outcome_place(outcome) >= 0, outcome != Outcome::not_run) << word(outcome);
  for (const OutcomeStyle& a : outcome_styles())
    for (const OutcomeStyle& b : outcome_styles()) {
      if (a.outcome == b.outcome) continue;
      EXPECT_NE(a.letter, b.letter) << word(a.outcome) << " and " << word(b.outcome);
      EXPECT_FALSE(a.color == b.color) << word(a.outcome) << " and " << word(b.outcome);
    }
}

}  // namespace stability_page_test
}  // namespace plumb
