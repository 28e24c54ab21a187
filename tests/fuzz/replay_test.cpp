#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/file_text.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace replay_test {

namespace fs = std::filesystem;

class KeptInputs : public testing::TestWithParam<Target> {};

TEST_P(KeptInputs, KeepEveryPromise) {
  const fs::path folder = fs::path(PLUMB_SOURCE_DIR "/tests/fuzz/corpus") / GetParam().name;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    try {
      GetParam().feed(read_whole_file(file.string()));
    } catch (const std::exception& error) {
      ADD_FAILURE() << file << ": " << error.what();
    }
  }
}

TEST_P(KeptInputs, BeginWithThoseThatAreAccepted) {
  for (const std::string& seed : GetParam().seeds())
    EXPECT_TRUE(GetParam().feed(seed)) << last_refusal() << "\n" << seed.substr(0, 200);
}

INSTANTIATE_TEST_SUITE_P(Of, KeptInputs, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(Promises, AreBrokenByWhatTheyForbid) {
  EXPECT_THROW(promise(false, "never"), BrokenPromise);
  EXPECT_THROW(promise_finite({{1, std::numeric_limits<double>::quiet_NaN()}}, "x"), BrokenPromise);
  EXPECT_THROW(promise_message("two\nlines"), BrokenPromise);
  EXPECT_THROW(promise_message(""), BrokenPromise);
  EXPECT_THROW(promise_message(std::string(100000, 'x')), BrokenPromise);
  const auto refuse = [] { throw std::invalid_argument("one line"); };
  EXPECT_FALSE(reads<std::invalid_argument>(refuse));
  EXPECT_THROW(reads<std::out_of_range>(refuse), std::invalid_argument) << "it may refuse otherwise only";
}

}  // namespace replay_test
}  // namespace plumb::fuzz
