#include <gtest/gtest.h>

#include "engine/study/sweep/run_sweep.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace sweep_keys_test {

CaseSource with_sweep(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += "[study.sweep]\n" + lines;
  return source;
}

TEST(SweepKeys, AnEmptyTableGivesTheDefaultsThatACaseWithoutOneHas) {
  const Case without = load_case(small_case()).spec;
  EXPECT_FALSE(without.sweep.has_value());
  const SweepSpec defaults = sweep_of(without);
  EXPECT_EQ(load_case(with_sweep("")).spec.sweep, defaults);
  EXPECT_EQ(defaults, (SweepSpec{2000, 1, 2e-3, 0.5})) << "the tolerance is a thousandth of the length";
}

TEST(SweepKeys, EveryKeyIsRead) {
  EXPECT_EQ(
      load_case(with_sweep("cases = \"20 * f\"\nseed = 123456789012\ntolerance = 1e-4\ntime_limit = 0.25\n"))
          .spec.sweep,
      (SweepSpec{100, 123456789012, 1e-4, 0.25}));
}

TEST(SweepKeys, BadValuesAreRefusedWithWhatIsAllowed) {
  for (const auto& [lines, says] : std::vector<std::pair<std::string, std::string>>{
           {"cases = 0", "cases = 0: must be a whole number from 1 to 1000000"},
           {"cases = 1000001", "cases = 1000001: must be a whole number from 1 to 1000000"},
           {"cases = 2.5", "cases = 2.5: must be a whole number from 1 to 1000000"},
           {"seed = -1", "seed = -1: must be a whole number from 0 to 1000000000000000"},
           {"seed = 0.5", "seed = 0.5: must be a whole number from 0 to 1000000000000000"},
           {"seed = 2e15", "seed = 2e15: must be a whole number from 0 to 1000000000000000"},
           {"tolerance = 0", "tolerance = 0: must be a number greater than 0 (m)"},
           {"tolerance = inf", "tolerance = inf: must be finite: a number greater than 0 (m)"},
           {"tolerance = 2.1", "tolerance = 2.1: must be at most the length of the cable, 2 m"},
           {"time_limit = 0", "time_limit = 0: must be a number greater than 0 (s)"},
           {"time_limit = nan", "time_limit = nan: must be finite: a number greater than 0 (s)"},
           {"seeds = 1", "seeds = 1: unknown key; did you mean \"seed\"?"},
       }) {
    const std::string message = refusal(with_sweep(lines));
    EXPECT_NE(message.find("case.toml:71:"), std::string::npos) << message;
    EXPECT_NE(message.find("study.sweep." + says), std::string::npos) << message << "\n" << says;
  }
}

}  // namespace sweep_keys_test
}  // namespace plumb
