#include <gtest/gtest.h>

#include "engine/read/changed_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace budget_keys_test {

CaseSource with_lines(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += lines;
  return source;
}

const std::string start = "[error_budget]\nreference = \"book\"\n";

std::string item(const std::string& lines) {
  return "[[error_budget.item]]\n" + lines;
}

const std::string mesh = item("name = \"mesh\"\nset = { cable.elements = 8 }\n");

TEST(BudgetKeys, EveryKeyIsRead) {
  const auto spec = load_case(with_lines(R"([error_budget]
reference = "book"
interval = 0.125
set = { method = { name = "linearly-implicit-euler", step = 1e-2 }, "cable.elements" = 2 }
[[error_budget.item]]
name = "mesh"
set = { cable.elements = 8 }
reason = """
finer
mesh"""
[[error_budget.item]]
name = "time"
set = { method.name = "rk4", method.step = 1e-3 }
together = false
)"))
                        .spec.error_budget;
  ASSERT_TRUE(spec);
  const BudgetSpec expected{
      "book",
      {"method.name=\"linearly-implicit-euler\"", "method.step=1e-2", "cable.elements=2"},
      0.125,
      {{"mesh", {"cable.elements=8"}, "finer mesh", true},
       {"time", {"method.name=\"rk4\"", "method.step=1e-3"}, "", false}}};
  EXPECT_EQ(*spec, expected);
}

TEST(BudgetKeys, AMethodTakesThePlaceOfAllThatWasSetOfAnother) {
  EXPECT_EQ(
      joined_overrides({"method.rtol=1e-3", "cable.elements=2"}, {"method.name=\"rk4\"", "method.step=1"}),
      (std::vector<std::string>{"cable.elements=2", "method.name=\"rk4\"", "method.step=1"}));
  EXPECT_EQ(joined_overrides({"method.name=\"rk4\"", "method.step=1"}, {"method.step=2"}),
            (std::vector<std::string>{"method.name=\"rk4\"", "method.step=1", "method.step=2"}));
  CaseSource source =
      with_lines(start + "set = { method = { name = \"linearly-implicit-euler\", step = 1e-2 } }\n" + mesh);
  source.overrides = {"method.spectral_radius=0.7"};
  EXPECT_EQ(refusal(source), "accepted") << "what the command line says of the case's own method";
}

TEST(BudgetKeys, BadValuesAreRefusedWithPlaceAndWhatIsAllowed) {
  ASSERT_EQ(refusal(with_lines(start + mesh)), "accepted");
  EXPECT_EQ(load_case(with_lines(start + "interval = 3\n" + mesh)).spec.error_budget->interval, 2)
      << "the end of the run";
  for (const auto& [lines, says] : std::vector<std::pair<std::string, std::string>>{
           {"[error_budget]\n", "error_budget.reference: missing; required: the name of a [[reference]]"},
           {"[error_budget]\nreference = \"bok\"\n" + mesh,
            "error_budget.reference = \"bok\": is the name of no [[reference]]; did you mean \"book\"?"},
           {start, "must have at least one table [[error_budget.item]]"},
           {start + "item = 1\n", "error_budget.item = 1: must be a list of tables"},
           {start + "intervall = 1\n" + mesh, "did you mean \"interval\"?"},
           {start + "interval = 0\n" + mesh, "interval = 0: must be a number greater than 0 (s)"},
           {start + "interval = 1e-7\n" + mesh, "must give at most 1,000,000 times"},
           {start + "set = 1\n" + mesh, "error_budget.set = 1: must be a table"},
           {start + "set = { method.step = -1 }\n" + mesh,
            "error_budget.set.method.step = -1: must be a number greater than 0 (s), in the computation "
            "behind "
            "the reference"},
           {start + "set = { time.end = 1 }\n" + mesh,
            "error_budget.set.time.end = 1: is no part of how the motion is computed"},
           {start + item("set = { cable.elements = 8 }\n"), "error_budget.item.0.name: missing"},
           {start + item("name = \"" + std::string(81, 'a') + "\"\nset = { cable.elements = 8 }\n"),
            "must be at most 80 bytes long"},
           {start + mesh + mesh, "error_budget.item.1.name = \"mesh\": is the name of another item"},
           {start + item("name = \"a\"\n"), "must change at least one key"},
           {start + item("name = \"a\"\nset = { cable.elments = 8 }\n"),
            "unknown key; did you mean \"elements\"?, in the item \"a\""},
           {start + item("name = \"a\"\nset = { probe.0.at = 0.1 }\n"),
            "is no part of how the motion is computed"},
           {start + item("name = \"a\"\nset = { error_budget.interval = 1 }\n"),
            "is no part of how the motion"},
           {start + item("name = \"a\"\nset = { cable.elements = 8 }\ntogether = 1\n"),
            "together = 1: must be"},
           {start + item("name = \"a\"\nset = { cable.elements = 8 }\nreason = 1\n"),
            "reason = 1: must be a string"},
           {start + mesh + item("name = \"finer\"\nset = { cable.elements = 16 }\n"),
            "error_budget.item.1.set.cable.elements = 16: is set by another item already"},
           {start + item("name = \"a\"\nset = { method = { name = \"statics\" } }\n"),
            "the item \"a\" is no valid case: "},
       }) {
    const CaseSource source = with_lines(lines);
    const std::string message = refusal(source);
    EXPECT_NE(message.find(says), std::string::npos) << lines << "\n" << message << "\n" << says;
    EXPECT_TRUE(message.starts_with(source.file.name + ":")) << message;
  }
  EXPECT_EQ(refusal(with_lines(start + mesh +
                               item("name = \"finer\"\nset = { cable.elements = 16 }\n"
                                    "together = false\n"))),
            "accepted");
}

}  // namespace budget_keys_test
}  // namespace plumb
