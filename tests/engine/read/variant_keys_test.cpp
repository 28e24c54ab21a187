#include <gtest/gtest.h>

#include "tests/engine/small_case.h"

namespace plumb {
namespace variant_keys_test {

CaseSource with_lines(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += lines;
  return source;
}

std::string variant(const std::string& lines) {
  return "[[study.variant]]\nname = \"a\"\n" + lines;
}

TEST(VariantKeys, EveryKeyIsRead) {
  const CaseSource source = with_lines(R"([[study.variant]]
name = "coarse"
set = { "method.step" = 0.25, cable.elements = 2, "probe.0.at" = "f / 10", method.newton_iterations = 20 }
outcome = "no-convergence"
says = "Newton"
reason = """
it is
coarse"""
[[study.variant.expect]]
quantity = "end-time"
value = 1.5
within = 0.25
source = "closed form"
[[study.variant.expect]]
quantity = "greatest mid.y"
value = -1
within = 1e-3
source = "elsewhere"
[[study.variant.expect]]
quantity = "distance"
from = "other"
value = 0
within = 1
source = "elsewhere"
[[study.variant]]
name = "other"
set = { cable.elements = 2, loads.gravity = [0, -9, 0], cable.strain = "engineering-material" }
)");
  const std::vector<VariantSpec> variants = load_case(source).spec.variants;
  ASSERT_EQ(variants.size(), 2U);
  const VariantSpec& coarse = variants[0];
  EXPECT_EQ(coarse.name, "coarse");
  EXPECT_EQ(coarse.overrides,
            (std::vector<std::string>{"method.step=0.25", "cable.elements=2", "probe.0.at=\"f / 10\"",
                                      "method.newton_iterations=20"}));
  EXPECT_EQ(coarse.outcome, "no-convergence");
  EXPECT_EQ(coarse.says, "Newton");
  EXPECT_EQ(coarse.reason, "it is coarse");
  ASSERT_EQ(coarse.expectations.size(), 3U);
  EXPECT_EQ(coarse.expectations[0], (ExpectationSpec{"end-time", "", 1.5, 0.25, "closed form"}));
  EXPECT_EQ(coarse.expectations[1], (ExpectationSpec{"greatest mid.y", "", -1, 1e-3, "elsewhere"}));
  EXPECT_EQ(coarse.expectations[2].from, "other");
  EXPECT_FALSE(variants[1].expects_anything());
}

TEST(VariantKeys, AVariantOfWhichFiguresAreExpectedIsToCompleteUnlessItSaysOtherwise) {
  const std::string figure =
      "[[study.variant.expect]]\nquantity = \"end-time\"\nvalue = 1\nwithin = 1\nsource = \"x\"\n";
  const auto outcome = [](const std::string& lines) {
    return load_case(with_lines(lines)).spec.variants.at(0).outcome;
  };
  EXPECT_EQ(outcome(variant("") + figure), "completed");
  EXPECT_EQ(outcome(variant("outcome = \"diverged\"\n") + figure), "diverged");
  EXPECT_EQ(outcome(variant("says = \"x\"\n") + figure), "") << "one that completes says nothing";
  EXPECT_EQ(outcome(variant("")), "") << "it is only shown";
}

TEST(VariantKeys, ACaseOfAVariantIsTheCaseWithItsOverrides) {
  CaseSource source = with_lines(variant(
      "set = { method.name = \"rk4\", method.step = 1e-3, loads.gravity = [0, -9, 0], parameters.f = 4 }\n"));
  source.overrides = {"cable.elements=3", "method.step=0.5"};
  const LoadedCase loaded = load_case(source);
  const LoadedCase run = load_variant(loaded.source, loaded.spec.variants.at(0));
  EXPECT_EQ(run.spec.method.name, "rk4");
  EXPECT_EQ(run.spec.method.step, 1e-3) << "the variant has the last word";
  EXPECT_EQ(run.spec.cable.elements, 3) << "overrides of the command line hold for every variant";
  EXPECT_EQ(run.spec.loads.gravity, Vec3(0, -9, 0));
  EXPECT_EQ(run.spec.parameters.at("g"), 8) << "expressions are evaluated anew";
  EXPECT_TRUE(run.spec.variants.empty());
}

TEST(VariantKeys, BadValuesAreRefusedWithPlaceAndVariant) {
  const std::string expect = "[[study.variant.expect]]\n";
  const std::string figure = expect + "quantity = \"end-time\"\nvalue = 1\nwithin = 1\nsource = \"x\"\n";
  for (const auto& [lines, says] : std::vector<std::pair<std::string, std::string>>{
           {"[[study.variant]]\n", "study.variant.0.name: missing; required: a name"},
           {"[[study.variant]]\nname = \"\"\n", "study.variant.0.name = \"\": must not be empty"},
           {"[[study.variant]]\nname = \"" + std::string(81, 'a') + "\"\n", "must be at most 80 bytes long"},
           {"[study]\nvariant = 1\n", "study.variant = 1: must be a list of tables"},
           {variant("") + variant(""), "study.variant.1.name = \"a\": is the name of another variant"},
           {variant("sett = {}\n"), "did you mean \"set\"?"},
           {variant("set = 1\n"), "study.variant.0.set = 1: must be a table"},
           {variant("set = { \"method.step\" = -1 }\n"),
            "study.variant.0.set.method.step = -1: must be a number greater than 0 (s), in the variant "
            "\"a\""},
           {variant("set = { method.stepp = 0.1 }\n"), "unknown key; did you mean \"step\"?, in the variant"},
           {variant("set = { probe.7.at = 0.1 }\n"), "is not one of them, in the variant \"a\""},
           {variant("set = { \"a b\" = 1 }\n"), "must be KEY=VALUE"},
           {variant("set = { time.end = 1e-4 }\n"), "the variant \"a\" is no valid case: "},
           {variant("set = { study.work_precision.points = 3 }\n"), "a variant has no studies"},
           {variant("outcome = \"unstabel\"\n"), "did you mean \"unstable\"?"},
           {variant("outcome = \"accurate\"\n"), "study.variant.0.outcome = \"accurate\": must be"},
           {variant("outcome = \"completed\"\nsays = \"x\"\n"), "a run that completes has no message"},
           {variant("reason = 1\n"), "study.variant.0.reason = 1: must be a string"},
           {variant(expect), "study.variant.0.expect.0.quantity: missing; required: what is expected"},
           {variant(with(figure, "end-time", "end-tme")), "did you mean \"end-time\"?"},
           {variant(with(figure, "end-time", "mid.w")), "did you mean \"mid.x\"?"},
           {variant(with(figure, "end-time", "greatest mid.w")), "must be end-time, "},
           {variant(with(figure, "end-time", "distance")), "missing; required: the name of the variant"},
           {variant(figure + "from = \"b\"\n"), "belongs to the quantity \"distance\" alone"},
           {variant(with(figure, "end-time", "distance") + "from = \"b\"\n"),
            "from = \"b\": is the name of no other variant"},
           {variant("set = { cable.elements = 3 }\n" + with(figure, "end-time", "distance") +
                    "from = \"b\"\n") +
                "[[study.variant]]\nname = \"b\"\n",
            "has 4 elements, this variant 3"},
           {variant(with(figure, "value = 1", "value = \"f\"")), "expect.0.value = \"f\": must be a number"},
           {variant(with(figure, "value = 1\n", "")), "expect.0.value: missing"},
           {variant(with(figure, "within = 1", "within = 0")),
            "within = 0: must be a number greater than 0 (in the unit of the quantity)"},
           {variant(with(figure, "\"x\"", "\"\"")), "must not be empty: where the value is from"},
           {variant(with(figure, "source = \"x\"\n", "")), "source: missing; required: where the value is"},
       }) {
    const CaseSource source = with_lines(lines);
    const std::string message = refusal(source);
    EXPECT_NE(message.find(says), std::string::npos) << lines << "\n" << message << "\n" << says;
    EXPECT_TRUE(message.starts_with(source.file.name + ":")) << message;
  }
}

TEST(VariantKeys, GrowthNeedsAProbe) {
  CaseSource source = small_case();
  source.file.text =
      "title = \"a\"\n[cable]\nlength = 1\narea = 1\ndensity = 1\nyoungs_modulus = 1\nelements = "
      "1\n[method]\n"
      "name = \"rk4\"\nstep = 0.1\n[time]\nend = 1\noutput_interval = 0.1\n" +
      variant(
          "[[study.variant.expect]]\nquantity = \"growth\"\nvalue = 1\nwithin = 1\nsource = \"closed "
          "form\"\n");
  EXPECT_NE(refusal(source).find("needs a [[probe]]"), std::string::npos) << refusal(source);
}

}  // namespace variant_keys_test
}  // namespace plumb
