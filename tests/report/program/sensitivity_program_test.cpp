#include <nlohmann/json.hpp>

#include "tests/report/program/program.h"

namespace plumb {
namespace sensitivity_program_test {

using Json = nlohmann::json;

/// A cable that falls freely as −g t²/2, and what it falls onto: one criterion that is worth something, and
/// one that nothing misses.
void write_case(const fs::path& folder) {
  const auto reference = [&](const std::string& name, const std::string& column, double last) {
    write_text(folder / (name + ".toml"), R"(title = "known"
kind = "computed"
source = "free fall"
obtained = "by hand"
time_unit = "s"
columns = ["t", "x"]
rows = [[0.0, 0.0], [0.2, )" + std::to_string(last) +
                                              R"(]]
[[series]]
name = "x"
figure = "none"
unit = "m"
uncertainty = 1e-3
uncertainty_basis = "rounding"
)");
    return "[[reference]]\nfile = \"" + name + ".toml\"\ncompare = { x = \"" + column + "\" }\n";
  };
  write_text(folder / "a.toml", R"(title = "Falling"
[cable]
length = 1
area = 25e-6
density = 320
youngs_modulus = 1.6e6
elements = 2
[loads]
gravity = [0, -9.81, 0]
[method]
name = "rk4"
step = 1e-3
[time]
end = 0.2
output_interval = 0.1
[[probe]]
name = "end"
at = 0
[scene]
size = [64, 36]
frame_rate = 5
[sensitivity]
numbers = ["loads.gravity.1", "cable.density"]
blunders = ["other-sign", "chain"]
)" + reference("fall", "end.y", -0.1962) +
                                    "tolerance = 0.01\n" + reference("side", "end.z", 0) +
                                    "tolerance = 0.9\n");
}

TEST(SensitivityProgram, AStudyNamesWhatIsWeakAndItsPageOpensAgain) {
  const TemporaryFolder folder;
  write_case(folder.path());
  const Ended ended = plumb_in(folder.path(), {"study", "a.toml", "sensitivity"});
  EXPECT_EQ(ended.status, 1) << "one is weak: " << ended.err << ended.out;
  EXPECT_NE(ended.out.find("Weak: side: end.z notices nothing."), std::string::npos) << ended.out;
  const fs::path output = folder / "output/a_sensitivity";
  for (const char* file : {"index.html", "study.json", "results.json", "junit.xml", "summary.md",
                           "figures/sensitivity.png", "figures/sensitivity.csv"})
    EXPECT_TRUE(fs::exists(output / file)) << file;
  EXPECT_FALSE(fs::exists(folder / "output/a_sensitivity.unfinished.jsonl"));
  const Json found = Json::parse(read_text(output / "results.json")).at("sensitivity");
  // 0.01 m of a fall of 0.1962 m.
  EXPECT_NEAR(found["numbers"][1]["up"]["noticed"][0]["change"].get<double>(), 0.051, 0.003);
  EXPECT_EQ(found["numbers"][0]["up"]["noticed"][0]["change"], -1) << "all that is falls alike";
  fs::remove(folder / "a.toml");
  const Ended again = plumb_in(folder.path(), {"report", output.string(), "-o", "b"});
  EXPECT_EQ(again.status, 1) << again.err;
  EXPECT_EQ(Json::parse(read_text(folder / "b/results.json")).at("sensitivity"), found);
}

TEST(SensitivityProgram, ARunHasItBesideItsVerdictsWhichStayAsTheyAre) {
  const TemporaryFolder folder;
  write_case(folder.path());
  const Ended ended = plumb_in(folder.path(), {"run", "a.toml", "-o", "b"});
  EXPECT_EQ(ended.status, 0) << "a weak criterion is a remark: " << ended.err << ended.out;
  const Json json = Json::parse(read_text(folder / "b/results.json"));
  EXPECT_NE(json["headline"].get<std::string>().find(" Weak: side: end.z notices nothing."),
            std::string::npos)
      << json["headline"];
  EXPECT_NE(read_text(folder / "b/junit.xml").find("weak: it notices no number"), std::string::npos);
  EXPECT_NE(read_text(folder / "b/index.html").find("id=\"sensitivity\""), std::string::npos);
  const Ended again = plumb_in(folder.path(), {"report", "b", "-o", "c"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(read_text(folder / "c/results.json"))["sensitivity"], json["sensitivity"])
      << "its seconds would differ if it were made anew";
}

TEST(SensitivityProgram, ARigidRodIsAskedWithoutWhatItDoesNotHave) {
  const TemporaryFolder folder;
  write_text(folder / "known.toml", R"(title = "known"
kind = "computed"
source = "a"
obtained = "by hand"
time_unit = "s"
columns = ["t", "y"]
rows = [[0.0, 0.0], [0.1, -0.0736]]
[[series]]
name = "y"
figure = "none"
unit = "m"
uncertainty = 1e-3
uncertainty_basis = "rounding"
)");
  write_text(folder / "rod.toml", R"(title = "Rod"
[cable]
length = 1
area = 25e-6
density = 320
youngs_modulus = 1.6e6
elements = 1
model = "rigid"
[supports]
first = "pinned"
[loads]
gravity = [0, -9.81, 0]
[method]
name = "rk4"
step = 1e-2
[time]
end = 0.1
output_interval = 0.05
[[probe]]
name = "tip"
at = 1
[[reference]]
file = "known.toml"
compare = { y = "tip.y" }
tolerance = 2e-3
)");
  const Ended ended = plumb_in(folder.path(), {"study", "rod.toml", "sensitivity", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json found = Json::parse(ended.out).at("sensitivity");
  for (const Json& number : found["numbers"])
    EXPECT_EQ(number["key"].get<std::string>().find("stiffness"), std::string::npos) << number["key"];
  EXPECT_NEAR(found["numbers"][2]["up"]["noticed"][0]["change"].get<double>(), 2e-3 / 0.0736, 3e-3)
      << "of gravity: the tip falls by 3 g t²/4";
  EXPECT_EQ(found["numbers"][1]["up"]["noticed"][0]["change"], -1) << "of density, which does not matter";
  for (const Json& blunder : found["blunders"]) {
    const std::string kind = blunder["kind"];
    const bool of_others = kind == "chain" || kind == "lumped-mass" || kind == "half-mesh";
    EXPECT_TRUE(!of_others || blunder["why_not"] != "") << blunder["name"];
  }
}

TEST(SensitivityProgram, ACaseWithoutACriterionOrAMethodIsRefused) {
  const TemporaryFolder folder;
  write_case(folder.path());
  const Ended bare =
      plumb_in(folder.path(), {"study", "a.toml", "sensitivity", "-o", "b", "--set", "reference=[]"});
  EXPECT_EQ(bare.status, 3) << bare.out;
  expect_one_line(bare.err);
  EXPECT_NE(bare.err.find("has no criterion that could notice anything"), std::string::npos) << bare.err;
  const Ended given = plumb_in(folder.path(), {"study", case_path("bring_your_own.toml"), "sensitivity"});
  EXPECT_EQ(given.status, 2) << given.out;
  EXPECT_NE(given.err.find("has no [method]"), std::string::npos) << given.err;
  const Ended asked =
      plumb_in(folder.path(), {"check", case_path("bring_your_own.toml"), "--set", "sensitivity.largest=2"});
  EXPECT_EQ(asked.status, 3) << asked.out;
  EXPECT_NE(asked.err.find("belongs to runs of Plumb's own"), std::string::npos) << asked.err;
}

}  // namespace sensitivity_program_test
}  // namespace plumb
