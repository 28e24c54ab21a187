#include "engine/study/work_precision/given_curves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/integrate/integrate.h"
#include "tests/engine/study/in_memory.h"
#include "tests/engine/study/work_precision/tiny_study.h"

namespace plumb {
namespace given_curves_test {

/// A case of a tip alone, with one external run of two points.
Case case_with_points() {
  Case spec = tiny_study_case("[[probe]]\nname = \"tip\"\nat = 1\n").spec;
  GivenRunSpec given;
  given.name = "springs";
  given.points = {{"coarse", "a.csv", 0.5, {}, {}}, {"fine", "b.csv", 2, {}, {}}};
  spec.given_runs.push_back(given);
  return spec;
}

/// The tip of a trajectory at every `stride`-th output, up to `until` (s), moved by (0.6, 0, 0.8) times
/// `off(t)`.
template <class Off>
GivenRun tip_of(const Trajectory& motion, std::size_t stride, double until, Off off) {
  GivenRun run;
  for (const char* name : {"tip.x", "tip.y", "tip.z"}) run.columns.push_back({name, name, "m", "m", {}});
  for (std::size_t k = 0; k < motion.times.size() && motion.times[k] <= until; k += stride) {
    run.times.push_back(motion.times[k]);
    const Eigen::Vector3d tip =
        motion.q[k].tail<6>().head<3>() + off(motion.times[k]) * Eigen::Vector3d(0.6, 0, 0.8);
    for (int j = 0; j < 3; ++j) run.columns[static_cast<std::size_t>(j)].values.push_back(tip[j]);
  }
  return run;
}

Trajectory motion_of(Case spec, double interval) {
  spec.time.output_interval = interval;
  return integrate(spec);
}

TEST(GivenCurves, AnErrorIsTheGreatestDistanceOfTheTipAtTheOutputsOfTheReference) {
  const Case spec = case_with_points();
  const Trajectory same = motion_of(spec, 0.01);
  Case finer = spec;
  finer.cable.elements = 4;
  const Trajectory converged = motion_of(finer, 0.01);
  GivenRun run = tip_of(same, 1, 1, [](double) { return 0; });
  run.points = {tip_of(same, 1, 1, [](double t) { return std::abs(t - 0.03) < 1e-9 ? 5e-3 : 0; }),
                tip_of(converged, 1, 1, [](double) { return 1e-3; })};
  const std::vector<GivenCurve> curves = given_curves(spec, std::vector{run}, same, converged);
  ASSERT_EQ(curves.size(), 1U);
  ASSERT_EQ(curves[0].points.size(), 2U) << "the run itself has no time";
  const GivenPoint &spike = curves[0].points[0], &even = curves[0].points[1];
  EXPECT_EQ(spike.label, "coarse");
  EXPECT_EQ(spike.seconds, 0.5);
  EXPECT_NEAR(spike.time_error.tip_max, 5e-3, 1e-15);
  EXPECT_NEAR(spike.time_error.tip_rms, 5e-3 / std::sqrt(6.0), 1e-15) << "one of six outputs";
  EXPECT_NEAR(even.total_error.tip_max, 1e-3, 1e-15);
  EXPECT_NEAR(even.total_error.tip_rms, 1e-3, 1e-15);
  const double apart = error_norms(converged, same).tip_max;
  EXPECT_NEAR(spike.total_error.tip_max, apart, 6e-3) << apart;
  EXPECT_EQ(even.total_error.curve, -1) << "of which a tip tells nothing";
}

TEST(GivenCurves, APointHasTheErrorOfTheSameRunOfPlumbsOwn) {
  LoadedCase loaded = tiny_study_case("[[probe]]\nname = \"tip\"\nat = 1\n");
  Case one = loaded.spec;
  one.method.step = 5e-3;
  GivenRun run = tip_of(integrate(one), 1, 1, [](double) { return 0; });
  GivenRunSpec given;
  given.name = "own";
  given.file = "own.csv";
  given.seconds = 0.25;
  loaded.spec.given_runs = {given};
  const WorkPrecision study = run_work_precision(loaded.spec, false, InMemory(), std::vector{run});
  ASSERT_EQ(study.given_curves.size(), 1U);
  const GivenPoint& point = study.given_curves[0].points.at(0);
  const auto same = std::find_if(study.runs.begin(), study.runs.end(), [](const WorkPrecisionRun& any) {
    return any.method.name == "rk4" && any.elements == 2 && any.method.step == 5e-3;
  });
  ASSERT_NE(same, study.runs.end());
  EXPECT_EQ(point.time_error.tip_max, same->time_error.tip_max);
  EXPECT_EQ(point.time_error.tip_rms, same->time_error.tip_rms);
  EXPECT_EQ(point.total_error.tip_max, same->total_error.tip_max);
  EXPECT_EQ(study.work(study.given_curves[0], point), 0.25);
  EXPECT_EQ(study.yardstick, -1) << "nothing asks for it";
  for (const std::size_t k : study.total_front) EXPECT_LT(k, study.runs.size());
}

TEST(GivenCurves, BetweenItsRowsATipIsInterpolatedAsFarAsThatCanBeBorne) {
  const Case spec = case_with_points();
  const Trajectory same = motion_of(spec, 0.005), fine = motion_of(spec, 0.0025);
  GivenRun run = tip_of(same, 1, 1, [](double) { return 0; });
  const auto off = [](double) { return 2e-2; };
  // The study's outputs 0.005, 0.015, … lie between rows that are 0.01 apart; so few rows cannot be tried.
  run.points = {tip_of(fine, 1, 1, off), tip_of(same, 2, 1, off)};
  const GivenCurve curve = given_curves(spec, std::vector{run}, same, {}).at(0);
  EXPECT_NEAR(curve.points[0].time_error.tip_max, 2e-2, 1e-15) << curve.points[0].why_not;
  EXPECT_EQ(curve.points[0].total_error.tip_max, -1) << "without a reference";
  EXPECT_EQ(curve.points[1].time_error.tip_max, -1);
  EXPECT_NE(curve.points[1].why_not.find("its rows are too far apart: what lies between them is not known"),
            std::string::npos)
      << curve.points[1].why_not;

  // 0.004 s apart: 13 rows, of which 0.005 and others are none.
  GivenRun between = tip_of(motion_of(spec, 0.004), 1, 1, off);
  run.points = {between, tip_of(motion_of(spec, 0.004), 1, 1, [](double) { return 1e-9; })};
  const GivenCurve others = given_curves(spec, std::vector{run}, same, {}).at(0);
  EXPECT_NEAR(others.points[0].time_error.tip_max, 2e-2, 2e-3) << others.points[0].why_not;
  EXPECT_EQ(others.points[1].time_error.tip_max, -1)
      << "an error far below what interpolation leaves open is not known";
  EXPECT_NE(others.points[1].why_not.find("between them the tip is known to "), std::string::npos)
      << others.points[1].why_not;
}

TEST(GivenCurves, ARunThatEndsEarlyOrFailedHasNoError) {
  const Case spec = case_with_points();
  const Trajectory same = motion_of(spec, 0.01);
  const auto none = [](double) { return 0; };
  GivenRun run = tip_of(same, 1, 1, none);
  run.points = {tip_of(same, 1, 0.035, none), run};
  run.points[1].ending = {"unstable", "it grew"};
  const GivenCurve curve = given_curves(spec, std::vector{run}, same, same).at(0);
  for (const GivenPoint& point : curve.points) {
    EXPECT_EQ(point.time_error.tip_max, -1);
    EXPECT_EQ(point.total_error.tip_max, -1);
  }
  EXPECT_EQ(curve.points[0].why_not, "it goes from 0 to 0.03 s, the study from 0 to 0.05 s");
  EXPECT_EQ(curve.points[1].why_not, "it failed: unstable: it grew");
}

TEST(GivenCurves, TimesOfAnotherMachineAreScaledByTheRatioOfTheYardsticks) {
  WorkPrecision study;
  const GivenPoint point{"a", "a.csv", 3, {}, {}, ""};
  GivenCurve curve{"chrono", "", 1, "laptop", 0.5, {point}};
  study.yardstick = 0.25;
  EXPECT_TRUE(study.is_scaled(curve));
  EXPECT_EQ(study.work(curve, point), 1.5) << "this machine is twice as fast";
  curve.yardstick = -1;
  EXPECT_FALSE(study.is_scaled(curve));
  EXPECT_TRUE(curve.is_elsewhere());
  EXPECT_EQ(study.work(curve, point), 3);
  study.timed = false;
  EXPECT_EQ(study.work(curve, point), -1) << "force evaluations of another program are not known";
}

TEST(GivenCurves, ACurveWithAYardstickHasOneMeasuredHereAndKeptForTheNextRun) {
  LoadedCase loaded = tiny_study_case("[[probe]]\nname = \"tip\"\nat = 1\n");
  GivenRunSpec given;
  given.name = "theirs";
  given.seconds = 1;
  given.machine = "laptop";
  given.yardstick = 0.1;
  loaded.spec.given_runs = {given};
  const std::vector<GivenRun> runs{tip_of(integrate(loaded.spec), 1, 1, [](double) { return 0; })};
  Journal journal;
  Runner runner(journal);
  const WorkPrecision first = run_work_precision(loaded.spec, true, runner, runs);
  EXPECT_GT(first.yardstick, 0);
  EXPECT_EQ(run_work_precision(loaded.spec, true, runner, runs).yardstick, first.yardstick);
}

}  // namespace given_curves_test
}  // namespace plumb
