#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/integrate/integrate.h"
#include "engine/run/mode_table.h"
#include "report/verdict/results.h"

namespace plumb {
namespace shelf_test {

namespace fs = std::filesystem;

/// The names of all cases of the shelf.
std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(fs::path(PLUMB_SOURCE_DIR) / "cases/shelf"))
    if (entry.path().extension() == ".toml") result.push_back(entry.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

LoadedCase loaded(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return load_case(PLUMB_SOURCE_DIR "/cases/shelf/" + name + ".toml", overrides);
}

std::vector<Verdict> verdicts_of(const LoadedCase& one) {
  Run run;
  run.loaded = one;
  run.trajectory = integrate(one.spec);
  run.probes = probe(one.spec, run.trajectory);
  run.modes = mode_table(one.spec, run.trajectory);
  return evaluate(run, {}).verdicts;
}

TEST(Shelf, EveryCaseIsReadWithoutARemarkAndSaysWhyItsTolerances) {
  EXPECT_GE(names().size(), 20U);
  for (const std::string& name : names()) {
    const LoadedCase one = loaded(name);
    EXPECT_TRUE(one.remarks.empty()) << fmt::format("{}: {}", name, fmt::join(one.remarks, "; "));
    EXPECT_FALSE(one.spec.references.empty()) << name;
    for (const ReferenceUse& use : one.spec.references)
      EXPECT_GT(use.reason.size(), 40U) << name << ": " << use.name << ": " << use.reason;
    EXPECT_FALSE(one.spec.figures.empty()) << name;
  }
}

TEST(Shelf, EveryReferenceFileIsThatOfACase) {
  std::vector<std::string> used;
  for (const std::string& name : names())
    for (const ReferenceUse& use : loaded(name).spec.references) used.push_back(use.file);
  for (const auto& entry : fs::directory_iterator(fs::path(PLUMB_SOURCE_DIR) / "cases/shelf/references"))
    if (entry.path().extension() == ".toml") {
      const std::string file = "references/" + entry.path().filename().string();
      EXPECT_NE(std::find(used.begin(), used.end(), file), used.end()) << file;
    }
}

TEST(Shelf, EveryCriterionIsMet) {
  for (const std::string& name : names())
    for (const Verdict& verdict : verdicts_of(loaded(name)))
      EXPECT_TRUE(verdict.status == VerdictStatus::passed || verdict.status == VerdictStatus::another_model)
          << name << ": " << verdict.name << ": " << word(verdict.status) << ": " << verdict.message;
}

/// A mistake that the case must tell: a number to change.
struct Mistake {
  std::string name, change;
};

TEST(Shelf, AMistakeIsNotMet) {
  for (const Mistake& mistake :
       std::vector<Mistake>{{"elastica", "cable.elements=16"},
                            {"elastica", "loads.end_force.1=9.99"},
                            {"elastica", "loads.end_force.1=-10"},
                            {"cantilever_green", "cable.strain=engineering-material"},
                            {"cantilever_engineering", "cable.strain=green-geometric"},
                            {"princeton_weak", "cable.strain=engineering-material"},
                            {"princeton_strong", "cable.strain=engineering-material"},
                            {"princeton_strong", "cable.youngs_modulus=72e9"},
                            {"roll_up_engineering", "cable.elements=32"},
                            {"roll_up_rod", "cable.strain=green-geometric"},
                            {"buckled_column", "cable.elements=16"},
                            {"buckled_column", "method.follow=primary"},
                            {"uniform_dead", "cable.elements=16"},
                            {"uniform_follower", "load.0.follows=false"},
                            {"follower_tip", "load.0.follows=false"},
                            {"suspended_cable", "loads.gravity.1=-9.8"},
                            {"suspended_cable", "cable.strain=green-geometric"},
                            {"beam_supports", "cable.strain=green-geometric"},
                            {"beam_cantilever", "loads.gravity.1=-9.81"},
                            {"clamped_free", "cable.elements=16"},
                            {"piano_wire", "parameters.T=9.9"},
                            {"piano_wire_slack", "cable.elements=48"},
                            {"taut_string", "parameters.T=6171.1"},
                            {"hanging_chain", "loads.gravity.1=-9.8"},
                            {"rotating_beam_2", "parameters.eta=2.01"},
                            {"rotating_string", "cable.second_moment=1e-14"},
                            {"spin_up", "cable.youngs_modulus=2.828e10"},
                            {"pendulum_a01", "loads.gravity.1=-9.8"},
                            {"pendulum_a01_link", "loads.gravity.1=-9.8"},
                            {"pendulum_cable_elements", "loads.gravity.1=-9.8"},
                            {"heavy_mass", "mass.0.mass=1.01e5"},
                            {"heavy_mass", "loads.gravity.2=-9.8"},
                            {"spinning_rod", "loads.gravity.1=-9.8"}}) {
    const LoadedCase one = loaded(mistake.name, {mistake.change});
    EXPECT_FALSE(all_passed(verdicts_of(one))) << mistake.name << " with " << mistake.change;
  }
}

}  // namespace shelf_test
}  // namespace plumb
