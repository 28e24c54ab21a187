#include "engine/study/sensitivity/run_sensitivity.h"

#include <gtest/gtest.h>

#include "engine/base/errors.h"
#include "engine/model/cable.h"
#include "engine/study/sensitivity/sensitivity_json.h"
#include "tests/engine/pendulum.h"
#include "tests/engine/study/in_memory.h"
#include "tests/engine/study/sensitivity/tiny_sensitivity.h"

namespace plumb {
namespace run_sensitivity_test {

const NumberSensitivity& number(const Sensitivity& found, const std::string& key) {
  for (const NumberSensitivity& any : found.numbers)
    if (any.key == key) return any;
  throw std::runtime_error("no " + key);
}

const BlunderSensitivity& blunder(const Sensitivity& found, Blunder kind) {
  for (const BlunderSensitivity& any : found.blunders)
    if (any.blunder.kind == kind) return any;
  throw std::runtime_error("no such blunder");
}

Run with_gravity(LoadedCase loaded, double factor) {
  Run run;
  run.loaded = std::move(loaded);
  run.loaded.spec.loads.gravity *= factor;
  run.trajectory = integrate(run.loaded.spec);
  run.probes = probe(run.loaded.spec, run.trajectory);
  return run;
}

/// A judge that finds the same of every run.
Judge always(const std::vector<JudgedCriterion>& criteria) {
  return [criteria](const Run&) { return criteria; };
}

TEST(Sensitivity, GravityIsNoticedByWhatFallsAndNothingByALimitThatIsTooWide) {
  const LoadedCase loaded = tiny_sensitivity_case();
  const Judge judge = tiny_judge(loaded);
  const Sensitivity found = run_sensitivity(loaded, judge, InMemory());
  ASSERT_EQ(found.left_out, "");
  const NumberSensitivity& gravity = number(found, "loads.gravity.1");
  const NoticedChange up = gravity.up.noticed.at(0);
  EXPECT_FALSE(up.by_failure);
  // The tip falls by g t²/2 to 3 g t²/4, 0.05 to 0.07 m, of which 1e-3 m are some 2 %.
  EXPECT_GT(up.change, 0.005);
  EXPECT_LT(up.change, 0.05);
  EXPECT_NEAR(gravity.down.noticed.at(0).change, up.change, 0.15 * up.change) << "the fall is linear in g";

  // The smallest change fails, and one that is smaller by what it is known to does not.
  const auto height_with = [&](double factor) { return judge(with_gravity(loaded, factor)).front(); };
  EXPECT_FALSE(height_with(1 + up.change).met) << height_with(1 + up.change).value;
  EXPECT_TRUE(height_with(1 + up.change / 1.06).met) << height_with(1 + up.change / 1.06).value;

  EXPECT_FALSE(found.weak(0));
  EXPECT_EQ(found.weak_names(), std::vector<std::string>{"across"});
  EXPECT_TRUE(blunder(found, Blunder::other_sign).trial.notices(0));
  EXPECT_FALSE(blunder(found, Blunder::other_sign).trial.notices(1));
  EXPECT_TRUE(blunder(found, Blunder::late_output).trial.notices(0))
      << blunder(found, Blunder::late_output).trial.found.at(0).value << " m in one interval";
}

TEST(Sensitivity, OfWhatIsAskedForAloneIsTried) {
  const LoadedCase loaded =
      tiny_sensitivity_case("numbers = [\"cable.density\"]\nblunders = [\"chain\"]\nlargest = 2\n");
  const Sensitivity found = run_sensitivity(loaded, tiny_judge(loaded), InMemory());
  ASSERT_EQ(found.numbers.size(), 1U);
  EXPECT_EQ(found.numbers[0].key, "cable.density");
  EXPECT_LE(found.numbers[0].up.searched, 1) << "up to a factor of 2";
  ASSERT_EQ(found.blunders.size(), 1U);
  EXPECT_EQ(found.runs, found.numbers[0].up.runs + found.numbers[0].down.runs + 1);
}

TEST(Sensitivity, OfACaseThatMeetsNothingIsLeftOut) {
  const LoadedCase loaded = tiny_sensitivity_case();
  const auto left_out = [&](const Judge& judge) {
    return run_sensitivity(loaded, judge, InMemory()).left_out;
  };
  EXPECT_EQ(left_out(always({})), "the case has no criterion");
  EXPECT_EQ(left_out(always({{"a", "m", 1, 2, false}})), "the case meets none of its criteria");
}

TEST(Sensitivity, IsReadBackAsItWasWritten) {
  const LoadedCase loaded =
      tiny_sensitivity_case("numbers = [\"loads.gravity.1\"]\nblunders = [\"chain\", \"half-mesh\"]\n");
  const SensitivityStudy study{loaded, run_sensitivity(loaded, tiny_judge(loaded), InMemory()), {}};
  const std::string text = encode_sensitivity(study);
  EXPECT_EQ(encode_sensitivity(decode_sensitivity(text, "study.json")), text);
  SensitivityStudy other = study;
  other.result.numbers[0].up.noticed.pop_back();
  EXPECT_THROW(decode_sensitivity(encode_sensitivity(other), "study.json"), InputError);
}

TEST(PlannedBlunders, OfACaseThatCannotMakeThemSayWhy) {
  Case spec = pendulum(5, 1);
  spec.loads.gravity = {0, 0, 0};
  spec.start.angular_velocity = {0, 0, 0};
  spec.cable.second_moment = 0;
  spec.method = method("statics", 0.1);
  for (const auto& [kind, why] : std::vector<std::pair<Blunder, std::string>>{
           {Blunder::no_bending, "the cable does not resist bending"},
           {Blunder::half_mesh, "the mesh has one element"},
           {Blunder::zero_slope_rates, "statics integrates no motion"},
           {Blunder::first_order, "statics integrates no motion"},
           {Blunder::rounded_gravity, "there is no gravity"},
           {Blunder::other_sign, "there is no load"}}) {
    const std::vector<PlannedBlunder> planned = planned_blunders(spec, {kind});
    ASSERT_EQ(planned.size(), 1U);
    EXPECT_EQ(planned[0].why_not, why);
    EXPECT_TRUE(planned[0].overrides.empty());
  }
  spec.loads.gravity = {0, 0, -9.80665};
  EXPECT_EQ(planned_blunders(spec, {Blunder::rounded_gravity}).at(0).name, "gravity of 9.8 m/s²");
  spec.loads.gravity = {0, -9.8, 0};
  EXPECT_EQ(planned_blunders(spec, {Blunder::rounded_gravity}).at(0).name, "gravity of 9.81 m/s²");
  spec.loads.gravity = {0, -1.62, 0};
  EXPECT_EQ(planned_blunders(spec, {Blunder::rounded_gravity}).at(0).why_not, "gravity is 1.62 m/s²");
}

TEST(PlannedBlunders, OfMassesAreNoneWhereNothingMovesOrHasWeight) {
  Case spec = tiny_sensitivity_case().spec;
  spec.method.name = "statics";
  for (const Blunder kind : {Blunder::lumped_mass, Blunder::density_unit}) {
    EXPECT_EQ(planned_blunders(spec, {kind}).at(0).why_not, "") << "it has weight";
    Case weightless = spec;
    weightless.loads.gravity.setZero();
    const std::vector<PlannedBlunder> planned = planned_blunders(weightless, {kind});
    ASSERT_EQ(planned.size(), 1U);
    EXPECT_EQ(planned[0].why_not, "nothing moves, and nothing has weight");
    weightless.method.name = "modes";
    EXPECT_EQ(planned_blunders(weightless, {kind}).at(0).why_not, "") << "it vibrates";
  }
}

TEST(LumpedMass, OfACableStaysOnTheNodesAndIsAsMuchInAll) {
  Case spec = pendulum(5, 3);
  spec.supports.first = Support::free;
  spec.cable.lumped = true;
  const Cable cable(spec);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(cable.size()), momentum;
  v.segment<3>(6) = Vec3(1, 0, 0);
  cable.mass().multiply(v, momentum);
  const double of_element = spec.cable.density * spec.cable.area * spec.cable.length / 3;
  EXPECT_DOUBLE_EQ(momentum[6], of_element) << "half of either neighbour";
  momentum[6] = 0;
  EXPECT_EQ(momentum.norm(), 0) << "consistent, the neighbours would move with it";
  spec.cable.lumped = false;
  Cable(spec).mass().multiply(v, momentum);
  EXPECT_NE(momentum[0], 0);
}

}  // namespace run_sensitivity_test
}  // namespace plumb
