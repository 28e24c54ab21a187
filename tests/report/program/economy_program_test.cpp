#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/study/economy/economy_json.h"
#include "report/study/economy/economy_figure.h"
#include "report/study/economy/economy_section.h"
#include "report/study/economy/economy_text.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace economy_program_test {

using Json = nlohmann::json;

/// A rod of plastic that hardly bends, in a small picture.
std::string rod(const std::string& tolerance = "0.5") {
  return "title = \"rod\"\n[cable]\nlength = 0.5\narea = 7.85e-5\ndensity = 1000\nyoungs_modulus = "
         "1e9\nelements = 3\n"
         "[supports]\nfirst = \"pinned\"\n[loads]\ngravity = [0, -9.81, 0]\n[method]\nname = \"scene\"\n"
         "[time]\nend = 0.2\noutput_interval = 0.04\n[[probe]]\nname = \"tip\"\nat = 1.0\n"
         "[scene]\nsize = [160, 90]\ntolerance = " +
         tolerance + "\n";
}

TEST(EconomyProgram, RunsWhatTheSceneNeedsSaysWhyAndUsesItAgain) {
  const TemporaryFolder folder;
  write_text(folder / "rod.toml", rod());
  const Ended first = plumb_in(folder.path(), {"run", "rod.toml", "-o", "out", "--explain"});
  ASSERT_EQ(first.status, 0) << first.err << first.out;
  EXPECT_NE(first.out.find("> rigid rod, rk4"), std::string::npos) << first.out;
  EXPECT_NE(first.out.find("taken: 2 × "), std::string::npos) << first.out;
  EXPECT_NE(first.out.find("the search took"), std::string::npos) << first.out;
  const Json results = Json::parse(read_text(folder / "out/results.json"));
  const Json& economy = results.at("economy");
  EXPECT_TRUE(economy.at("needs").get<std::string>().starts_with("rigid rod")) << economy.at("needs");
  EXPECT_LE(2 * economy.at("picture_error").get<double>(), 0.5);
  EXPECT_NE(economy.at("in_words").get<std::string>().find("the 3 elements of the case are off by"),
            std::string::npos)
      << economy.at("in_words");
  EXPECT_EQ(results.at("case").at("cable").at("model"), "rigid");
  EXPECT_TRUE(fs::exists(folder / "out/figures/economy.png"));
  EXPECT_NE(read_text(folder / "out/index.html").find("What the scene needs"), std::string::npos);

  const Ended again = plumb_in(folder.path(), {"run", "rod.toml", "-o", "out"});
  EXPECT_NE(again.out.find("known from an earlier search"), std::string::npos) << again.out;
  EXPECT_TRUE(Json::parse(read_text(folder / "out/results.json")).at("economy").at("reused").get<bool>());
  // Another case, or the same with something set, is searched anew.
  const Ended other =
      plumb_in(folder.path(), {"solve", "rod.toml", "-o", "out", "--set", "scene.size=[320,180]"});
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_EQ(other.out.find("known from an earlier search"), std::string::npos) << other.out;
}

