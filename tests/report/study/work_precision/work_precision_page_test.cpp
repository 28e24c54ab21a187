#include "report/study/work_precision/work_precision_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "report/base/base64.h"
#include "report/base/escape.h"
#include "report/page/page.h"
#include "report/study/work_precision/study_chart_data.h"
#include "report/study/work_precision/work_precision_figures.h"
#include "report/study/work_precision/work_precision_results.h"
#include "report/verdict/results.h"
#include "tests/report/study/work_precision/made_study.h"

namespace plumb {
namespace study_page_test {

// Stand-ins of one byte for the drawn figures.
std::vector<Picture> pictures(const WorkPrecision& study) {
  std::vector<Picture> result;
  for (const Figure& figure : study_figures(study))
    result.push_back({"figures/" + figure.name + ".png", figure.title, figure.alt, false, "P"});
  return result;
}

std::string page_of(const WorkPrecision& result) {
  Study study{run_with("made").loaded, result};
  study.loaded.spec.title = result.title;
  return to_page(evaluate_study(study, {}), shown_work_precision(result, pictures(result)));
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + what.size())) ++found;
  return found;
}

nlohmann::json data_in(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"study-data\">";
  const std::size_t from = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

// A page without what Chart.js says for itself.
std::string without_chart_js(std::string page) {
  const std::size_t from = page.find("<script>", page.find("study-data"));
  return page.erase(from, page.find("</script>", from) - from);
}

TEST(StudyPage, DataOfTheChartsAreTheResults) {
  const WorkPrecision study = made_study();
  const nlohmann::json json = data_in(page_of(study));
  ASSERT_EQ(json["runs"].size(), study.runs.size());
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const WorkPrecisionRun& run = study.runs[k];
    const nlohmann::json& shown = json["runs"][k];
    EXPECT_EQ(shown["elements"], run.elements);
    EXPECT_EQ(shown["outcome"], word(run.outcome));
    EXPECT_EQ(shown["message"], run.message);
    EXPECT_EQ(shown["seconds"], run.seconds);
    for (const ErrorNorm norm : error_norm_list) {
      const std::string name(word(norm));
      if (run.completed()) {
        EXPECT_EQ(shown["time"][name], value(run.time_error, norm)) << k << " " << name;
        EXPECT_EQ(shown["total"][name], value(run.total_error, norm)) << k << " " << name;
      } else {
        EXPECT_TRUE(shown["time"][name].is_null()) << "what was not taken is not a number";
      }
    }
    EXPECT_TRUE(shown["counters"]["tangent_evaluations"].is_null()) << "what was not counted is not 0";
  }
  ASSERT_EQ(json["curves"].size(), study.curves.size());
  for (std::size_t c = 0; c < study.curves.size(); ++c)
    EXPECT_EQ(json["curves"][c]["runs"], study.curves[c].runs);
  EXPECT_EQ(json["front"]["time"], study.time_front);
  EXPECT_EQ(json["front"]["total"], study.total_front);
  EXPECT_EQ(json["floor"]["time"]["value"], study.mesh_references[0].floor);
}

TEST(StudyPage, HasBothChartsWithTheDrawnPictureForPagesWithoutScripts) {
  const std::string page = page_of(made_study());
  for (const char* question : {"time", "total"}) {
    const std::size_t figure = page.find(std::string("data-question=\"") + question + "\"");
    ASSERT_NE(figure, page.npos) << question;
    const std::string inner = page.substr(figure, page.find("</figure>", figure) - figure);
    EXPECT_NE(inner.find("<img src=\"data:image/png;base64,UA==\" alt=\"Plot on logarithmic axes"),
              inner.npos);
    EXPECT_NE(inner.find("<div class=\"chart-box screen\" hidden><canvas"), inner.npos)
        << "hidden until a script shows it";
    EXPECT_NE(inner.find("<div class=\"chart-controls screen\" hidden>"), inner.npos);
  }
}

TEST(StudyPage, PolicyAllowsJustItsOwnScripts) {
  const std::string page = page_of(made_study());
  const std::size_t at = page.find("Content-Security-Policy");
  ASSERT_NE(at, page.npos);
  const std::string policy = page.substr(at, page.find('>', at) - at);
  EXPECT_NE(policy.find("default-src 'none'"), policy.npos) << policy;
  const std::size_t scripts = policy.find("script-src");
  ASSERT_NE(scripts, policy.npos) << policy;
  EXPECT_EQ(policy.find("unsafe", scripts), policy.npos) << policy;
  const std::regex hash("'sha256-[A-Za-z0-9+/]{43}='");
  EXPECT_EQ(std::distance(std::sregex_iterator(policy.begin(), policy.end(), hash), std::sregex_iterator()),
            2);
  EXPECT_EQ(count(page, "<script"), 3U) << "the data and two scripts";
  EXPECT_EQ(count(page, "</script"), 3U);
}

