#include "engine/run/case_source_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace plumb {
namespace case_source_json_test {

using Json = nlohmann::ordered_json;

TEST(CaseSourceJson, KeepsEveryTextAndEveryByteOfAGivenRun) {
  CaseSource source{{"a.toml", "title = \"ρ\""}, {"a=1"}, {{"r.toml", "x"}}};
  std::string bytes;
  for (int k = 0; k < 256; ++k) bytes += static_cast<char>(k);
  source.given_runs = {{"run.h5", bytes}, {"run.csv", "t,x\n"}};
  const CaseSource read = case_source_from_json(Json::parse(case_source_to_json(source).dump()));
  EXPECT_EQ(read.file.name, "a.toml");
  EXPECT_EQ(read.file.text, source.file.text);
  EXPECT_EQ(read.overrides, source.overrides);
  ASSERT_EQ(read.references.size(), 1U);
  EXPECT_EQ(read.references[0].text, "x");
  ASSERT_EQ(read.given_runs.size(), 2U);
  EXPECT_TRUE(read.given_runs[0].text == bytes) << read.given_runs[0].text.size();
  EXPECT_EQ(read.given_runs[1].text, "t,x\n");
}

TEST(CaseSourceJson, ReadsEarlierFilesAndRefusesWhatIsNoByte) {
  const Json earlier{
      {"name", "a.toml"}, {"text", "b"}, {"overrides", Json::array()}, {"references", Json::array()}};
  EXPECT_EQ(case_source_from_json(earlier).file.text, "b");
  Json wrong = case_source_to_json({{"a.toml", ""}, {}, {}, {{"run.csv", ""}}});
  wrong["runs"][0]["text"] = "ρ";
  EXPECT_THROW(case_source_from_json(wrong), std::runtime_error);
}

}  // namespace case_source_json_test
}  // namespace plumb