TEST(EconomyProgram, SolveTellsItsChoiceInJson) {
  const TemporaryFolder folder;
  write_text(folder / "rod.toml", rod());
  const Ended ended = plumb_in(folder.path(), {"solve", "rod.toml", "--csv", "rod.csv", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json economy = Json::parse(ended.out).at("economy");
  EXPECT_TRUE(economy.at("holds").get<bool>()) << economy;
  const Json chosen = economy.at("tried").at(economy.at("chosen").get<std::size_t>());
  EXPECT_EQ(chosen.at("cable").at("model"), "rigid") << chosen;
  EXPECT_GT(chosen.at("method").at("step").get<double>(), 0) << chosen;
  const Ended plain = plumb_in(folder.path(), {"solve", "rod.toml", "--csv", "rod.csv", "--json", "--set",
                                               "method={ name = 'rk4', step = 1e-4 }"});
  EXPECT_FALSE(Json::parse(plain.out).contains("economy")) << plain.out << plain.err;
}

TEST(EconomyProgram, TheReportOfARunHasItsChoiceAgain) {
  const TemporaryFolder folder;
  write_text(folder / "rod.toml", rod());
  ASSERT_EQ(
      plumb_in(folder.path(), {"run", "rod.toml", "-o", "out", "--set", "cable.quadrature=full"}).status, 0);
  const Json before = Json::parse(read_text(folder / "out/results.json"));
  const Ended ended = plumb_in(folder.path(), {"report", "out"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(Json::parse(read_text(folder / "out/results.json")).at("economy"), before.at("economy"));
  Json choice = Json::parse(read_text(folder / "out/choice.json"));
  choice["economy"]["tolerance"] = 5;
  write_text(folder / "out/choice.json", choice.dump());
  const Ended edited = plumb_in(folder.path(), {"report", "out", "-o", "new"});
  EXPECT_EQ(edited.status, 3) << edited.out;
  expect_one_line(edited.err);
  EXPECT_NE(edited.err.find("choice.json: cannot be used: it was changed"), std::string::npos) << edited.err;
  EXPECT_FALSE(fs::exists(folder / "new"));
  fs::remove(folder / "out/choice.json");
  const Ended without = plumb_in(folder.path(), {"report", "out"});
  EXPECT_EQ(without.status, 1) << without.out;
  EXPECT_NE(without.out.find("the run was left to its scene"), std::string::npos) << without.out;
}

TEST(EconomyProgram, EndsWithOneWhereNothingHoldsAndSaysWhatIsUncertain) {
  const TemporaryFolder folder;
  write_text(folder / "rod.toml", rod("1e-9"));
  const Ended ended =
      plumb_in(folder.path(), {"run", "rod.toml", "-o", "out", "--set", "cable.youngs_modulus=1e5"});
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("Uncertain is where the cable is"), std::string::npos) << ended.out;
  EXPECT_EQ(plumb_in(folder.path(), {"solve", "rod.toml", "--set", "cable.youngs_modulus=1e5"}).status, 1)
      << "what is solved is no more proven";
}

TEST(EconomyProgram, WhatCannotBeLeftToTheSceneIsRefused) {
  const TemporaryFolder folder;
  std::string text = rod();
  text.replace(text.find("elements = 3"), 12, "model = \"chain\"\nelements = 3");
  write_text(folder / "chain.toml", text);
  const Ended ended = plumb_in(folder.path(), {"run", "chain.toml", "--economy"});
  EXPECT_EQ(ended.status, 3) << ended.err;
  expect_one_line(ended.err);
  EXPECT_FALSE(fs::exists(folder / "output/chain"));
  write_text(folder / "rod.toml", rod());
  const Ended given =
      plumb_in(folder.path(), {"run", case_path("bring_your_own.toml"), "--economy", "-o", "given"});
  EXPECT_EQ(given.status, 2) << given.err;
  EXPECT_NE(given.err.find("has no [method]"), std::string::npos) << given.err;
  EXPECT_FALSE(fs::exists(folder / "given"));
  const Ended alone = plumb_in(folder.path(), {"run", "rod.toml", "--explain", "--set", "method.name=rk4",
                                               "--set", "method.step=1e-4"});
  EXPECT_EQ(alone.status, 2) << alone.err;
  EXPECT_NE(alone.err.find("--explain is for --economy"), std::string::npos) << alone.err;
  const Ended rigid = plumb_in(folder.path(), {"study", "rod.toml", "sweep", "--set", "cable.model=rigid",
                                               "--set", "method.name=rk4", "--set", "method.step=1e-3"});
  EXPECT_EQ(rigid.status, 3) << rigid.err;
  EXPECT_NE(rigid.err.find("a rigid rod has no methods or meshes to study"), std::string::npos) << rigid.err;
}

TEST(EconomyProgram, AStudyProvesWhatEachPictureNeeds) {
  const TemporaryFolder folder;
  write_text(folder / "rod.toml",
             rod() + "[study.economy]\nwidths = [160]\nscenes = 2\nreference_elements = 4\n");
  const Ended ended =
      plumb_in(folder.path(), {"study", "rod.toml", "-o", "out", "--set", "cable.youngs_modulus=1e6"});
  const Json results = Json::parse(read_text(folder / "out/results.json"));
  EXPECT_EQ(ended.status, results.at("all_criteria_met").get<bool>() ? 0 : 1) << ended.out << ended.err;
  const Json& picture = results.at("economy").at("pictures").at(0);
  const Json& choice = picture.at("tried").at(picture.at("chosen").get<std::size_t>());
  EXPECT_LE(choice.at("true_picture_error").get<double>(), 0.5);
  EXPECT_LE(choice.at("true_picture_error").get<double>(),
            2 * choice.at("estimated_picture_error").get<double>());
  EXPECT_EQ(results.at("economy").at("random_scenes").size(), 2U);
  const Ended again = plumb_in(folder.path(), {"report", "out"});
  EXPECT_EQ(again.status, ended.status) << again.err;
  Json anew = Json::parse(read_text(folder / "out/results.json"));
  EXPECT_EQ(anew.at("economy"), results.at("economy"));
}

Economy small_economy() {
  Economy economy;
  economy.tolerance = 0.5;
  economy.case_elements = 4;
  economy.safe_work = 1e9;
  economy.search_work = 1e7;
  for (const auto& [elements, estimate] : std::vector<std::pair<int, double>>{{4, 8.1}, {16, 0.12}}) {
    TriedCandidate tried;
    tried.candidate.cable.elements = elements;
    tried.candidate.cable.second_moment = 1e-9;
    tried.candidate.method.name = "velocity-verlet";
    tried.candidate.method.step = 1e-4;
    tried.outcome = Outcome::completed;
    tried.seconds = 1e-3 * elements;
    tried.estimate = estimate;
    tried.why =
        elements == 4 ? "left: 2 × 8.1 px is more than 0.5 px" : "taken: 2 × 0.12 px is within 0.5 px";
    economy.tried.push_back(tried);
  }
  economy.chosen = 1;
  economy.holds = true;
  return economy;
}

TEST(EconomyText, SaysWhatTheSceneNeedsAndHowFarTheCasesMeshIsOff) {
  SceneSpec scene;
  EXPECT_EQ(
      economy_sentence(small_economy(), scene),
      "At 960 by 540 pixels this scene needs a cable of 16 elements, off by 0.12 px as estimated; the 4 "
      "elements of the case are off by 8.1 px (tolerance 0.5 px).");
}

TEST(EconomyText, ExplainsEveryCandidateInOrder) {
  const std::vector<std::string> lines = explain(small_economy());
  ASSERT_GE(lines.size(), 3U);
  EXPECT_TRUE(lines[0].starts_with("  cable of 4 elements, velocity-verlet")) << lines[0];
  EXPECT_NE(lines[0].find("8.1 px  left: "), std::string::npos) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("> cable of 16 elements")) << lines[1];
  EXPECT_NE(lines.back().find("0.01 of the predicted cost"), std::string::npos) << lines.back();
}

TEST(EconomyText, TheVerdictIsOfTheErrorWithTheSafetyFactor) {
  Economy economy = small_economy();
  EXPECT_EQ(economy_verdict(economy).status, VerdictStatus::passed);
  EXPECT_DOUBLE_EQ(economy_verdict(economy).value, 0.24);
  economy.chosen = 0;
  economy.holds = false;
  economy.uncertain = "where the cable is";
  EXPECT_EQ(economy_verdict(economy).status, VerdictStatus::failed);
  economy.tried[0].estimate = -1;
  EXPECT_EQ(economy_verdict(economy).status, VerdictStatus::not_run);
}

TEST(EconomyFigure, HasTheToleranceTheCandidatesAndTheChosenOne) {
  const Figure figure = economy_figure(small_economy());
  const Panel& panel = figure.plot.panels.at(0);
  ASSERT_EQ(panel.series.size(), 2U);
  EXPECT_EQ(panel.series[0].label, "cable");
  EXPECT_EQ(panel.series[0].y, (std::vector<double>{8.1, 0.12}));
  EXPECT_EQ(panel.series[1].label, "chosen");
  EXPECT_EQ(panel.series[1].y, std::vector<double>{0.12});
  EXPECT_EQ(panel.rules.at(0).from, 0.5);
}

}  // namespace economy_program_test
}  // namespace plumb
