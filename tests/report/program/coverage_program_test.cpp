#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/report/program/program.h"

namespace plumb {
namespace coverage_program_test {

using Json = nlohmann::json;

/// Runs on files of its own: an external run g.csv, tip.x = 1 + t every 0.1 s to 2 s, against 1 + t every 0.5
/// s.
class CoverageProgram : public ::testing::Test {
 protected:
  CoverageProgram() {
    write("g.csv", rows(0, 20, 1));
    write("known.toml", R"(title = "known"
kind = "computed"
source = "a"
obtained = "by hand"
time_unit = "s"
columns = ["t", "x"]
rows = [[0, 1], [0.5, 1.5], [1, 2], [1.5, 2.5], [2, 3]]
[[series]]
name = "x"
figure = "Fig. 1"
unit = "m"
uncertainty = 0.001
uncertainty_basis = "guess"
)");
    write("case.toml", case_text(""));
  }

  /// Rows every 0.1 s, `first` to `last`, only every `step`-th of them.
  static std::string rows(int first, int last, int step, double bump = 0) {
    std::string text = "t,tip.x\n";
    for (int k = first; k <= last; k += step)
      text += fmt::format("{},{}\n", k / 10.0, 1 + k / 10.0 + (k > 0 && k < 20 ? bump : 0));
    return text;
  }

  static std::string case_text(const std::string& run_keys) {
    return "title = \"mini\"\n[[run]]\nfile = \"g.csv\"\n" + run_keys +
           "[cable]\nlength = 1\narea = 1e-6\ndensity = 1000\nyoungs_modulus = 1e6\n[supports]\nfirst = "
           "\"pinned\"\n[[probe]]\nname = \"tip\"\nat = 1\n[[reference]]\nfile = \"known.toml\"\ncompare = { "
           "x = "
           "\"tip.x\" }\ntolerance = 0.01\n[scene]\nsize = [32, 32]\nframe_rate = 1\n";
  }

  void write(const std::string& name, const std::string& text) { write_text(folder_ / name, text); }

  Ended report(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", "case.toml", "-o", "out"});
    return plumb_in(folder_.path(), more);
  }

  /// That the verdicts end as in `statuses`, with the exit status that goes with these.
  void expect_statuses(const Ended& ended, const std::vector<std::string>& statuses,
                       const std::string& why = "") {
    const bool met =
        std::all_of(statuses.begin(), statuses.end(), [](const std::string& s) { return s == "passed"; });
    EXPECT_EQ(ended.status, met ? 0 : 1) << ended.out << ended.err;
    const Json results = Json::parse(read_text(folder_ / "out/results.json"));
    ASSERT_EQ(results.at("verdicts").size(), statuses.size());
    for (std::size_t k = 0; k < statuses.size(); ++k)
      EXPECT_EQ(results["verdicts"][k].at("status"), statuses[k]) << results["verdicts"][k].at("message");
    EXPECT_EQ(results.at("all_criteria_met"), met);
    EXPECT_EQ(results.at("outcome") == "accurate", met) << results.at("headline");
    EXPECT_NE(ended.out.find(why), std::string::npos) << ended.out;
  }

