#include <nlohmann/json.hpp>

#include "tests/report/program/program.h"

namespace plumb {
namespace sensitivity_program_test {

using Json = nlohmann::json;

/// A rigid rod that falls by 3 g t²/4 at its tip, which is quick to draw, and what it is held against: one
/// criterion that is worth something, and one that nothing misses.
void write_case(const fs::path& folder) {
  const auto reference = [&](const std::string& name, const std::string& column, double last) {
    write_text(folder / (name + ".toml"), R"(title = "known"
kind = "computed"
source = "free fall"
obtained = "by hand"
time_unit = "s"
columns = ["t", "x"]
rows = [[0.0, 0.0], [0.1, )" + std::to_string(last) +
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
[scene]
size = [64, 36]
frame_rate = 5
[sensitivity]
blunders = ["other-sign", "half-mesh"]
)" + reference("fall", "tip.y", -0.0736) +
                                    "tolerance = 2e-3\n" + reference("side", "tip.z", 0) +
                                    "tolerance = 0.9\n");
}

TEST(SensitivityProgram, AStudyNamesWhatIsWeakAndItsPageOpensAgain) {
  const TemporaryFolder folder;
  write_case(folder.path());
  const Ended ended = plumb_in(folder.path(), {"study", "a.toml", "sensitivity"});
  EXPECT_EQ(ended.status, 1) << "one is weak: " << ended.err << ended.out;
  EXPECT_NE(ended.out.find("Weak: side: tip.z notices nothing."), std::string::npos) << ended.out;
  const fs::path output = folder / "output/a_sensitivity";
  for (const char* file : {"index.html", "study.json", "results.json", "junit.xml", "summary.md",
                           "figures/sensitivity.png", "figures/sensitivity.csv"})
    EXPECT_TRUE(fs::exists(output / file)) << file;
  EXPECT_FALSE(fs::exists(folder / "output/a_sensitivity.unfinished.jsonl"));
  const Json found = Json::parse(read_text(output / "results.json")).at("sensitivity");
  ASSERT_EQ(found["numbers"].size(), 3U) << "length, density and gravity: a rod has no stiffness";
  EXPECT_NEAR(found["numbers"][2]["up"]["noticed"][0]["change"].get<double>(), 2e-3 / 0.0736, 3e-3);
  EXPECT_EQ(found["numbers"][1]["up"]["noticed"][0]["change"], -1) << "all that is falls alike";
  EXPECT_TRUE(found["blunders"].at(1)["found"].at(0)["noticed"]) << "gravity the other way";
  EXPECT_NE(found["blunders"].at(0)["why_not"], "") << "half the mesh";
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
  EXPECT_NE(json["headline"].get<std::string>().find(" Weak: side: tip.z notices nothing."),
            std::string::npos)
      << json["headline"];
  EXPECT_NE(read_text(folder / "b/junit.xml").find("weak: it notices no number"), std::string::npos);
  EXPECT_NE(read_text(folder / "b/index.html").find("id=\"sensitivity\""), std::string::npos);
  const Ended again = plumb_in(folder.path(), {"report", "b", "-o", "c"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(read_text(folder / "c/results.json"))["sensitivity"], json["sensitivity"])
      << "its seconds would differ if it were made anew";
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
