#include <nlohmann/json.hpp>

#include "render/image/png.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace variants_program_test {

using Json = nlohmann::json;

void write_case(const fs::path& path, const std::string& expected) {
  write_text(path, R"(title = "Too far"
[cable]
length = 1
area = 25e-6
density = 320
youngs_modulus = 1.6e6
elements = 4
[start]
angular_velocity = [0, 4, 0]
[supports]
first = "pinned"
[method]
name = "rk4"
step = 5e-4
[time]
end = 0.2
output_interval = 0.02
[[probe]]
name = "tip"
at = 1
[[study.variant]]
name = "short steps"
outcome = "completed"
[[study.variant]]
name = "long steps"
set = { method.step = 5e-3 }
outcome = ")" + expected +
                       "\"\n");
}

TEST(VariantsProgram, AFailureThatIsExpectedEndsWithZero) {
  const TemporaryFolder folder;
  write_case(folder / "a.toml", "unstable");
  const Ended ended = plumb_in(folder.path(), {"study", "a.toml", "--json"});
  const Json json = Json::parse(ended.out);
  write_case(folder / "a.toml", json["variants"][1]["solve"]["outcome"]);
  const Ended again = plumb_in(folder.path(), {"study", "a.toml"});
  EXPECT_EQ(again.status, 0) << again.err << again.out;
  for (const char* file : {"index.html", "study.json", "results.json", "junit.xml", "summary.md",
                           "figures/variants_energy.png", "figures/variants_probe.png"})
    EXPECT_TRUE(fs::exists(folder / "output/a_variants" / file)) << file;
  EXPECT_TRUE(text_in_png(read_text(folder / "output/a_variants/figures/variants_energy.png"),
                          renderer_keyword, "figure"));
}

TEST(VariantsProgram, OneThatDoesNotFailAsExpectedEndsWithOne) {
  const TemporaryFolder folder;
  write_case(folder / "a.toml", "completed");
  const Ended ended = plumb_in(folder.path(), {"study", "a.toml", "variants", "-o", "b"});
  EXPECT_EQ(ended.status, 1) << ended.err << ended.out;
  EXPECT_NE(ended.out.find("Not as expected: 1 of 2 variants: \"long steps\"."), std::string::npos)
      << ended.out;
  EXPECT_EQ(Json::parse(read_text(folder / "b/results.json"))["all_criteria_met"], false);
}

TEST(VariantsProgram, ReportSaysWhatTheStudySaid) {
  const TemporaryFolder folder;
  write_case(folder / "a.toml", "completed");
  plumb_in(folder.path(), {"study", "a.toml", "-o", "b"});
  fs::remove(folder / "a.toml");
  const Ended ended = plumb_in(folder.path(), {"report", "b", "-o", "c"});
  EXPECT_EQ(ended.status, 1) << ended.err << ended.out;
  Json b = Json::parse(read_text(folder / "b/results.json")),
       c = Json::parse(read_text(folder / "c/results.json"));
  b.erase("seconds");
  c.erase("seconds");
  EXPECT_EQ(b, c);
  EXPECT_EQ(read_text(folder / "b/figures/variants_energy.png"),
            read_text(folder / "c/figures/variants_energy.png"));
  EXPECT_EQ(read_text(folder / "b/study.json"), read_text(folder / "c/study.json"));
}

TEST(VariantsProgram, ACaseWithoutVariantsIsRefused) {
  const TemporaryFolder folder;
  const Ended ended = plumb_in(folder.path(), {"study", case_path("pendulum.toml"), "variants", "-o", "b"});
  EXPECT_EQ(ended.status, 3);
  expect_one_line(ended.err);
  EXPECT_NE(ended.err.find("has no [[study.variant]]"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(folder / "b"));
}

TEST(VariantsProgram, AStudyFileThatIsCutIsRefused) {
  const TemporaryFolder folder;
  write_case(folder / "a.toml", "completed");
  plumb_in(folder.path(), {"study", "a.toml", "-o", "b"});
  Json json = Json::parse(read_text(folder / "b/study.json"));
  json["variants"].erase(0);
  write_text(folder / "b/study.json", json.dump());
  const Ended ended = plumb_in(folder.path(), {"report", "b"});
  EXPECT_EQ(ended.status, 3);
  expect_one_line(ended.err);
}

TEST(VariantsProgram, AStudyFileThatWasEditedIsRefusedWhateverItSays) {
  const TemporaryFolder folder;
  write_case(folder / "a.toml", "completed");
  ASSERT_EQ(plumb_in(folder.path(), {"study", "a.toml", "-o", "b"}).status, 1);
  const Json whole = Json::parse(read_text(folder / "b/study.json"));
  const auto refused = [&](const Json& json, const std::string& why) {
    write_text(folder / "b/study.json", json.dump());
    const Ended ended = plumb_in(folder.path(), {"report", "b", "-o", "c"});
    EXPECT_EQ(ended.status, 3) << ended.out;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "c"));
  };
  Json edited = whole;
  for (Json& variant : edited["variants"]) variant["outcome"] = "completed";
  refused(edited, "it was changed after it was written");
  edited.erase("check_sum");
  refused(edited, "has no check_sum");
  write_text(folder / "b/study.json", whole.dump());
  EXPECT_EQ(plumb_in(folder.path(), {"report", "b", "-o", "c"}).status, 1)
      << "as it was, but for white space";
}

}  // namespace variants_program_test
}  // namespace plumb
