#include <gtest/gtest.h>

#include <cmath>

#include "engine/integrate/method_info.h"
#include "engine/model/straight_frequency.h"
#include "engine/read/case_sections.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace stability_keys_test {

CaseSource case_with(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += "[study.stability]\n" + lines;
  return source;
}

StabilitySpec read_with(const std::string& lines) {
  return load_case(case_with(lines)).spec.stability.value();
}

TEST(StabilityKeys, AnEmptyTableGivesTheDefaultsThatACaseWithoutOneHas) {
  const Case without = load_case(small_case()).spec;
  EXPECT_FALSE(without.stability.has_value());
  const StabilitySpec defaults = stability_of(without);
  EXPECT_EQ(read_with(""), defaults);
  EXPECT_EQ(defaults.parameter, "f");
  EXPECT_EQ(defaults.parameter_values, (std::vector<double>{1, 2, 3, 5, 7, 10, 14, 20}));
  EXPECT_EQ(defaults.elements, (std::vector<int>{1, 2, 4, 8, 16, 32}));
  EXPECT_EQ(defaults.durations, (std::vector<double>{0.5, 1, 2})) << "none below the output interval";
  EXPECT_GE(defaults.methods.size(), 16U);
  EXPECT_EQ(defaults.limit_methods, (std::vector<std::string>{"velocity-verlet", "rk4"}));
  EXPECT_EQ(defaults.tolerance, 0.02);
  const double limit = 2 / straight_frequency(without.cable);
  EXPECT_LT(defaults.smallest_step, limit);
  EXPECT_GT(defaults.largest_step, 10 * limit);
}

TEST(StabilityKeys, ACaseWithoutThatParameterVariesNone) {
  CaseSource source = small_case();
  source.file.text =
      with(source.file.text, "[parameters]\nf = 5\ng = \"2 * f\"", "[parameters]\nF = 5\ng = \"2 * F\"");
  source.file.text = with(source.file.text, "\"1e-6 * f^2\"", "25e-6");
  const StabilitySpec spec = stability_of(load_case(source).spec);
  EXPECT_EQ(spec.parameter, "");
  EXPECT_TRUE(spec.parameter_values.empty());
  EXPECT_EQ(read_with("parameter = \"\"").parameter_values.size(), 0U);
}

TEST(StabilityKeys, EveryKeyIsRead) {
  const StabilitySpec spec = read_with(R"(parameter = "g"
parameter_values = [20, 5, "2*f", 5]
elements = [8, 2, 8]
durations = [4, 0.5, "2/2"]
methods = ["rk4", "velocity-verlet"]
largest_step = 0.125
smallest_step = 1e-4
loosest_tolerance = 0.1
tightest_tolerance = 1e-6
steps = 3
tolerance = 0.25
time_limit = 0.5
limit_methods = ["generalized-alpha"]
energy_step = 0.0625
)");
  EXPECT_EQ(spec.parameter, "g");
  EXPECT_EQ(spec.parameter_values, (std::vector<double>{5, 10, 20}));
  EXPECT_EQ(spec.elements, (std::vector<int>{2, 4, 8})) << "with the case's own";
  EXPECT_EQ(spec.durations, (std::vector<double>{0.5, 1, 4})) << "longer ones than the case's are allowed";
  EXPECT_EQ(spec.methods, (std::vector<std::string>{"velocity-verlet", "rk4"})) << "in the order of the list";
  EXPECT_EQ(spec.largest_step, 0.125);
  EXPECT_EQ(spec.smallest_step, 1e-4);
  EXPECT_EQ(spec.loosest_tolerance, 0.1);
  EXPECT_EQ(spec.tightest_tolerance, 1e-6);
  EXPECT_EQ(spec.steps, 3);
  EXPECT_EQ(spec.tolerance, 0.25);
  EXPECT_EQ(spec.time_limit, 0.5);
  EXPECT_EQ(spec.limit_methods, (std::vector<std::string>{"generalized-alpha"}));
  EXPECT_EQ(spec.energy_step, 0.0625);
}

TEST(StabilityKeys, AnOverrideSetsThem) {
  CaseSource source = small_case();
  source.overrides = {"study.stability.steps=5"};
  EXPECT_EQ(load_case(source).spec.stability.value().steps, 5);
}

