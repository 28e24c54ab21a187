#include "engine/study/estimate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/case/case_source.h"
#include "engine/integrate/method_info.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace estimate_test {

Case changed(const std::vector<std::string>& overrides) {
  CaseSource source = small_case();
  source.overrides = overrides;
  return load_case(source).spec;
}

constexpr PlannedWork whole_run{.solves = true, .writes_run = true, .assesses = true, .draws = true};

double memory(const std::vector<std::string>& overrides) {
  return estimate(changed(overrides), whole_run).total(Resource::memory);
}

TEST(Estimate, KnowsWhatEveryMethodCosts) {
  for (const MethodInfo& method : method_infos()) {
    const bool unknown = bytes_a_node(method.name) == bytes_a_node("no such method") &&
                         seconds_an_element(method.name) == seconds_an_element("no such method");
    EXPECT_FALSE(unknown) << method.name;
  }
}

TEST(Estimate, GrowsWithEveryFactorOfAProduct) {
  const double plain = memory({"time.output_interval=1e-3"});
  EXPECT_GT(memory({"time.output_interval=1e-5"}), 2 * plain);
  EXPECT_GT(memory({"time.output_interval=1e-3", "cable.elements=4000"}), 2 * plain);
  EXPECT_GT(memory({"time.output_interval=1e-3", "scene.size=[12000,12000]"}), 2 * plain);
  EXPECT_GT(memory({"time.output_interval=1e-3", "scene.frame_rate=1000"}), 1.2 * plain);
}

TEST(Estimate, OfTheLargestProductsIsLargeAndFinite) {
  const double most = memory({"cable.elements=1000000", "time.output_interval=2e-6"});
  EXPECT_GT(most, 1e14);
  EXPECT_TRUE(std::isfinite(most));
}

TEST(Estimate, SaysThatALongRunTakesLong) {
  const Case spec = changed({"method.name=rk4", "method.step=1e-8", "time.end=10", "cable.elements=1000000"});
  EXPECT_GT(estimate(spec, whole_run).total(Resource::time), 86400);
}

TEST(Estimate, TakesTheStageThatHoldsMostMemoryAndEveryPartOfTheDisk) {
  Estimate made;
  made.parts = {{Resource::memory, "", "always", "", 1},   {Resource::memory, "a", "first", "", 10},
                {Resource::memory, "b", "second", "", 20}, {Resource::memory, "b", "third", "", 5},
                {Resource::disk, "a", "one", "", 3},       {Resource::disk, "b", "two", "", 4}};
  EXPECT_EQ(made.total(Resource::memory), 26);
  EXPECT_EQ(made.parts_of(Resource::memory).front().what, "second");
  EXPECT_EQ(made.total(Resource::disk), 7);
  EXPECT_EQ(made.total(Resource::time), 0);
}

TEST(Estimate, IsSaidInUnitsThatCanBeRead) {
  EXPECT_EQ(amount_in_words(Resource::memory, 999), "999 bytes");
  EXPECT_EQ(amount_in_words(Resource::disk, 3.2e9), "3.2 GB");
  EXPECT_EQ(amount_in_words(Resource::time, 5400), "1.5 h");
  EXPECT_EQ(amount_in_words(Resource::time, 0.25), "0.25 s");
}

}  // namespace estimate_test
}  // namespace plumb
