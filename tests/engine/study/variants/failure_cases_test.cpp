#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/file_text.h"
#include "engine/study/variants/run_variants.h"
#include "tests/engine/study/in_memory.h"

namespace plumb {
namespace failure_cases_test {

namespace fs = std::filesystem;

/// Those with variants by their text, as every test program asks for them when it starts.
std::vector<std::string> failure_cases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(PLUMB_SOURCE_DIR) / "cases/failure"))
    if (entry.path().extension() == ".toml" &&
        read_whole_file(entry.path().string()).find("[[study.variant]]") != std::string::npos)
      names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class FailureCase : public testing::TestWithParam<std::string> {};

TEST_P(FailureCase, EveryVariantEndsAsExpectedWithItsFigures) {
  const fs::path path = fs::path(PLUMB_SOURCE_DIR) / "cases/failure" / (GetParam() + ".toml");
  const VariantsStudy study = run_variants(load_case(path.string()), InMemory());
  EXPECT_FALSE(study.result.variants.empty());
  for (const VariantResult& variant : study.result.variants) {
    EXPECT_TRUE(variant.outcome_met())
        << variant.spec.name << ": expected " << variant.spec.outcome << ", found "
        << word(variant.trajectory.outcome) << ": " << variant.trajectory.message;
    for (const ExpectationFound& figure : variant.expectations)
      EXPECT_TRUE(figure.met()) << fmt::format("{}: {} = {:.10g} {}, expected {:.10g} ± {:g}",
                                               variant.spec.name, figure.expected.quantity, figure.found,
                                               figure.unit, figure.expected.value, figure.expected.within);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FailureCase, testing::ValuesIn(failure_cases()),
                         [](const testing::TestParamInfo<std::string>& one) { return one.param; });

}  // namespace failure_cases_test
}  // namespace plumb
