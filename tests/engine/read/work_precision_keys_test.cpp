#include <gtest/gtest.h>

#include <algorithm>

#include "engine/integrate/method_info.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace work_precision_keys_test {

std::string refused_with(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += "[study.work_precision]\n" + lines;
  return refusal(source);
}

WorkPrecisionSpec read_with(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += "[study.work_precision]\n" + lines;
  return load_case(source).spec.work_precision.value();
}

TEST(WorkPrecisionKeys, AnEmptyTableGivesTheDefaultsThatACaseWithoutOneHas) {
  const Case without = load_case(small_case()).spec;
  EXPECT_FALSE(without.work_precision.has_value());
  const WorkPrecisionSpec defaults = work_precision_of(without);
  EXPECT_EQ(read_with(""), defaults);
  EXPECT_EQ(defaults.end, 2);
  for (const MethodInfo& info : method_infos())
    EXPECT_EQ(std::ranges::count(defaults.full.methods, info.name), info.dynamic ? 1 : 0)
        << info.name << ": all but those without motion";
  EXPECT_GT(defaults.largest_step, defaults.smallest_step);
  EXPECT_LT(defaults.quick.time_limit, defaults.full.time_limit);
}

TEST(WorkPrecisionKeys, EveryKeyIsRead) {
  const WorkPrecisionSpec spec = read_with(R"(end = 1
elements = [16, 8, "2*f", 8]
methods = ["generalized-alpha", "rk4"]
points = 3
largest_step = 0.1
smallest_step = 0.01
loosest_tolerance = 1e-2
tightest_tolerance = 1e-4
repeats = 50
time_limit = 0.5
[study.work_precision.quick]
elements = [5]
methods = ["rk4"]
points = 20
repeats = 1
time_limit = 0.125
)");
  EXPECT_EQ(spec.end, 1);
  EXPECT_EQ(spec.full.elements, (std::vector<int>{4, 8, 10, 16})) << "rising, once each, with the case's own";
  EXPECT_EQ(spec.full.methods.size(), 2U);
  EXPECT_EQ(spec.full.points, 3);
  EXPECT_EQ(spec.largest_step, 0.1);
  EXPECT_EQ(spec.smallest_step, 0.01);
  EXPECT_EQ(spec.loosest_tolerance, 1e-2);
  EXPECT_EQ(spec.tightest_tolerance, 1e-4);
  EXPECT_EQ(spec.full.repeats, 50);
  EXPECT_EQ(spec.full.time_limit, 0.5);
  EXPECT_EQ(spec.quick.elements, (std::vector<int>{4, 5}));
  EXPECT_EQ(spec.quick.methods, (std::vector<std::string>{"rk4"}));
  EXPECT_EQ(spec.quick.points, 20);
  EXPECT_EQ(spec.quick.time_limit, 0.125);
}

TEST(WorkPrecisionKeys, AnOverrideSetsThem) {
  CaseSource source = small_case();
  source.overrides = {"study.work_precision.points=3", "study.work_precision.quick.elements=[6]"};
  const Case spec = load_case(source).spec;
  ASSERT_TRUE(spec.work_precision.has_value());
  EXPECT_EQ(spec.work_precision->full.points, 3);
  EXPECT_EQ(spec.work_precision->quick.elements, (std::vector<int>{4, 6}));
}

TEST(WorkPrecisionKeys, AStudyIsNoLongerThanItsCase) {
  EXPECT_EQ(read_with("end = 5").end, 2);
}

TEST(WorkPrecisionKeys, BadValuesAreRefusedWithWhatIsAllowed) {
  const std::string key = "study.work_precision.";
  for (const auto& [lines, says] : std::vector<std::pair<std::string, std::string>>{
           {"end = 0", "end = 0: must be a number greater than 0 (s)"},
           {"end = 0.25", "end = 0.25: must be at least the output interval, 0.5 (s)"},
           {"elements = 4", "elements = 4: must be a list of whole numbers, found a whole number"},
           {"elements = []", "elements = []: must be a list of whole numbers, found none"},
           {"elements = [4, 0]", "elements.1 = 0: must be a whole number from 1 to 1000000"},
           {"elements = [4.5]", "elements.0 = 4.5: must be a whole number from 1 to 1000000"},
           {"methods = \"rk4\"", "methods = \"rk4\": must be a list of strings, found a string"},
           {"methods = []", "methods = []: must be a list of strings, found none"},
           {"methods = [\"rk5\"]", "; did you mean \"rk4\"?"},
           {"methods = [4]", "methods.0 = 4: must be "},
           {"points = 2", "points = 2: must be a whole number from 3 to 20"},
           {"points = 21", "points = 21: must be a whole number from 3 to 20"},
           {"largest_step = 0", "largest_step = 0: must be a number greater than 0 (s)"},
           {"largest_step = 3", "largest_step = 3: must be at most the end of the study, 2 (s)"},
           {"smallest_step = -1", "smallest_step = -1: must be a number greater than 0 (s)"},
           {"smallest_step = 1", "smallest_step = 1: must be less than the largest step, 0.04 (s)"},
           {"smallest_step = 1e-10", "smallest_step = 1e-10: gives 2e+10 steps"},
           {"loosest_tolerance = 1",
            "loosest_tolerance = 1: must be a number greater than 0 and less than 1"},
           {"tightest_tolerance = 0", "tightest_tolerance = 0: must be"},
           {"tightest_tolerance = 0.1",
            "tightest_tolerance = 0.1: must be less than the loosest tolerance, 0.001"},
           {"repeats = 0", "repeats = 0: must be a whole number from 1 to 50"},
           {"repeats = 51", "repeats = 51: must be a whole number from 1 to 50"},
           {"time_limit = 0", "time_limit = 0: must be a number greater than 0 (s)"},
           {"quick = 1", "quick = 1: must be a table"},
           {"[study.work_precision.quick]\npoints = 1",
            "quick.points = 1: must be a whole number from 3 to 20"},
           {"pionts = 3", "pionts = 3: unknown key; did you mean \"points\"?"},
           {"[study.work_precision.quick]\nend = 1", "quick.end = 1: unknown key"},
       }) {
    const std::string message = refused_with(lines);
    EXPECT_NE(message.find(says), std::string::npos) << lines << "\n" << message << "\n" << says;
    EXPECT_NE(message.find(key), std::string::npos) << message;
  }
}

}  // namespace work_precision_keys_test
}  // namespace plumb
