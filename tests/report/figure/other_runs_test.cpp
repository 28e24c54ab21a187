#include "report/figure/other_runs.h"

#include <algorithm>
#include <cmath>

#include "engine/base/errors.h"
#include "engine/run/run_file.h"
#include "render/image/png.h"
#include "render/scene/motion.h"
#include "report/verdict/reference_points.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace other_runs_test {

/// Three runs of the same time and one of another, made once.
class SceneOfRuns : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<TemporaryFolder>();
    solve("coarse", {});
    solve("fine", {"--set", "cable.elements=8"});
    solve("other/coarse", {"--set", "cable.elements=2"});
    solve("short", {"--set", "time.end=0.1"});
  }
  static void TearDownTestSuite() { folder.reset(); }

  static void solve(const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"solve", case_path("pendulum.toml"),
                                          "-o",    name,
                                          "--set", "time.end=0.2",
                                          "--set", "method.rtol=1e-6",
                                          "--set", "scene.size=[480,270]",
                                          "--set", "scene.trail=0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = plumb_in(folder->path(), arguments);
    ASSERT_EQ(ended.status, 0) << ended.err;
  }

  static Ended render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"render", "coarse", "-o", "-", "--frames", "5"});
    return plumb_in(folder->path(), arguments);
  }

  static Image picture(const std::vector<std::string>& arguments) {
    const Ended ended = render(arguments);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return ended.status == 0 ? decode_png(ended.out, "frame") : Image{};
  }

  static std::unique_ptr<TemporaryFolder> folder;
};
std::unique_ptr<TemporaryFolder> SceneOfRuns::folder;

/// Pixels near a colour.
int count_of(const Image& image, const std::array<int, 3>& rgb) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
    int distance = 0;
    for (std::size_t c = 0; c < 3; ++c) distance = std::max(distance, std::abs(image.rgb[i + c] - rgb[c]));
    count += distance <= 40 ? 1 : 0;
  }
  return count;
}
constexpr std::array second_color = {213, 94, 0};
constexpr std::array third_color = {0, 158, 115};

TEST_F(SceneOfRuns, OthersAreDrawnOverAndBesideInTheirColours) {
  const Image alone = picture({}), over = picture({"--over", "fine"}), beside = picture({"--beside", "fine"});
  const Image both = picture({"--over", "fine", "--beside", "other/coarse"});
  EXPECT_EQ(count_of(alone, second_color), 0);
  EXPECT_GT(count_of(over, second_color), 20);
  EXPECT_GT(count_of(beside, second_color), 50);
  EXPECT_EQ(count_of(beside, third_color), 0);
  EXPECT_GT(count_of(both, second_color), 20);
  EXPECT_GT(count_of(both, third_color), 50);
}

TEST_F(SceneOfRuns, ThoseOverStayAndThoseBesideStandApartToTheRight) {
  const plumb::Run first = read_run((*folder / "coarse/run.h5").string());
  std::vector<OtherRun> others;
  others.push_back({"fine", read_run((*folder / "fine/run.h5").string()), false});
  others.push_back({"a", read_run((*folder / "fine/run.h5").string()), true});
  others.push_back({"b", read_run((*folder / "other/coarse/run.h5").string()), true});
  SceneInput scene = scene_input(first.loaded.spec);
  add_other_runs(scene, "coarse", first.trajectory, others);
  ASSERT_EQ(scene.others.size(), 3U);
  EXPECT_EQ(scene.others[0].offset, Vec3::Zero());
  const Vec3 right = scene.others[1].offset.normalized();
  EXPECT_NEAR(right.y(), 0, 1e-12) << "not level";
  const auto extent = [&](const Trajectory& trajectory, const Vec3& offset) {
    std::pair<double, double> range{1e9, -1e9};
    for (const Vec3& place : covered_places(Motion(trajectory, offset))) {
      range.first = std::min(range.first, place.dot(right));
      range.second = std::max(range.second, place.dot(right));
    }
    return range;
  };
  const auto zeroth = extent(first.trajectory, Vec3::Zero());
  const auto one = extent(*scene.others[1].trajectory, scene.others[1].offset);
  const auto two = extent(*scene.others[2].trajectory, scene.others[2].offset);
  EXPECT_NEAR(one.first - zeroth.second, 0.25, 1e-9);
  EXPECT_NEAR(two.first - one.second, 0.25, 1e-9);
}

