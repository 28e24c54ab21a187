#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "render/image/png.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace modes_program_test {

using Json = nlohmann::json;

/// A soft cable pinned at both ends, six of its modes, and a reference over three of them.
void write_case(const fs::path& folder, double first, const std::string& more = "") {
  write_text(folder / "a.toml", R"(title = "Wire"
[cable]
length = 1
area = 25e-6
density = 320
youngs_modulus = 1.6e6
elements = 8
[supports]
first = "pinned"
last = "pinned"
[method]
name = "modes"
count = 6
[[probe]]
name = "mid"
at = 0.5
[[reference]]
file = "known.toml"
compare = { f = "frequency" }
tolerance = 1e-3
[[figure]]
name = "frequencies"
y = "frequency"
reference = "known"
[scene]
size = [320, 180]
frame_rate = 4
)" + more);
  write_text(folder / "known.toml", fmt::format(R"(title = "Closed form"
kind = "computed"
source = "Euler and Bernoulli"
obtained = "from its formula"
columns = ["mode", "f"]
rows = [[1, {0}], [2, {0}], [3, {1}]]
[[series]]
name = "f"
figure = "formula"
unit = "Hz"
uncertainty = 1e-9
uncertainty_basis = "rounding"
)",
                                                first, 4 * first));
}

/// The first frequency of that cable, Hz.
double first_frequency() {
  const double EI = 1.6e6 * 25e-6 * 25e-6 / (4 * std::numbers::pi), mass = 320 * 25e-6;
  return std::numbers::pi / 2 * std::sqrt(EI / mass);
}

TEST(ModesProgram, ReportHoldsModesAgainstAReferenceOverTheirNumbers) {
  const TemporaryFolder folder;
  write_case(folder.path(), first_frequency());
  const Ended ended = plumb_in(folder.path(), {"run", "a.toml"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const fs::path out = folder / "output/a";
  for (const char* file : {"index.html", "run.h5", "modes.csv", "probes.csv", "figures/mode_shapes.png",
                           "figures/frequencies.png", "frames/0000.png", "animation.png"})
    EXPECT_TRUE(fs::exists(out / file)) << file;
  EXPECT_FALSE(fs::exists(out / "figures/energy.png")) << "there is nothing over time";
  const Json json = Json::parse(read_text(out / "results.json"));
  EXPECT_EQ(json["outcome"], "accurate") << json["headline"];
  EXPECT_EQ(json["modes"]["count"], 6);
  EXPECT_EQ(json["modes"]["kind"][0], "vibration");
  EXPECT_NEAR(json["modes"]["columns"]["frequency"]["values"][0].get<double>(), first_frequency(), 1e-4);
  const std::string said = json["verdicts"][0]["message"];
  EXPECT_NE(said.find("over 3 of 3 modes from 1 to 3"), std::string::npos) << said;
  const std::string page = read_text(out / "index.html");
  EXPECT_NE(page.find("<h2>Modes</h2>"), std::string::npos);
  EXPECT_EQ(page.find("The load grew over the run"), std::string::npos);
}

TEST(ModesProgram, ModeFarFromItsReferenceIsNotMet) {
  const TemporaryFolder folder;
  write_case(folder.path(), first_frequency() + 2e-3);
  const Ended ended = plumb_in(folder.path(), {"run", "a.toml", "--json"});
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
}

TEST(ModesProgram, FewerModesThanTheReferenceHasAreNotHeldAgainstAllOfIt) {
  const TemporaryFolder folder;
  write_case(folder.path(), first_frequency());
  const Ended ended = plumb_in(folder.path(), {"run", "a.toml", "--set", "method.count=2"});
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  const Json json = Json::parse(read_text(folder / "output/a/results.json"));
  const std::string said = json["verdicts"][0]["message"];
  EXPECT_EQ(json["verdicts"][0]["status"], "not run") << said;
  EXPECT_NE(said.find("does not have mode 3"), std::string::npos) << said;
}

TEST(ModesProgram, FramesVibrateInTheModeThatIsAskedFor) {
  const TemporaryFolder folder;
  write_case(folder.path(), first_frequency());
  ASSERT_EQ(plumb_in(folder.path(), {"solve", "a.toml", "-o", "out"}).status, 0);
  const auto frame = [&](const char* mode) {
    const Ended ended = plumb_in(folder.path(), {"render", "out", "--mode", mode});
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    return read_text(folder / "out/frames/0000.png");
  };
  const std::string first = frame("1"), third = frame("3");
  EXPECT_NE(first, third);
  EXPECT_EQ(frame("1"), first);
  for (const char* mode : {"0", "7", "x"})
    EXPECT_EQ(plumb_in(folder.path(), {"render", "out", "--mode", mode}).status, 2) << mode;
}

TEST(ModesProgram, UnstableEquilibriumEndsWithTheStatusOfAFailedSolver) {
  const TemporaryFolder folder;
  write_case(folder.path(), first_frequency(), "[start]\nstretch = 0.9\n");
  const Ended ended = plumb_in(folder.path(), {"run", "a.toml", "--set", "method.about=start"});
  EXPECT_EQ(ended.status, 4) << ended.out << ended.err;
  const Json json = Json::parse(read_text(folder / "output/a/results.json"));
  EXPECT_EQ(json["solve"]["outcome"], "unstable-equilibrium") << json["headline"];
  EXPECT_EQ(json["modes"]["kind"][0], "growing");
}

TEST(ModesProgram, SolveWritesTheTableAndSaysItInJson) {
  const TemporaryFolder folder;
  write_case(folder.path(), first_frequency());
  const Ended table = plumb_in(folder.path(), {"solve", "a.toml", "--csv", "-"});
  EXPECT_TRUE(table.out.starts_with("mode,kind,frequency [Hz],")) << table.out;
  const Ended ended = plumb_in(folder.path(), {"solve", "a.toml", "--json"});
  EXPECT_EQ(Json::parse(ended.out)["modes"]["count"], 6) << ended.out << ended.err;
}

}  // namespace modes_program_test
}  // namespace plumb
