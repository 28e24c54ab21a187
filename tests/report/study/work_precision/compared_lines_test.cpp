#include "report/study/work_precision/compared_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "report/figure/curve_style.h"
#include "tests/report/study/work_precision/made_study.h"

namespace plumb {
namespace study_lines_test {

std::vector<std::string> labels(const std::vector<StudyLine>& lines) {
  std::vector<std::string> result;
  for (const StudyLine& line : lines) result.push_back(line.label);
  return result;
}

TEST(StudyLines, OfTimeAreOfTheFixedMeshAndOfTheTotalOfEveryMesh) {
  const WorkPrecision study = made_study();
  const auto time = study_lines(study, StudyQuestion::time), total = study_lines(study, StudyQuestion::total);
  EXPECT_EQ(labels(time), (std::vector<std::string>{"first", "second", "fourth"}));
  EXPECT_EQ(labels(total), labels(time));
  for (std::size_t i = 0; i < time.size(); ++i) {
    EXPECT_EQ(2 * time[i].runs.size(), total[i].runs.size());
    for (const std::size_t run : time[i].runs) EXPECT_EQ(study.runs[run].elements, 4);
  }
}

TEST(StudyLines, TellsGoodFromWrongFromFailed) {
  const WorkPrecision study = made_study();
  std::size_t good = 0, wrong = 0, failed = 0;
  for (const WorkPrecisionRun& run : study.runs) {
    const RunFate fate = fate_of(study, run, StudyQuestion::time);
    good += fate == RunFate::good;
    wrong += fate == RunFate::wrong;
    failed += fate == RunFate::failed;
    EXPECT_EQ(trouble_of(study, run, StudyQuestion::time).empty(), fate == RunFate::good);
  }
  EXPECT_EQ(good, 30U);
  EXPECT_EQ(wrong, 2U);
  EXPECT_EQ(failed, 2U);
}

TEST(StudyLines, SayWhyARunIsInTrouble) {
  WorkPrecision study = made_study();
  WorkPrecisionRun run = study.runs.front();
  EXPECT_EQ(trouble_of(study, run, StudyQuestion::time), "");
  run.time_error.tip_max = 0.5;
  EXPECT_EQ(trouble_of(study, run, StudyQuestion::time), "stable but wrong: 0.5 m off");
  run.time_error.tip_max = -1;
  EXPECT_EQ(trouble_of(study, run, StudyQuestion::time),
            "not compared: there is no reference that reaches its outputs");
  run.outcome = Outcome::diverged;
  EXPECT_EQ(trouble_of(study, run, StudyQuestion::time), "diverged") << "without a message";
  run.message = "at 0.5 s";
  EXPECT_EQ(trouble_of(study, run, StudyQuestion::time), "at 0.5 s");
}

TEST(StudyLines, ChosenOnesAreThoseOnTheFrontAndOneOfEachFamily) {
  MadeCurves made;
  for (int k = 0; k < 20; ++k)
    made.curve("slow " + std::to_string(k), MethodFamily::explicit_one_step, 4, 2, 100 + k, 1e-3);
  made.curve("front", MethodFamily::explicit_one_step, 4, 4, 1, 1e-8);
  made.curve("other family", MethodFamily::multistep, 4, 1, 1e3, 1e-2);
  const std::vector<std::string> chosen = labels(chosen_lines(made.judged(), StudyQuestion::time, 5));
  EXPECT_EQ(chosen.size(), 5U);
  EXPECT_TRUE(std::count(chosen.begin(), chosen.end(), "front"));
  EXPECT_TRUE(std::count(chosen.begin(), chosen.end(), "other family"));
  EXPECT_TRUE(std::count(chosen.begin(), chosen.end(), "slow 0")) << "the best of the rest";
}

TEST(StudyLines, AllAreChosenWhereThereIsRoom) {
  EXPECT_EQ(chosen_lines(made_study(), StudyQuestion::time, 3).size(), 3U);
}

TEST(CurveStyle, IsTheSameOnEveryMeshAndNoTwoMethodsShareOne) {
  MadeCurves made;
  for (int k = 0; k < 40; ++k)
    for (const MethodFamily family : {MethodFamily::explicit_one_step, MethodFamily::structural})
      made.curve(std::string(word(family)) + std::to_string(k), family, 4 + 4 * (k % 2), 2, 1, 1e-6, 1);
  const auto styles = curve_styles(made.judged());
  ASSERT_EQ(styles.size(), 80U);
  std::set<std::tuple<std::string, int, int, bool>> seen, seen_dark;
  for (const auto& [label, style] : styles) {
    const auto form = [&](Color color) {
      return std::tuple{css(color), static_cast<int>(style.marker), static_cast<int>(style.dash),
                        style.open_marker};
    };
    EXPECT_TRUE(seen.insert(form(style.color)).second) << label;
    EXPECT_TRUE(seen_dark.insert(form(style.dark_color)).second) << label;
  }
}

TEST(CurveStyle, ColorsAreWrittenForCss) {
  EXPECT_EQ(css(Color::hex(0x0072B2)), "#0072b2");
  EXPECT_EQ(css(Color{}), "#000000");
}

}  // namespace study_lines_test
}  // namespace plumb