TEST_F(SceneOfRuns, LabelsAreFoldersOrPathsWhereTwoFoldersHaveOneName) {
  const auto read = [&](const std::string& name) {
    return read_run((*folder / (name + "/run.h5")).string());
  };
  const plumb::Run first = read("coarse");
  std::vector<OtherRun> others;
  others.push_back({"some/fine/", read("fine"), false});
  others.push_back({"other/coarse/run.h5", read("other/coarse"), false});
  SceneInput scene = scene_input(first.loaded.spec);
  add_other_runs(scene, "coarse", first.trajectory, others);
  EXPECT_EQ(scene.label, "coarse");
  EXPECT_EQ(scene.others[0].label, "fine");
  EXPECT_EQ(scene.others[1].label, "other/coarse/run.h5");
}

TEST_F(SceneOfRuns, PointsOfTwoComponentsAreShownWhereTheThirdCannotBeSeen) {
  const Image without = picture({"--camera", "top"}), with = picture({"--camera", "top", "--points"});
  // The first other colour is that of the published points.
  EXPECT_EQ(count_of(without, second_color), 0);
  // Those of the converged solution lie over most of them.
  EXPECT_GT(count_of(with, second_color), 10);
  for (const char* camera : {"front", "fit", "orbit"}) {
    const Ended ended = render({"--points", "--camera", camera});
    EXPECT_EQ(ended.status, 2) << camera;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find("tip: only its x and z are known"), std::string::npos) << ended.err;
  }
}

TEST_F(SceneOfRuns, PointsAreAtThePublishedPlaces) {
  plumb::Run run = read_run((*folder / "coarse/run.h5").string());
  SceneInput scene = scene_input(run.loaded.spec);
  scene.spec.view = View::top;
  const ReferencePoints flat = reference_points(run, run.trajectory, scene);
  ASSERT_EQ(flat.series.size(), 2U);  // published and converged
  const Reference& published = run.loaded.references[0];
  ASSERT_EQ(flat.series[0].places.size(), published.times.size());
  double highest = -1;
  for (const Vec3& place : covered_places(Motion(run.trajectory))) highest = std::max(highest, place.y());
  for (std::size_t i = 0; i < published.times.size(); ++i) {
    EXPECT_EQ(flat.series[0].places[i].x(), published.find("tip_x")->values[i]);
    EXPECT_EQ(flat.series[0].places[i].z(), published.find("tip_z")->values[i]);
    EXPECT_GT(flat.series[0].places[i].y(), highest);
  }
  EXPECT_EQ(flat.left_out.size(), 2U);

  // With the third component known, any view will do and all three are taken.
  run.loaded.spec.references[0].compare.push_back({"mid_y", "tip.y"});
  scene.spec.view = View::orbit;
  const ReferencePoints whole = reference_points(run, run.trajectory, scene);
  ASSERT_EQ(whole.series.size(), 1U);
  for (std::size_t i = 0; i < published.times.size(); ++i)
    EXPECT_EQ(whole.series[0].places[i].y(), published.find("mid_y")->values[i]);
}

TEST_F(SceneOfRuns, RunsThatCannotBeShownTogetherAreRefusedByName) {
  write_text(*folder / "broken/run.h5", "no run");
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"short", "short: ends at 0.1 s, but coarse at 0.2 s"},
      {"nowhere", "nowhere"},
      {"broken", "broken/run.h5"}};
  for (const char* option : {"--over", "--beside"})
    for (const auto& [path, message] : bad) {
      const Ended ended = plumb_in(folder->path(), {"render", "coarse", "-o", "bad", option, path});
      EXPECT_EQ(ended.status, 3) << path;
      expect_one_line(ended.err);
      EXPECT_NE(ended.err.find(message), std::string::npos) << ended.err;
      EXPECT_FALSE(fs::exists(*folder / "bad"));
    }
  const plumb::Run first = read_run((*folder / "coarse/run.h5").string());
  std::vector<OtherRun> others;
  others.push_back({"fine", first, false});
  others[0].run.trajectory.q[2][3] = std::nan("");
  try {
    SceneInput scene = scene_input(first.loaded.spec);
    add_other_runs(scene, "coarse", first.trajectory, others);
    FAIL() << "a state that is not finite was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("fine: the run cannot be drawn: the state at"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace other_runs_test
}  // namespace plumb