TEST(StudyPage, AsksNothingOfAnywhere) {
  const std::string page = without_chart_js(page_of(made_study()));
  for (const char* word : {"https://", "src=\"http", "href=\"http", "src=\"/", "@import", "url(", "fetch(",
                           "XMLHttpRequest", "sourceMappingURL"})
    EXPECT_EQ(page.find(word), page.npos) << word;
}

TEST(StudyPage, EscapesWhatLabelsAndMessagesSay) {
  const std::string evil = "</script><script>alert(\"1\")</script><!-- & '";
  MadeCurves made;
  made.curve(evil, MethodFamily::structural, 4, 2, 1, 1e-6).failed(Outcome::unstable, evil);
  WorkPrecision study = made.judged();
  study.title = evil;
  study.converged_reference.why_not = evil;
  study.converged_reference.certified = false;
  study.common_floors = {{1e-5, {0, 0, 0}}};
  const std::string page = page_of(study);
  EXPECT_EQ(count(page, "<script"), 3U);
  EXPECT_EQ(count(page, "</script"), 3U);
  EXPECT_EQ(without_chart_js(page).find("<!--"), page.npos);
  EXPECT_EQ(page.find("alert(\"1\")"), page.npos);
  EXPECT_EQ(data_in(page)["curves"][0]["label"], evil);
  EXPECT_EQ(data_in(page)["runs"][5]["message"], evil);
}

TEST(StudyPage, LeavesNoTemplateTagBehind) {
  for (const WorkPrecision& study : {made_study(), MadeCurves().judged(), WorkPrecision{}}) {
    const std::string page = page_of(study);
    const std::string body = page.substr(0, page.find("<script"));
    EXPECT_EQ(body.find("{{"), body.npos);
    EXPECT_EQ(body.find("}}"), body.npos);
    EXPECT_FALSE(std::regex_search(body, std::regex("\\bnan\\b")));
  }
}

TEST(StudyPage, ShowsEveryTableOfAStudy) {
  // Terms are links to the glossary.
  const std::string page =
      std::regex_replace(page_of(made_study()), std::regex("<a class=\"term\"[^>]*>([^<]*)</a>"), "$1");
  for (const char* text :
       {"The cheapest method for each decade", "no run is both cheaper and closer", "4.00 ± 0.00",
        "grid convergence index is 0.00031 m with a safety factor of 1.25 (made standard)",
        "it grew at 0.25 s", "stable but wrong: 1 m off", "test data", "Held against",
        "<th scope=\"col\">Verdict</th>"})
    EXPECT_NE(page.find(text), page.npos) << text;
}

TEST(StudyPage, CheapestTableHasARowForEachDecade) {
  const WorkPrecision study = made_study();
  const std::string page = page_of(study);
  ASSERT_FALSE(study.time_cheapest.empty());
  EXPECT_EQ(count(page.substr(page.find("id=\"study-time\"")), "<th scope=\"row\" class=\"n\">1e-"),
            study.time_cheapest.size() + study.total_cheapest.size());
}

