#include <gtest/gtest.h>

#include <algorithm>

#include "engine/read/case_sections.h"
#include "engine/read/changed_case.h"
#include "engine/read/model_numbers.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace sensitivity_keys_test {

CaseSource with_lines(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += lines;
  return source;
}

TEST(SensitivityKeys, EveryKeyIsRead) {
  const auto spec = load_case(with_lines(R"([sensitivity]
numbers = ["loads.gravity.1", "cable.density"]
blunders = ["late-output", "chain"]
largest = 4
time_limit = 2.5
)"))
                        .spec.sensitivity;
  ASSERT_TRUE(spec);
  const SensitivitySpec expected{
      {"cable.density", "loads.gravity.1"}, {Blunder::chain, Blunder::late_output}, 4, 2.5};
  EXPECT_EQ(*spec, expected) << "in the order of the numbers and blunders there are";
}

TEST(SensitivityKeys, AnEmptyTableAsksForAll) {
  const Case spec = load_case(with_lines("[sensitivity]\n")).spec;
  ASSERT_TRUE(spec.sensitivity);
  EXPECT_EQ(*spec.sensitivity, default_sensitivity(spec));
  EXPECT_EQ(spec.sensitivity->numbers,
            (std::vector<std::string>{"cable.length", "cable.density", "cable.youngs_modulus",
                                      "cable.axial_stiffness", "cable.bending_stiffness",
                                      "start.angular_velocity.1", "loads.gravity.1"}));
  EXPECT_EQ(spec.sensitivity->blunders.size(), 12U);
  EXPECT_FALSE(load_case(small_case()).spec.sensitivity) << "nothing is asked for without it";
}

TEST(SensitivityKeys, BadValuesAreRefusedWithPlaceAndWhatIsAllowed) {
  const std::string start = "[sensitivity]\n";
  const std::vector<std::pair<std::string, std::string>> faults{
      {"sensitivity = 1\n", "unknown key"},
      {start + "numbers = []\n", "sensitivity.numbers = []: must"},
      {start + "numbers = 3\n", "sensitivity.numbers = 3: must be a list of strings"},
      {start + "numbers = [\"cable.densty\"]\n", "did you mean \"cable.density\"?"},
      {start + "numbers = [\"loads.gravity.0\"]\n", "sensitivity.numbers.0 = \"loads.gravity.0\": must be"},
      {start + "numbers = [\"cable.length\", \"cable.length\"]\n", "must not name the same twice"},
      {start + "blunders = [\"chan\"]\n", "did you mean \"chain\"?"},
      {start + "blunders = [\"chain\", \"chain\"]\n", "must not name the same twice"},
      {start + "largest = 1\n", "sensitivity.largest = 1: must be a number from 1.01 to"},
      {start + "largest = 2e6\n", "sensitivity.largest = 2e6: must be a number from 1.01 to"},
      {start + "time_limit = 0\n", "sensitivity.time_limit = 0: must be a number greater than 0 (s)"},
      {start + "number = [\"cable.length\"]\n", "did you mean \"numbers\"?"},
      {"[[study.variant]]\nname = \"a\"\nset = { sensitivity.largest = 2 }\n", "a variant has no studies"},
      {"[error_budget]\nreference = \"book\"\n[[error_budget.item]]\nname = \"a\"\nset = { "
       "sensitivity.largest = 2 }\n",
       "is no part of how the motion is computed"},
  };
  for (const auto& [lines, says] : faults) {
    const CaseSource source = with_lines(lines);
    const std::string message = refusal(source);
    EXPECT_NE(message.find(says), std::string::npos) << lines << "\n" << message << "\n" << says;
    EXPECT_TRUE(message.starts_with(source.file.name + ":")) << message;
  }
}

/// The small case with every number of a model there is.
CaseSource whole_model() {
  CaseSource source = small_case();
  std::string& text = source.file.text;
  text = with(text, "slope_rates = \"rigid\"", "slope_rates = \"rigid\"\nstretch = 1.25\naxial_speed = 0.5");
  text = with(text, "last = \"free\"", "last = \"pinned\"\nlast_motion = { y = \"f * t^2\" }");
  text += R"([[load]]
kind = "force"
at = 0.5
value = [0, 2, -1]
[[mass]]
at = 0.5
mass = 0.25
[damping]
mass = 0.5
material = 1e-3
)";
  return source;
}

TEST(ModelNumbers, EachAloneIsMadeSoManyTimesAsLarge) {
  const LoadedCase loaded = load_case(whole_model());
  const Case& was = loaded.spec;
  const auto changed = [&](const std::string& key) {
    return load_changed(loaded.source, scaled(was, key, 3)).spec;
  };
  std::vector<std::string> keys;
  for (const ModelNumber& number : model_numbers(was)) {
    keys.push_back(number.key);
    EXPECT_NE(changed(number.key), load_changed(loaded.source, {}).spec) << number.key;
  }
  for (const char* key : {"start.stretch", "start.axial_speed", "supports.last_motion.y", "load.0.value",
                          "mass.0.mass", "damping.mass", "damping.material"})
    EXPECT_NE(std::find(keys.begin(), keys.end(), key), keys.end()) << key;

  const CableSpec axial = changed("cable.axial_stiffness").cable,
                  bending = changed("cable.bending_stiffness").cable,
                  both = changed("cable.youngs_modulus").cable;
  const double EA = was.cable.youngs_modulus * was.cable.area,
               EI = was.cable.youngs_modulus * was.cable.second_moment;
  EXPECT_DOUBLE_EQ(axial.youngs_modulus * axial.area, 3 * EA);
  EXPECT_DOUBLE_EQ(axial.youngs_modulus * axial.second_moment, EI);
  EXPECT_DOUBLE_EQ(bending.youngs_modulus * bending.area, EA);
  EXPECT_DOUBLE_EQ(bending.youngs_modulus * bending.second_moment, 3 * EI);
  EXPECT_DOUBLE_EQ(both.youngs_modulus * both.second_moment, 3 * EI);
  EXPECT_DOUBLE_EQ(both.youngs_modulus * both.area, 3 * EA);
  EXPECT_DOUBLE_EQ(changed("cable.density").cable.density, 3 * was.cable.density);
  EXPECT_DOUBLE_EQ(changed("start.stretch").start.stretch, 1.75) << "what is beyond 1";
  EXPECT_EQ(changed("supports.last_motion.y").supports.last_motion->y, "3 * (f * t^2)");
  EXPECT_EQ(changed("load.0.value").loads.applied.at(0).value, Vec3(0, 6, -3));
  EXPECT_EQ(changed("mass.0.mass").masses.at(0).mass, 0.75);
  EXPECT_EQ(changed("loads.gravity.1").loads.gravity, 3 * was.loads.gravity);
}

TEST(ModelNumbers, OfAChainAreWithoutBending) {
  const Case spec = load_changed(small_case(), {"cable.model=chain"}).spec;
  for (const ModelNumber& number : model_numbers(spec)) {
    EXPECT_NE(number.key, "cable.bending_stiffness");
    EXPECT_NE(number.key, "cable.youngs_modulus") << "which is the axial stiffness there";
  }
}

}  // namespace sensitivity_keys_test
}  // namespace plumb