TEST(StabilityKeys, AStudySuitsACaseThatIsShorterOrHasRarerOutputs) {
  CaseSource source =
      case_with("durations = [0.5, 1, 2]\nlargest_step = 0.25\nsmallest_step = 0.1\nenergy_step = 0.2\n");
  source.overrides = {"time.end=0.05", "time.output_interval=0.01"};
  const StabilitySpec shorter = load_case(source).spec.stability.value();
  EXPECT_EQ(shorter.largest_step, 0.05);
  EXPECT_EQ(shorter.energy_step, 0.05);
  EXPECT_LT(shorter.smallest_step, shorter.largest_step);
  source.overrides = {"time.output_interval=1"};
  EXPECT_EQ(load_case(source).spec.stability->durations, (std::vector<double>{1, 2}));
}

TEST(StabilityKeys, BadValuesAreRefusedWithWhatIsAllowed) {
  for (const auto& [lines, says] : std::vector<std::pair<std::string, std::string>>{
           {"parameter = 1", "parameter = 1: must be a string"},
           {"parameter = \"h\"", "parameter = \"h\": must be one of [parameters]"},
           {"parameter = \"g\"", "parameter = \"g\": must have its values in parameter_values"},
           {"parameter_values = 3", "parameter_values = 3: must be a list of numbers"},
           {"parameter_values = []", "parameter_values = []: must be a list of numbers, found none"},
           {"parameter_values = [1, \"x\"]", "parameter_values.1 = \"x\": "},
           {"parameter = \"\"\nparameter_values = [1]",
            "parameter_values = [1]: must be left out without a parameter to vary"},
           {"elements = [0]", "elements.0 = 0: must be a whole number from 1 to 1000000"},
           {"elements = []", "elements = []: must be a list of whole numbers, found none"},
           {"durations = []", "durations = []: must be a list of numbers, found none"},
           {"durations = [0]", "durations.0 = 0: must be a number greater than 0 (s)"},
           {"methods = [\"rk5\"]", "; did you mean \"rk4\"?"},
           {"methods = []", "methods = []: must be a list of strings, found none"},
           {"limit_methods = [\"cvode-bdf\"]", "limit_methods.0 = \"cvode-bdf\": must be "},
           {"largest_step = 0", "largest_step = 0: must be a number greater than 0 (s)"},
           {"smallest_step = -1", "smallest_step = -1: must be a number greater than 0 (s)"},
           {"largest_step = 0.1\nsmallest_step = 0.1",
            "smallest_step = 0.1: must be less than the largest step, 0.1 (s)"},
           {"smallest_step = 1e-10", "smallest_step = 1e-10: gives 2e+10 steps until 2 s"},
           {"loosest_tolerance = 1",
            "loosest_tolerance = 1: must be a number greater than 0 and less than 1"},
           {"tightest_tolerance = 0", "tightest_tolerance = 0: must be"},
           {"tightest_tolerance = 0.1",
            "tightest_tolerance = 0.1: must be less than the loosest tolerance, 0.01"},
           {"steps = 2", "steps = 2: must be a whole number from 3 to 60"},
           {"steps = 61", "steps = 61: must be a whole number from 3 to 60"},
           {"tolerance = 0", "tolerance = 0: must be a number greater than 0 (m)"},
           {"tolerance = 1e9", "tolerance = 1e9: must be at most the length of the cable, "},
           {"time_limit = 0", "time_limit = 0: must be a number greater than 0 (s)"},
           {"energy_step = 0", "energy_step = 0: must be a number greater than 0 (s)"},
           {"energy_step = 1e-10", "energy_step = 1e-10: gives 2e+10 steps until 2 s"},
           {"stepss = 3", "stepss = 3: unknown key; did you mean \"steps\"?"},
       }) {
    const std::string message = refusal(case_with(lines));
    EXPECT_NE(message.find(says), std::string::npos) << lines << "\n" << message << "\n" << says;
    EXPECT_NE(message.find("study.stability."), std::string::npos) << message;
  }
}

}  // namespace stability_keys_test
}  // namespace plumb
