#include <gtest/gtest.h>

#include "engine/read/changed_case.h"
#include "engine/read/uncertain_keys.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace uncertainty_keys_test {

CaseSource with_lines(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += lines;
  return source;
}

std::string input(const std::string& lines) {
  return "[uncertainty]\nsamples = 10\n[[uncertainty.input]]\n" + lines;
}

void expect_uncertainty_refused(const std::vector<std::pair<std::string, std::string>>& faults) {
  for (const auto& [lines, says] : faults) {
    const CaseSource source = with_lines(lines);
    const std::string message = refusal(source);
    EXPECT_NE(message.find(says), std::string::npos) << lines << "\n" << message << "\n" << says;
    EXPECT_TRUE(message.starts_with(source.file.name + ":")) << message;
  }
}

TEST(UncertaintyKeys, EveryKeyIsRead) {
  const auto spec = load_case(with_lines(R"([uncertainty]
numerical = false
samples = 40
seed = 12
[[uncertainty.input]]
key = "cable.density"
spread = 0.02
relative = true
source = """
a data
sheet"""
[[uncertainty.input]]
key = "loads.gravity.1"
distribution = "uniform"
spread = "f / 500"
source = "a map"
)"))
                        .spec.uncertainty;
  ASSERT_TRUE(spec);
  const UncertaintySpec expected{false,
                                 40,
                                 12,
                                 {{"cable.density", Distribution::normal, 0.02, true, "a data sheet"},
                                  {"loads.gravity.1", Distribution::uniform, 0.01, false, "a map"}}};
  EXPECT_EQ(*spec, expected);
}

TEST(UncertaintyKeys, AnEmptyTableAsksForTheNumericalPartAlone) {
  const auto spec = load_case(with_lines("[uncertainty]\n")).spec.uncertainty;
  ASSERT_TRUE(spec);
  EXPECT_TRUE(spec->numerical);
  EXPECT_EQ(spec->samples, 0);
  EXPECT_FALSE(load_case(small_case()).spec.uncertainty) << "nothing is asked for without it";
}

TEST(UncertaintyKeys, BadValuesAreRefusedWithPlaceAndWhatIsAllowed) {
  const std::string good = "key = \"cable.density\"\nspread = 1\nsource = \"x\"\n";
  ASSERT_EQ(refusal(with_lines(input(good))), "accepted");
  expect_uncertainty_refused({
      {"uncertainty = 1\n", "unknown key"},
      {"[uncertainty]\nnumerical = 1\n", "uncertainty.numerical = 1: must be"},
      {"[uncertainty]\nsamples = -1\n", "uncertainty.samples = -1: must be a whole number from 0 to 10000"},
      {"[uncertainty]\nsamples = 10001\n", "uncertainty.samples = 10001: must be"},
      {"[uncertainty]\nsamples = 1\n", "must be 0 or at least 2: one sample has no spread"},
      {"[uncertainty]\nsamples = 10\n", "samples = 10: needs an [[uncertainty.input]] to sample"},
      {"[uncertainty]\nseed = -1\n", "uncertainty.seed = -1: must be"},
      {"[uncertainty]\nseed = 0.5\n", "uncertainty.seed = 0.5: must be a whole number"},
      {"[uncertainty]\nsample = 3\n", "did you mean \"samples\"?"},
      {"[uncertainty]\ninput = 3\n", "uncertainty.input = 3: must be a list of tables"},
      {input(""), "uncertainty.input.0.key: missing; required: the key of an uncertain number"},
      {input(with(good, "density", "densty")),
       "is no number of the case that can be uncertain; did you mean "},
      {input(with(good, "cable.density", "cable.elements")),
       "is no number of the case that can be uncertain"},
      {input(with(good, "cable.density", "loads.gravity.3")), "is no number of the case"},
      {input(with(good, "spread = 1", "spread = 0")), "spread = 0: must be a number greater than 0"},
      {input(with(good, "spread = 1\n", "")), "uncertainty.input.0.spread: missing"},
      {input(with(good, "\"x\"", "\"\"")), "must not be empty: where the spread is from"},
      {input(with(good, "source = \"x\"\n", "")), "source: missing; required: where the spread is from"},
      {input(good + "distribution = \"norml\"\n"), "did you mean \"normal\"?"},
      {input(good + "relative = \"yes\"\n"), "relative = \"yes\": must be"},
      {input(with(good, "cable.density", "loads.gravity.0") + "relative = true\n"),
       "loads.gravity.0 is 0, which has no share"},
      {input(good + "[[uncertainty.input]]\n" + good),
       "uncertainty.input.1.key = \"cable.density\": is the key of another"},
  });
}

TEST(UncertainKeys, OverridesGiveTheCaseThoseValues) {
  const LoadedCase loaded = load_case(small_case());
  const std::vector<std::string> keys{"parameters.f", "loads.end_force.2", "start.direction.1",
                                      "cable.length"};
  const std::vector<double> values{4, 0.25, 0.3, 2.5};
  const Case changed = load_changed(loaded.source, uncertain_overrides(loaded.spec, keys, values)).spec;
  EXPECT_EQ(changed.parameters.at("f"), 4);
  EXPECT_EQ(changed.parameters.at("g"), 8) << "expressions are evaluated anew";
  EXPECT_EQ(changed.loads.end_force, Vec3(0, 0, 0.25)) << "the file does not name it";
  EXPECT_NEAR(changed.start.direction[1], 0.3 / std::sqrt(1.09), 1e-15);
  EXPECT_EQ(changed.cable.length, 2.5);
  EXPECT_EQ(uncertain_value(loaded.spec, "loads.gravity.1"), -9.81);
  EXPECT_FALSE(uncertain_value(loaded.spec, "cable.elements"));
}

}  // namespace uncertainty_keys_test
}  // namespace plumb