TEST(StudyPage, ShowsTheCurvesOfOtherProgramsInChartAndTable) {
  WorkPrecision study = made_study();
  study.given_curves = {made_given_curve(), made_given_curve("laptop"), made_given_curve("cluster", 0.5)};
  study.given_curves[1].name = "away";
  study.given_curves[2].name = "scaled";
  study.given_curves[2].program.clear();
  study.yardstick = 0.25;
  const std::string page = page_of(study);
  const nlohmann::json given = data_in(page)["given"];
  ASSERT_EQ(given.size(), 3U);
  EXPECT_EQ(given[0]["label"], "springs: Springs 1.0, 4 threads");
  EXPECT_EQ(given[1]["label"], "away: Springs 1.0, 4 threads, another machine");
  EXPECT_EQ(given[2]["label"], "scaled (external run), 4 threads, scaled from another machine");
  EXPECT_FALSE(given[0]["style"]["open"]);
  EXPECT_TRUE(given[1]["style"]["open"]) << "of another machine, without a yardstick";
  EXPECT_FALSE(given[2]["style"]["open"]);
  EXPECT_EQ(given[0]["runs"][1]["seconds"][0], 1);
  EXPECT_EQ(given[1]["runs"][1]["seconds"][0], 1);
  EXPECT_EQ(given[2]["runs"][1]["seconds"][0], 0.5) << "here, where the yardstick takes half as long";
  EXPECT_EQ(given[2]["runs"][1]["stated_seconds"], 1);
  EXPECT_EQ(given[0]["runs"][0]["time"]["tip-max"], 0.02);
  EXPECT_EQ(given[0]["runs"][0]["total"]["tip-rms"], 0.015);
  EXPECT_TRUE(given[0]["runs"][0]["total"]["curve"].is_null());
  EXPECT_EQ(given[0]["runs"][2]["outcome"], "not compared");
  for (const char* question : {"time", "total"})
    for (const auto& curve : given) {
      const nlohmann::json chosen = data_in(page)["chosen"][question];
      EXPECT_EQ(std::count(chosen.begin(), chosen.end(), curve["label"]), 1)
          << "shown at first: " << curve["label"];
    }
  std::set<std::string> colors;
  for (const auto& curve : data_in(page)["curves"]) {
    EXPECT_NE(curve["style"]["marker"], given[0]["style"]["marker"]);
    colors.insert(curve["style"]["color"]);
  }
  for (const auto& curve : given) EXPECT_FALSE(colors.contains(curve["style"]["color"])) << curve["style"];
  for (const char* text : {"Other programs", "it ended early", "<td class=\"w\">laptop</td>", "this machine",
                           "Hollow marks are of another machine without a yardstick",
                           "by the ratio of the yardsticks, which is 250 ms here"})
    EXPECT_NE(page.find(text), page.npos) << text;
  const std::string summary = content_of(evaluate_study({run_with("made").loaded, study}, {})).summary;
  EXPECT_NE(summary.find(
                "- scaled: 16 links, 1 s on cluster (500 ms here), 4 threads: 0.005 m from the mesh of the "
                "case, 0.015 m from the converged motion\n"),
            summary.npos)
      << summary;
  study.given_curves.resize(1);
  EXPECT_EQ(page_of(study).find("Hollow marks"), page.npos) << "of this machine alone";
  EXPECT_EQ(page_of(study).find("by the ratio of the yardsticks"), page.npos);
  EXPECT_EQ(page_of(made_study()).find("Other programs"), page.npos);
}

TEST(StudyPage, AStudyThatCountsWorkHasNoCurveOfAnotherProgramOnItsCharts) {
  WorkPrecision study = made_study();
  study.given_curves = {made_given_curve()};
  for (WorkPrecisionRun& run : study.runs) run.seconds.clear();
  evaluate(study);
  const std::string page = page_of(study);
  EXPECT_TRUE(data_in(page)["given"].empty());
  EXPECT_NE(page.find("They are on neither chart"), page.npos);
}

TEST(StudyPage, SaysWhereNothingCouldBeCompared) {
  WorkPrecision study = made_study();
  for (WorkPrecisionRun& run : study.runs) run.total_error = {};
  study.converged_reference.agreement = -1;
  evaluate(study);
  const std::string page = page_of(study);
  EXPECT_EQ(count(page, "class=\"study-chart\""), 1U);
  EXPECT_NE(page.find("No run could be compared, so there is nothing to draw."), page.npos);
}

TEST(StudyPage, IsAPartOfThePageOfARun) {
  const plumb::Run run = run_with("a");
  const Study study = made_study_of_a_case();
  Pictures drawn;
  const std::vector<RunSection> sections{work_precision_section(study.result)};
  drawn.sections[sections[0].figures_key] = pictures(study.result);
  const std::vector<PageSection> shown{work_precision_on_page()};
  const std::string page = to_page(document_of(evaluate(run, {}, sections), drawn), drawn, shown);
  EXPECT_EQ(count(page, "class=\"study-chart\""), 2U);
  EXPECT_EQ(count(page, "id=\"study-data\""), 1U);
  EXPECT_NE(page.find("script-src 'sha256-"), page.npos);
  EXPECT_NE(page.find("href=\"#study\""), page.npos);
  const std::string without = to_page(document_of(evaluate(run, {}), {}), {});
  EXPECT_EQ(count(page, "<script"), count(without, "<script") + 2) << "its data and its script";
  EXPECT_EQ(without.find("id=\"study-data\""), without.npos);
}

TEST(EscapeJson, LeavesTheValuesAsTheyWere) {
  const nlohmann::json json = {{"a", "<!-- </script> & \u2028"}, {"b", 1.5}};
  const std::string escaped = escape_json_for_html(json.dump());
  EXPECT_EQ(escaped.find_first_of("<>&"), escaped.npos);
  EXPECT_EQ(nlohmann::json::parse(escaped), json);
}

}  // namespace study_page_test
}  // namespace plumb
