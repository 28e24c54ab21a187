#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/errors.h"
#include "engine/study/variants/variants_file.h"
#include "tests/engine/small_case.h"
#include "tests/engine/study/changed_json.h"
#include "tests/engine/study/in_memory.h"

namespace plumb {
namespace variants_run_test {

VariantsStudy small_study() {
  CaseSource source = small_case();
  source.file.text += R"(
[[study.variant]]
name = "as it is"
outcome = "completed"
[[study.variant.expect]]
quantity = "end-time"
value = 2
within = 1e-9
source = "the case"
[[study.variant]]
name = "too far"
set = { method.name = "rk4", method.step = 0.01 }
outcome = "unstable"
says = "rk4 ended at"
[[study.variant.expect]]
quantity = "constraint-drift"
value = 0
within = 1
source = "none"
)";
  return run_variants(load_case(source), InMemory());
}

TEST(RunVariants, FindsOutcomesAndFiguresInTheOrderOfTheCase) {
  const VariantsStudy study = small_study();
  ASSERT_EQ(study.result.variants.size(), 2U);
  const VariantResult& good = study.result.variants[0];
  EXPECT_EQ(good.trajectory.outcome, Outcome::completed) << good.trajectory.message;
  EXPECT_TRUE(good.met());
  EXPECT_EQ(good.trajectory.times.size(), good.probes.times.size());
  const VariantResult& bad = study.result.variants[1];
  EXPECT_NE(bad.trajectory.outcome, Outcome::completed);
  EXPECT_EQ(bad.run.method.name, "rk4");
  EXPECT_TRUE(std::isnan(bad.expectations.at(0).found)) << "rk4 has no constraints";
  EXPECT_FALSE(bad.met());
}

TEST(VariantsFile, KeepsAllThatTheReportNeeds) {
  const VariantsStudy study = small_study();
  const std::string text = encode_variants(study);
  const VariantsStudy again = decode_variants(text);
  EXPECT_EQ(encode_variants(again), text);
  ASSERT_EQ(again.result.variants.size(), study.result.variants.size());
  for (std::size_t k = 0; k < study.result.variants.size(); ++k) {
    const VariantResult &a = study.result.variants[k], &b = again.result.variants[k];
    EXPECT_EQ(a.spec, b.spec);
    EXPECT_EQ(a.run, b.run);
    EXPECT_EQ(a.trajectory.outcome, b.trajectory.outcome);
    EXPECT_EQ(a.trajectory.message, b.trajectory.message);
    EXPECT_EQ(a.trajectory.energy_drift(), b.trajectory.energy_drift());
    EXPECT_EQ(a.trajectory.counters.steps, b.trajectory.counters.steps);
    EXPECT_EQ(a.met(), b.met());
    ASSERT_EQ(a.probes.columns.size(), b.probes.columns.size());
    EXPECT_EQ(a.probes.columns[0].values, b.probes.columns[0].values);
  }
  EXPECT_EQ(again.result.provenance, study.result.provenance);
}

TEST(VariantsFile, RefusesWhatIsNotOne) {
  const std::string text = encode_variants(small_study());
  const auto fault = [](const std::string& bad) {
    try {
      decode_variants(bad);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_TRUE(fault(text.substr(0, text.size() / 2)).ends_with(": is not JSON"));
  using Json = nlohmann::ordered_json;
  expect_changes_read_or_refused(Json::parse(text), 150, [&](const Json& changed) {
    const std::string why = fault(changed.dump());
    return why == "accepted" ? "" : why;
  });
  for (const auto& [from, to, says] : std::vector<std::array<std::string, 3>>{
           {"\"kind\":\"variants\"", "\"kind\":\"sweep\"", "no study of the kind variants"},
           {"\"version\":2", "\"version\":3", "its version is 3"},
           {"\"version\":2", "\"version\":1", "its version is 1, this program reads 2"},
           {"\"outcome\":\"completed\"", "\"outcome\":\"fine\"", "'fine' is no word"},
           {"\"name\":\"as it is\"", "\"name\":\"other\"", "not those of its case"},
           {"\"time\":[0.0,", "\"time\":[", "not one an output"},
           {"\"figures\":[{", R"("figures":[{"quantity":"x","unit":"m","found":1},{)",
            "not those of its case"}})
    EXPECT_NE(fault(with(text, from, to)).find(says), std::string::npos) << fault(with(text, from, to));
}

}  // namespace variants_run_test
}  // namespace plumb
