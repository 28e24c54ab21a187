#include "engine/study/sweep/sweep_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/integrate/method_info.h"
#include "tests/engine/study/sweep/tiny_sweep.h"

namespace plumb {
namespace sweep_cases_test {

Case case_with(const LoadedCase& loaded, const std::vector<std::string>& overrides) {
  CaseSource source = loaded.source;
  source.overrides.insert(source.overrides.end(), overrides.begin(), overrides.end());
  return load_case(source).spec;
}

TEST(SweepCases, DependOnSeedAndNumberAlone) {
  const LoadedCase loaded = tiny_sweep_case();
  const Case model = case_with(loaded, model_overrides(loaded.spec, 7, 3));
  EXPECT_EQ(model_overrides(loaded.spec, 7, 3), model_overrides(loaded.spec, 7, 3));
  EXPECT_NE(model_overrides(loaded.spec, 7, 3), model_overrides(loaded.spec, 7, 4));
  EXPECT_NE(model_overrides(loaded.spec, 7, 3), model_overrides(loaded.spec, 8, 3));
  EXPECT_EQ(method_overrides(loaded.spec, model, 7, 24), method_overrides(loaded.spec, model, 7, 24));
  EXPECT_NE(method_overrides(loaded.spec, model, 7, 24), method_overrides(loaded.spec, model, 7, 25));
}

TEST(SweepCases, AreTheSameOnEveryMachine) {
  const LoadedCase loaded = tiny_sweep_case();
  EXPECT_EQ(
      model_overrides(loaded.spec, 1, 0),
      (std::vector<std::string>{
          "parameters.f=2.18438", "cable.elements=1", "cable.strain=engineering-material",
          "cable.quadrature=full", "supports.first=clamped", "supports.last=free", "start.slope_rates=zero",
          "time.output_interval=0.009559", "time.end=0.19118",
          "load=[{kind=\"distributed\", value=[-0.0393, -0.00226, 0.0394], follows=false, "
          "factor=\"-0.608*(1-cos(62.2*t))\"}, {kind=\"distributed\", value=[0.000933, 0.00235, 0.00201], "
          "follows=true, factor=\"-0.361*(1-cos(22.5*t))\"}]",
          "mass=[{at=0.169, mass=0.0604}]"}));
}

TEST(SweepCases, AreValidAndReachEveryMethodPairOfSupportsAndEnd) {
  const LoadedCase loaded = tiny_sweep_case();
  std::set<std::string> methods;
  std::set<std::pair<Support, Support>> supports;
  std::map<std::string, std::array<double, 2>> reach;
  const auto reached = [&](const std::string& what, double value) {
    auto [at, is_new] = reach.try_emplace(what, std::array{value, value});
    at->second = {std::min(at->second[0], value), std::max(at->second[1], value)};
  };
  constexpr long models = 120;
  for (long m = 0; m < models; ++m) {
    const std::vector<std::string> overrides = model_overrides(loaded.spec, 1, m);
    const Case model = case_with(loaded, overrides);
    supports.emplace(model.supports.first, model.supports.last);
    reached("f", model.parameters.at("f"));
    reached("elements", model.cable.elements);
    reached("end", model.time.end);
    reached("strain", model.cable.strain == StrainModel::green_geometric);
    reached("quadrature", model.cable.quadrature == QuadratureRule::full);
    reached("loads", static_cast<double>(model.loads.applied.size()));
    for (const LoadSpec& load : model.loads.applied) {
      reached("kind of load", static_cast<double>(load.kind));
      reached("load that follows", load.follows);
      reached("load that changes", load.factor != "1");
    }
    reached("masses", static_cast<double>(model.masses.size()));
    reached("damping by mass", model.damping.mass > 0);
    reached("damping of the material", model.damping.material > 0);
    reached("motion of the first end", model.supports.first_motion.has_value());
    reached("motion of the last end", model.supports.last_motion.has_value());
    reached("rotation of the first end", model.supports.first_rotation.has_value());
    reached("rates", model.start.slope_rates == SlopeRates::rigid);
    for (long k = 0; k < runs_of_a_model; ++k) {
      std::vector<std::string> all = overrides;
      for (const std::string& text : method_overrides(loaded.spec, model, 1, m * runs_of_a_model + k))
        all.push_back(text);
      const Case run = case_with(loaded, all);
      methods.insert(run.method.name);
      if (run.method.step) reached("step", *run.method.step / run.time.end);
      if (run.method.rtol) reached("rtol", *run.method.rtol);
    }
  }
  for (const MethodInfo& info : method_infos())
    EXPECT_TRUE(methods.contains(info.name) == info.dynamic) << info.name;
  EXPECT_EQ(supports.size(), 9U) << "every pair of three supports";
  for (const auto& [what, low, high] :
       std::vector<std::tuple<std::string, double, double>>{{"f", 1.2, 17},
                                                            {"elements", 1, 15},
                                                            {"end", 0.06, 0.45},
                                                            {"strain", 0, 1},
                                                            {"quadrature", 0, 1},
                                                            {"rates", 0, 1},
                                                            {"loads", 0, 2},
                                                            {"kind of load", 0, 2},
                                                            {"load that follows", 0, 1},
                                                            {"load that changes", 0, 1},
                                                            {"masses", 0, 1},
                                                            {"damping by mass", 0, 1},
                                                            {"damping of the material", 0, 1},
                                                            {"motion of the first end", 0, 1},
                                                            {"motion of the last end", 0, 1},
                                                            {"rotation of the first end", 0, 1},
                                                            {"step", 1e-4, 0.9},
                                                            {"rtol", 1e-10, 0.1}}) {
    EXPECT_LE(reach[what][0], low) << what;
    EXPECT_GE(reach[what][1], high) << what;
  }
}

TEST(SweepCases, TheFilesOwnMethodKeepsToItsKindOfSetting) {
  LoadedCase loaded = tiny_sweep_case({"method.name=arkode-erk", "method.rtol=1e-6"});
  long own = 0;
  for (long k = 0; k < 800; ++k) {
    const std::vector<std::string> overrides = method_overrides(loaded.spec, loaded.spec, 1, k);
    if (overrides.front() != "method.name=arkode-erk") continue;
    ++own;
    EXPECT_TRUE(overrides[1].starts_with("method.rtol=")) << overrides[1];
    EXPECT_NO_THROW(case_with(loaded, overrides));
  }
  EXPECT_GT(own, 10);
}

}  // namespace sweep_cases_test
}  // namespace plumb
