#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/report/program/program.h"

namespace plumb {
namespace given_speed_program_test {

using Json = nlohmann::json;

/// A pendulum whose study takes a second, and a [[run]] of two points: a rod that turns and does not fall.
const std::string case_text = R"(title = "Beside another program"
[cable]
length = 1.0
area = 2.5e-5
density = 320
youngs_modulus = 1.6e6
elements = 2
[start]
angular_velocity = [0, 4, 0]
[supports]
first = "pinned"
[loads]
gravity = [0, -9.81, 0]
[method]
name = "rk4"
step = 1e-3
[time]
end = 0.1
output_interval = 0.01
[[probe]]
name = "tip"
at = 1
[scene]
size = [160, 90]
[study.work_precision]
elements = [2, 4]
methods = ["rk4", "generalized-alpha"]
points = 4
smallest_step = 1e-4
repeats = 1
quick.elements = [2, 4]
quick.methods = ["rk4"]
[[run]]
name = "rod"
program = "Rod 2"
threads = 2
machine = "laptop"
[[run.point]]
file = "turns.csv"
seconds = 0.5
label = "turns"
[[run.point]]
file = "falls.csv"
seconds = 0.75
)";

/// Where the tip of the rod is: turning about y, and falling with half of gravity.
std::array<double, 3> rod(double t, double fall) {
  return {std::cos(4 * t), -fall * 0.5 * 9.81 * t * t, -std::sin(4 * t)};
}

void make_case(const fs::path& folder, const std::string& more = "") {
  write_text(folder / "case.toml", case_text + more);
  for (const auto& [name, fall] : {std::pair{"turns.csv", 0.0}, std::pair{"falls.csv", 1.5}}) {
    std::ostringstream table;
    table.precision(17);
    table << "t,tip.x,tip.y,tip.z\n";
    for (int k = 0; k <= 10; ++k) {
      const auto [x, y, z] = rod(0.01 * k, fall);
      table << 0.01 * k << "," << x << "," << y << "," << z << "\n";
    }
    write_text(folder / name, table.str());
  }
}

/// The greatest distance of the rod's tip to a table of probes.
double distance(const std::string& probes, double fall) {
  std::istringstream lines(probes);
  std::string line;
  std::getline(lines, line);
  double greatest = 0;
  while (std::getline(lines, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    double t = 0, x = 0, y = 0, z = 0;
    cells >> t >> x >> y >> z;
    const auto [a, b, c] = rod(t, fall);
    greatest = std::max(greatest, std::hypot(x - a, y - b, z - c));
  }
  return greatest;
}

TEST(GivenSpeedProgram, PointsLieWhereAnErrorComputedApartSaysAtTimesThatAYardstickScales) {
  const TemporaryFolder folder;
  make_case(folder.path());
  for (const std::string verb : {"study", "run"}) {
    const bool scaled = verb == "run";
    const Ended ended = plumb_in(folder.path(), {verb, "case.toml", "-o", verb, "--json", "--set",
                                                 scaled ? "run.0.yardstick=1e3" : "run.0.machine=laptop"});
    ASSERT_TRUE(ended.status == 0 || ended.status == 1) << ended.err;
    const Json study = Json::parse(ended.out)["work_precision"];
    ASSERT_EQ(study["given_curves"].size(), 1U);
    const Json& curve = study["given_curves"][0];
    EXPECT_EQ(curve["machine"], "laptop");
    EXPECT_EQ(curve["threads"], 2);
    const auto solved = [&](int elements) {
      return plumb_in(folder.path(), {"solve", "case.toml", "--csv", "-", "--set", "method.step=5e-5",
                                      "--set", "cable.elements=" + std::to_string(elements)})
          .out;
    };
    const std::string same = solved(2), converged = solved(study["converged_reference"]["elements"]);
    for (const auto& [k, fall] : {std::pair{0U, 0.0}, std::pair{1U, 1.5}}) {
      const Json& point = curve["points"][k];
      EXPECT_NEAR(point["time_error"]["tip_max"].get<double>(), distance(same, fall), 1e-7) << point;
      EXPECT_NEAR(point["total_error"]["tip_max"].get<double>(), distance(converged, fall), 1e-7) << point;
      EXPECT_GT(distance(converged, fall), 1e-2);
    }
    EXPECT_EQ(curve["points"][0]["label"], "turns");
    EXPECT_EQ(curve["points"][1]["label"], "falls") << "after its file";
    const double here = study["yardstick"];
    EXPECT_EQ(here > 0, scaled) << here;
    EXPECT_DOUBLE_EQ(curve["points"][1]["work_seconds"].get<double>(), scaled ? 0.75 * here / 1e3 : 0.75);
    const std::string table = read_text(folder / verb / "figures/work_precision_total.csv");
    EXPECT_NE(table.find(scaled ? "rod: Rod 2, 2 threads, scaled from another machine"
                                : "rod: Rod 2, 2 threads, another machine"),
              table.npos)
        << table;
    const std::string page = read_text(folder / verb / "index.html");
    EXPECT_EQ(page.find("Hollow marks are of another machine") == page.npos, scaled);
    EXPECT_EQ(page.find("scaled to this machine by the ratio of the yardsticks") == page.npos, !scaled);
  }
  // The study is shown again from its file, where the tables are gone.
  fs::remove(folder / "turns.csv");
  fs::remove(folder / "falls.csv");
  Json before = Json::parse(read_text(folder / "study/results.json"));
  ASSERT_LE(plumb_in(folder.path(), {"report", "study"}).status, 1);
  EXPECT_EQ(Json::parse(read_text(folder / "study/results.json"))["work_precision"],
            before["work_precision"]);
}

TEST(GivenSpeedProgram, TheYardstickSaysWhatToWriteIntoACase) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"yardstick"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::regex line("yardstick = ([0-9.]+(e-?[0-9]+)?)\n");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(ended.out, found, line)) << ended.out;
  EXPECT_EQ(ended.out.rfind(found[1].str() + " s: 20000 steps", 0), 0U) << ended.out;
  EXPECT_EQ(plumb_in(folder.path(), {"yardstick", "case.toml"}).status, 2) << "it takes nothing";
  const Json json = Json::parse(plumb_in(folder.path(), {"yardstick", "--json"}).out);
  EXPECT_EQ(json["seconds"], *std::min_element(json["repeats"].begin(), json["repeats"].end()));
  EXPECT_LT(json["seconds"].get<double>(), 20 * std::stod(found[1].str())) << "the same work a moment later";
  EXPECT_FALSE(fs::exists(folder / "output"));
}

TEST(GivenSpeedProgram, ABadPointWritesNothing) {
  const TemporaryFolder folder;
  make_case(folder.path(), "label = \"turns\"\n");
  const Ended ended = plumb_in(folder.path(), {"study", "case.toml", "-o", "out"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find("case.toml:45:9: run.0.point.1.label = \"turns\": must differ"), std::string::npos)
      << ended.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace given_speed_program_test
}  // namespace plumb