  TemporaryFolder folder_;
};

TEST_F(CoverageProgram, AWholeRunIsAccurate) {
  expect_statuses(report(), {"passed"}, "over 5 of 5 times from 0 to 2 s");
}

TEST_F(CoverageProgram, ARunThatIsTooShortIsNotRun) {
  write("g.csv", "t,tip.x\n0,1\n0.1,77\n");
  expect_statuses(report(), {"not run"}, "only 1 of 5 times");
}

TEST_F(CoverageProgram, ProbesOfARunThatFailedAreNotRunOverTheEndThatTheyLack) {
  // ½(λ − λ³) is the load over EA, which is at its limit, 0.19245, before the end of the run.
  write("pressed.toml", R"(title = "pressed"
method = { name = "statics", step = 0.05 }
cable = { length = 1, area = 0.01, density = 1000, youngs_modulus = 1e6, second_moment = 0.01, elements = 4 }
supports = { first = "clamped" }
loads = { end_force = [-2500, 0, 0] }
probe = [{ name = "tip", at = 1 }]
time = { end = 1, output_interval = 0.05 }
)");
  EXPECT_EQ(plumb_in(folder_.path(), {"solve", "pressed.toml", "-o", "solved"}).status, 4);
  write("g.csv", read_text(folder_ / "solved/probes.csv"));
  std::string known = read_text(folder_ / "known.toml");
  const auto rows_of_known = [&](const std::string& rows) {
    const std::size_t at = known.find("rows = ");
    known.replace(at, known.find('\n', at) - at, "rows = " + rows);
    write("known.toml", known);
  };
  rows_of_known("[[0, 1], [0.5, 0.8376], [0.75, 0.6514]]");
  expect_statuses(report(), {"passed"}, "over 3 of 3 times from 0 to 0.75 s");
  rows_of_known("[[0, 1], [0.5, 0.8376], [0.75, 0.6514], [1, 0.5]]");
  expect_statuses(report(), {"not run"}, "g does not have t = 1 s: it is from 0 to 0.75 s");
  write("case.toml", case_text("[[run]]\nfile = \"h.csv\"\ntolerances = { \"tip.x\" = 0.01 }\n"));
  write("h.csv", "t,tip.x\n0,1\n0.5,0.8376\n0.75,0.6514\n1,0.5\n");
  expect_statuses(report(), {"not run", "passed", "not run"}, "times of the two runs can be compared");
}

TEST_F(CoverageProgram, AWrongUnitOfTheTimeIsNotRun) {
  write("case.toml", case_text("units = { t = \"us\" }\n"));
  expect_statuses(report(), {"not run"}, "it is from 0 to 2e-06 s, and nothing is extrapolated");
}

TEST_F(CoverageProgram, AGapIsNotRun) {
  write("g.csv", rows(0, 20, 20));
  expect_statuses(report(), {"not run"}, "g has no output within 0.25 s of t = 0.5 s");
}

TEST_F(CoverageProgram, ADistanceOverNothingIsNotRun) {
  write("case.toml", case_text("[[run]]\nfile = \"h.csv\"\ntolerances = { \"tip.x\" = 0.01 }\n"));
  write("h.csv", "t,tip.x\n2.0,3.0\n");
  expect_statuses(report(), {"passed", "not run", "not run"}, "only 1 of 21 times of the two runs");
  write("h.csv", rows(0, 20, 20));
  write("g.csv", rows(0, 20, 1, 50));
  expect_statuses(report(), {"failed", "not run", "not run"}, "h has no output within");
}

TEST_F(CoverageProgram, AShortSolveIsNotRunUnlessTheCaseClaimsNoMore) {
  std::vector<std::string> command{"run",   case_path("pendulum_published.toml"),
                                   "-o",    "out",
                                   "--set", "time.end=1e-3",
                                   "--set", "time.output_interval=1e-3",
                                   "--set", "loads.gravity=[0,981,0]",
                                   "--set", "scene.size=[32,32]"};
  expect_statuses(plumb_in(folder_.path(), command), {"not run", "not run", "not run"},
                  "only 1 of 101 times");
  command.insert(command.end(), {"--set", "time.end=0.04", "--set", "reference.0.coverage.to=0.04"});
  const Ended claimed = plumb_in(folder_.path(), command);
  EXPECT_EQ(claimed.status, 1) << "a hundred times the gravity is not within rounding";
  EXPECT_NE(claimed.out.find("the case claims no more than to 0.04 s"), std::string::npos) << claimed.out;
}

TEST_F(CoverageProgram, RareOutputsOfASolveAreNotRun) {
  expect_statuses(plumb_in(folder_.path(), {"run", case_path("pendulum_published.toml"), "-o", "out", "--set",
                                            "time.output_interval=2", "--set", "scene.size=[32,32]", "--set",
                                            "scene.frame_rate=1"}),
                  {"not run", "not run", "not run"}, "Plumb has no output within");
}

TEST_F(CoverageProgram, AShareOfNothingIsRefused) {
  const Ended ended = report({"--set", "reference.0.coverage.share=0"});
  EXPECT_EQ(ended.status, 3) << ended.out;
  expect_one_line(ended.err);
  EXPECT_NE(ended.err.find("share"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(CoverageProgram, WithoutACriterionARunEndsWell) {
  const Ended ended = report({"--set", "reference=[]"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_EQ(Json::parse(read_text(folder_ / "out/results.json")).at("all_criteria_met"), false);
  EXPECT_EQ(ended.out.find("criteria are met"), std::string::npos) << ended.out;
}

}  // namespace coverage_program_test
}  // namespace plumb
