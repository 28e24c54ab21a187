#include <gtest/gtest.h>

#include "engine/case/case_source.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace override_test {

LoadedCase small_set(const std::vector<std::string>& overrides) {
  CaseSource source = small_case();
  source.overrides = overrides;
  return load_case(source);
}

TEST(Override, ReplacesNumbersListsWordsAndExpressions) {
  EXPECT_EQ(small_set({"cable.elements=8"}).spec.cable.elements, 8);
  EXPECT_EQ(small_set({"loads.gravity=[0,-9.8,0]"}).spec.loads.gravity, Vec3(0, -9.8, 0));
  EXPECT_EQ(small_set({"cable.strain=engineering-material"}).spec.cable.strain,
            StrainModel::engineering_material);
  EXPECT_EQ(small_set({"cable.strain=\"engineering-material\""}).spec.cable.strain,
            StrainModel::engineering_material);
  EXPECT_DOUBLE_EQ(small_set({"cable.density=8000/f^2"}).spec.cable.density, 320);
  EXPECT_EQ(small_set({"title=A new one"}).spec.title, "A new one");
  EXPECT_EQ(small_set({"title=A \"new\" \\one"}).spec.title, "A \"new\" \\one");
}

TEST(Override, OfAParameterReachesWhatIsMadeOfIt) {
  const Case spec = small_set({"parameters.f=1"}).spec;
  EXPECT_DOUBLE_EQ(spec.cable.area, 1e-6);
  EXPECT_EQ(spec.parameters.at("g"), 2);
}

TEST(Override, ReachesIntoListsByNumber) {
  EXPECT_EQ(small_set({"probe.0.at=0.25"}).spec.probes[0].at, 0.25);
  EXPECT_EQ(small_set({"loads.gravity.1=-1.5"}).spec.loads.gravity, Vec3(0, -1.5, 0));
  EXPECT_EQ(small_set({"reference.0.tolerance=1"}).spec.references[0].tolerance, 1);
}

TEST(Override, AddsKeysAndTablesThatTheFileLacks) {
  CaseSource source = small_case();
  const std::string start =
      "[start]\ndirection = [3, 0, 4]\nangular_velocity = [0, 4, 0]\nslope_rates = \"rigid\"\n";
  source.file.text = with(source.file.text, start, "");
  source.overrides = {"start.slope_rates=zero", "cable.quadrature=reduced"};
  const Case spec = load_case(source).spec;
  EXPECT_EQ(spec.start.slope_rates, SlopeRates::zero);
  EXPECT_EQ(spec.start.direction, Vec3(1, 0, 0));
  EXPECT_EQ(spec.cable.quadrature, QuadratureRule::reduced);
}

TEST(Override, TheLastOneOfAKeyHolds) {
  EXPECT_EQ(small_set({"cable.elements=8", "cable.elements=9"}).spec.cable.elements, 9);
}

TEST(Override, OfTheMethodDropsTheOldMethodsKeysWithARemark) {
  const LoadedCase loaded = small_set({"method.name=cvode-bdf"});
  EXPECT_EQ(loaded.spec.method.name, "cvode-bdf");
  EXPECT_FALSE(loaded.spec.method.step.has_value());
  EXPECT_EQ(loaded.remarks,
            (std::vector<std::string>{"method.step = 1e-3 of the file is not used by cvode-bdf",
                                      "method.spectral_radius = 0.9 of the file is not used by cvode-bdf",
                                      "method.newton_iterations = 15 of the file is not used by cvode-bdf"}));
}

TEST(Override, OfTheMethodKeepsTheKeysThatBothMethodsTake) {
  const LoadedCase loaded = small_set({"method.name=rk4"});
  EXPECT_EQ(loaded.spec.method.step, 1e-3);
  EXPECT_EQ(loaded.remarks.size(), 2U);
}

TEST(Override, OfTheMethodDoesNotExcuseAKeyThatTheFilesMethodNeverHad) {
  CaseSource source = small_case();
  source.overrides = {"method.name=rk4"};
  source.file.text = with(source.file.text, "newton_iterations = 15", "max_order = 3");
  EXPECT_TRUE(
      matches(refusal(source), "case.toml:27:1: method.max_order = 3: not a key of rk4, which takes: …"));
  source.file.text = with(source.file.text, "max_order = 3", "magic = 3");
  EXPECT_TRUE(matches(refusal(source), "case.toml:27:1: method.magic = 3: unknown key; known: name, …"));
}

TEST(Override, OfTheMethodAsksForAStepWhereTheFileHasNone) {
  CaseSource source = small_case();
  source.file.text =
      with(source.file.text,
           "name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15",
           "name = \"arkode-erk\"\nrtol = 1e-6");
  source.overrides = {"method.name=rk4"};
  EXPECT_EQ(refusal(source), "case.toml:23:1: method.step: missing; required: a number greater than 0 (s)");
  source.overrides.emplace_back("method.step=1e-3");
  EXPECT_EQ(load_case(source).spec.method.step, 1e-3);
}

TEST(Override, OfAStepTakesThePlaceOfTheTolerancesOfTheFileAndTheOtherWayRound) {
  CaseSource source = small_case();
  source.overrides = {"method.rtol=1e-5"};
  const LoadedCase tolerances = load_case(source);
  EXPECT_EQ(tolerances.spec.method.step, std::nullopt);
  EXPECT_EQ(tolerances.spec.method.rtol, 1e-5);
  EXPECT_EQ(tolerances.remarks.front(),
            "method.step = 1e-3 of the file is not used by generalized-alpha with tolerances");
  source.file.text = with(source.file.text, "step = 1e-3", "rtol = 1e-3\natol = 1e-4");
  source.overrides = {"method.step=1e-4"};
  const LoadedCase step = load_case(source);
  EXPECT_EQ(step.spec.method.step, 1e-4);
  EXPECT_EQ(step.spec.method.rtol, std::nullopt);
  EXPECT_EQ(step.remarks.size(), 2U);
}

TEST(Override, MayHoldAnEqualsSign) {
  EXPECT_EQ(small_set({"title=a = b"}).spec.title, "a = b");
}

TEST(Override, CannotSmuggleInASecondKey) {
  CaseSource source = small_case();
  source.overrides = {"cable.elements=8\ncable.length=3"};
  EXPECT_EQ(refusal(source).find('\n'), std::string::npos);
  EXPECT_NE(refusal(source), "accepted");
}

}  // namespace override_test
}  // namespace plumb
