#include "engine/run/plausibility.h"

#include <gtest/gtest.h>

#include "engine/integrate/integrate.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace plausibility_test {

Case pendulum(const std::vector<std::string>& overrides) {
  return load_case(PLUMB_SOURCE_DIR "/cases/pendulum.toml", overrides).spec;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text + "\n";
  return all;
}

TEST(Plausibility, APlausibleCaseGetsNoRemark) {
  EXPECT_EQ(joined(implausible_inputs(pendulum({}))), "");
}

TEST(Plausibility, EachImplausibleInputIsRemarkedOnAlone) {
  struct Odd {
    std::vector<std::string> overrides;
    const char* words;
  };
  for (const Odd& odd :
       {Odd{{"cable.density=0.9"}, "cable.density = 0.9 kg/m³: materials have 1 to 25000 kg/m³"},
        {{"cable.density=25001"}, "cable.density = 2.5e+04 kg/m³"},
        {{"cable.area=0.008"}, "the cable is 0.101 m thick and 1 m long"},
        {{"cable.youngs_modulus=1.1e11", "start.stretch=1.1"}, "a stress of 1.1e+10 Pa at the start"},
        {{"time.output_interval=1", "time.end=1"}, "gives two output times only"}}) {
    std::vector<std::string> implicit = odd.overrides;  // which no step is too long for
    implicit.insert(implicit.end(), {"method.name=generalized-alpha", "method.step=1e-3"});
    const std::vector<std::string> found = implausible_inputs(pendulum(implicit));
    ASSERT_EQ(found.size(), 1U) << odd.words << "\n" << joined(found);
    EXPECT_NE(found[0].find(odd.words), std::string::npos) << found[0];
  }
}

TEST(Plausibility, TheStepThatStabilityBearsIsTheBoundOfTheRemark) {
  const Case spec = pendulum({"method.name=velocity-verlet", "method.step=1e-5"});
  const double limit = 2 / fastest_frequency_at_start(spec);  // ωh = 2
  for (const double share : {0.99, 1.01}) {
    Case with_step = spec;
    with_step.method.step = share * limit;
    const std::string found = joined(implausible_inputs(with_step));
    EXPECT_EQ(found.find("method.step") != std::string::npos, share > 1) << share << ": " << found;
  }
}

TEST(Plausibility, AStressThatNoMaterialBearsIsFoundInTheRun) {
  const Case soft = pendulum({"time.end=0.1"});
  const Trajectory run = integrate(soft);
  EXPECT_EQ(implausible_stress(soft, run), "");
  Case stiff = soft;  // as if the same strains were those of steel, ten times as stiff
  stiff.cable.youngs_modulus = 2e13;
  EXPECT_NE(implausible_stress(stiff, run).find("no material bears"), std::string::npos)
      << implausible_stress(stiff, run);
}

TEST(Plausibility, AnExplicitMethodHeldBackByStabilityIsToldWhatWouldDo) {
  const std::vector<std::string> stiff{"parameters.f=1", "cable.elements=8", "time.end=0.2",
                                       "start.angular_velocity=[0,0,0]"};
  std::vector<std::string> loose = stiff, tight = stiff;
  for (const char* key : {"method.name=arkode-erk", "method.rtol=1e-3", "method.atol=1e-3"})
    loose.push_back(key);
  for (const char* key : {"method.name=arkode-erk", "method.rtol=1e-11", "method.atol=1e-11"})
    tight.push_back(key);
  const Case held = pendulum(loose);
  const Trajectory run = integrate(held);
  // The time that a try may take is that of the run, which is nothing that a test can count on.
  Trajectory slow = run;
  slow.solve_seconds = 60;
  const std::string found = held_back_by_stability(held, slow);
  EXPECT_NE(found.find("arkode-erk was held back by stability"), std::string::npos)
      << found << run.counters.steps;
  EXPECT_NE(found.find("arkode-dirk with the same tolerances takes"), std::string::npos) << found;
  const Case needed = pendulum(tight);
  EXPECT_EQ(held_back_by_stability(needed, integrate(needed)), "");
  const Case implicit = pendulum({"method.name=generalized-alpha", "method.step=1e-2", "time.end=0.1"});
  EXPECT_EQ(held_back_by_stability(implicit, integrate(implicit)), "");
}

}  // namespace plausibility_test
}  // namespace plumb
