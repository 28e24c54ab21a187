#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/engine/small_case.h"

namespace plumb {
namespace override_faults_test {

/// Overrides of the small case, and the whole error that they must give.
struct Fault {
  std::vector<std::string> overrides;
  std::string expected;
};

void expect_refused(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    CaseSource source = small_case();
    source.overrides = fault.overrides;
    const std::string message = refusal(source);
    EXPECT_TRUE(matches(message, fault.expected))
        << "refused:  " << message << "\nexpected: " << fault.expected;
  }
}

TEST(OverrideFaults, ABadOverrideIsRefusedWithItsPlaceAndWhatIsAllowed) {
  expect_refused({
      {{"cable"}, "usage: --set cable: must be KEY=VALUE, as in --set cable.elements=8"},
      {{"=5"}, "usage: --set =5: must be KEY=VALUE, as in --set cable.elements=8"},
      {{"cable..length=1"}, "usage: --set cable..length=1: must be KEY=VALUE, as in --set cable.elements=8"},
      {{"cable.le ngth=1"}, "usage: --set cable.le ngth=1: must be KEY=VALUE, as in --set cable.elements=8"},
      {{"cable.length=-1"}, "--set cable.length=-1: must be a number greater than 0 (m)"},
      {{"cable.lenght=1"}, "--set cable.lenght=1: unknown key; did you mean \"length\"?"},
      {{"cabel.length=1"}, "--set cabel.length=1: cabel: unknown table; did you mean \"cable\"?"},
      {{"cable.length=long"}, "--set cable.length=long: unknown parameter \"long\"; known: f, g"},
      {{"cable.length=8000/ff^2"},
       "--set cable.length=8000/ff^2: unknown parameter \"ff\"; did you mean \"f\"?"},
      {{"cable.length=f - 5"}, "--set cable.length=f - 5 (= 0): must be a number greater than 0 (m)"},
      {{"loads.gravity=[0, inf, 0]"},
       "--set loads.gravity=[0, inf, 0]: loads.gravity.1 = inf: must be finite: a number (m/s²)"},
      {{"loads.gravity=[0, 1"},
       "--set loads.gravity=[0, 1: must be a list of 3 numbers (m/s²), found a string"},
      {{"loads.gravity.1=nan"}, "--set loads.gravity.1=nan: must be finite: a number (m/s²)"},
      {{"loads.gravity.3=0"},
       "--set loads.gravity.3=0: loads.gravity is a list of 3, numbered from 0; \"3\" is not one of them"},
      {{"probe.1.at=2"}, "--set probe.1.at=2: must be a number from 0 to 1 (fraction of the length)"},
      {{"probe.2.at=0.5"},
       "--set probe.2.at=0.5: probe is a list of 2, numbered from 0; \"2\" is not one of them"},
      {{"probe.x.at=0.5"},
       "--set probe.x.at=0.5: probe is a list of 2, numbered from 0; \"x\" is not one of them"},
      {{"cable.length.x=1"}, "--set cable.length.x=1: cable.length is not a table: it is a number"},
      {{"method.name=rk5"}, "--set method.name=rk5: must be …; did you mean \"rk4\"?"},
      {{"method.step=5"}, "--set method.step=5: must be at most the end time, 2 (s)"},
      {{"method.name=rk4", "method.spectral_radius=0.5"},
       "--set method.spectral_radius=0.5: not a key of rk4, which takes: …"},
      {{"method.name=rk4", "method.magic=1"}, "--set method.magic=1: unknown key; known: name, …"},
      {{"reference.0.file=absent.toml"},
       "--set reference.0.file=absent.toml: cannot be read: its text is not among those of the case"},
      {{"scene.camera={ eye = [0, 0, 1] }"},
       "--set scene.camera={ eye = [0, 0, 1] }: scene.camera.target: missing; required: a list of 3 numbers "
       "(m)"},
      {{"parameters.f=0"},
       "case.toml:7:8: cable.area = \"1e-6 * f^2\" (= 0): must be a number greater than 0 (m²)"},
      {{"parameters.f=g"}, "--set parameters.f=g: depends on itself: f -> g -> f"},
      {{"title=a\x01"
        "b"},
       "--set title=a\\x01b: the value must be UTF-8 text without control characters"},
      {{"time.end=0.25"},
       "case.toml:30:19: time.output_interval = 0.5: must be at most the end time, 0.25 (s)"},
  });
}

}  // namespace override_faults_test
}  // namespace plumb
