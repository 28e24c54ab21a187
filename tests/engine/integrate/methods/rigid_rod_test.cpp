#include "engine/integrate/methods/rigid_rod.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/pendulum.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace rigid_rod_test {

/// Closed form of the rod of 1 m let go level at 4 rad/s, g = 9.81 m/s²: with the height of its direction u
/// and L = u̇-free momentum, u̇² is a cubic in u, whose roots and the complete elliptic integral give these.
constexpr double lowest_mid_y = -0.382228153438;    // m
constexpr double lowest_time = 0.449811077626;      // s
constexpr double nutation_period = 0.899622155252;  // s

Trajectory rod(double step, const TimeSpec& time, int elements = 1) {
  Case spec = pendulum(5, elements);
  spec.cable.model = CableModel::rigid;
  spec.cable.second_moment = 0;
  return run(spec, method("rk4", step), time);
}

double mid_y(const Trajectory& trajectory, std::size_t output) {
  return tip(trajectory, output).y() / 2;
}

TEST(RigidRod, IsLowestWhereTheClosedFormSays) {
  const Trajectory trajectory = rod(lowest_time / 1000, {lowest_time, lowest_time});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  EXPECT_NEAR(mid_y(trajectory, 1), lowest_mid_y, 1e-10);
  EXPECT_NEAR(trajectory.v.back().tail<6>()[1], 0, 1e-8) << "the tip turns back there";
}

TEST(RigidRod, IsLevelAgainAfterTheNutationPeriodOfTheClosedForm) {
  const Trajectory trajectory = rod(nutation_period / 2000, {nutation_period, nutation_period});
  EXPECT_NEAR(mid_y(trajectory, 1), 0, 1e-10);
  EXPECT_NEAR(tip(trajectory, 1).norm(), 1, 1e-14);
}

TEST(RigidRod, ConvergesWithOrderFour) {
  double before = 0;
  for (const double steps : {25.0, 50.0, 100.0}) {
    const double error =
        std::abs(mid_y(rod(lowest_time / steps, {lowest_time, lowest_time}), 1) - lowest_mid_y);
    if (before > 0) {
      const double order = std::log2(before / error);
      EXPECT_GT(order, 3.6) << steps << " steps: " << error;
      EXPECT_LT(order, 5.4) << steps << " steps: " << error;
    }
    before = error;
  }
}

TEST(RigidRod, StaysStraightAndKeepsItsEnergyOnEveryMesh) {
  const Trajectory trajectory = rod(1e-3, {2, 0.02}, 3);
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  for (std::size_t k = 0; k < trajectory.q.size(); ++k)
    for (int node = 0; node <= 3; ++node) {
      const Vec3 place = trajectory.q[k].segment<3>(6 * node);
      EXPECT_NEAR((place - node / 3.0 * tip(trajectory, k)).norm(), 0, 1e-14);
      EXPECT_EQ(trajectory.q[k].segment<3>(6 * node + 3), trajectory.q[k].segment<3>(3));
    }
  EXPECT_LT(trajectory.relative_energy_drift(), 1e-9);
  for (const Energies& energies : trajectory.energies) EXPECT_LT(std::abs(energies.axial), 1e-20);
}

TEST(RigidRod, TurnsUnderAForceOnItsEndAsUnderItsWeight) {
  // Half the weight at the end has the moment of the whole weight in the middle.
  Case spec = pendulum(5, 2);
  spec.cable.model = CableModel::rigid;
  const double weight = spec.cable.density * spec.cable.area * spec.cable.length * 9.81;
  const Trajectory by_weight = run(spec, method("rk4", 1e-3), {0.4, 0.1});
  spec.loads.gravity = {0, 0, 0};
  spec.loads.end_force = {0, -weight / 2, 0};
  EXPECT_LT(tip_distance(by_weight, run(spec, method("rk4", 1e-3), {0.4, 0.1})), 1e-12);
}

TEST(RigidRod, IsWhatACableTendsToAsItGrowsStiff) {
  const Trajectory exact = rod(1e-3, {0.3, 0.1});
  double before = INFINITY;
  for (const double stiffening : {1e2, 1e4}) {
    Case spec = pendulum(5, 2);
    spec.cable.youngs_modulus *= stiffening;
    const double off = (tip(run(spec, method("generalized-alpha", 1e-3), {0.3, 0.1})) - tip(exact)).norm();
    EXPECT_LT(off, before);
    before = off;
  }
  EXPECT_LT(before, 1e-2) << "of 1 m";
}

TEST(RigidRod, IsNotIntegratedByAnythingElse) {
  Case spec = pendulum(5, 1);
  spec.cable.model = CableModel::rigid;
  EXPECT_THROW(run(spec, method("velocity-verlet", 1e-3), {0.1, 0.1}), std::invalid_argument);
}

CaseSource rigid_case(const std::string& more_cable = "",
                      const std::string& method = "name = \"rk4\"\nstep = 1e-3",
                      const std::string& rest = "") {
  CaseSource source;
  source.file = {"rod.toml",
                 "title = \"rod\"\n[cable]\nlength = 1\narea = 1e-4\ndensity = 1000\nyoungs_modulus = 1e9\n"
                 "elements = 1\nmodel = \"rigid\"\n" +
                     more_cable + "[supports]\nfirst = \"pinned\"\n[method]\n" + method +
                     "\n[time]\nend = 1\noutput_interval = 0.1\n" + rest};
  return source;
}

TEST(RigidRod, IsReadFromACase) {
  EXPECT_EQ(load_case(rigid_case()).spec.cable.model, CableModel::rigid);
}

TEST(RigidRod, IsRefusedWhatItDoesNotHave) {
  for (const auto& [source, says] : std::vector<std::pair<CaseSource, std::string>>{
           {rigid_case("second_moment = 1e-9\n"), "cable.second_moment = 1e-9: not a key of a rigid rod"},
           {rigid_case("quadrature = \"full\"\n"), "cable.quadrature = \"full\": not a key of a rigid rod"},
           {rigid_case("strain = \"green-geometric\"\n"),
            "cable.strain = \"green-geometric\": not a key of a rigid rod"},
           {rigid_case("", "name = \"velocity-verlet\"\nstep = 1e-3"),
            "method.name = \"velocity-verlet\": must be \"rk4\" for a rigid rod"},
           {rigid_case("", "name = \"rk4\"\nstep = 1e-3", "[start]\nslope_rates = \"zero\"\n"),
            "start.slope_rates = \"zero\": must be \"rigid\" for a rigid rod"},
           {rigid_case("", "name = \"rk4\"\nstep = 1e-3", "[start]\naxial_speed = 1\n"),
            "start.axial_speed = 1: must be 0 for a rigid rod"},
           {rigid_case("", "name = \"rk4\"\nstep = 1e-3",
                       "[[probe]]\nname = \"e\"\nat = 0.5\nquantity = \"axial-strain\"\n"),
            "probe.0.quantity = \"axial-strain\": a rigid rod has only position, velocity and slope"},
       }) {
    const std::string message = refusal(source);
    EXPECT_NE(message.find(says), std::string::npos) << message << "\n" << says;
  }
  CaseSource free = rigid_case();
  free.file.text = with(free.file.text, "first = \"pinned\"", "first = \"clamped\"");
  EXPECT_NE(refusal(free).find("supports.first = \"clamped\": must be \"pinned\" for a rigid rod"),
            std::string::npos)
      << refusal(free);
  free.file.text = with(free.file.text, "first = \"clamped\"", "first = \"pinned\"\nlast = \"pinned\"");
  EXPECT_NE(refusal(free).find("supports.last = \"pinned\": must be \"free\" for a rigid rod"),
            std::string::npos)
      << refusal(free);
}

TEST(RigidRod, OverrulesWhatTheFileSaysOfElements) {
  CaseSource source = rigid_case("quadrature = \"full\"\nsecond_moment = 1e-9\n");
  source.file.text = with(source.file.text, "model = \"rigid\"\n", "");
  source.overrides = {"cable.model=rigid"};
  const LoadedCase loaded = load_case(source);
  EXPECT_EQ(loaded.spec.cable.second_moment, 0);
  ASSERT_EQ(loaded.remarks.size(), 2U);
  EXPECT_EQ(loaded.remarks[0], "cable.quadrature = \"full\" of the file is not used by the model rigid");
  source.overrides = {"cable.model=chain"};
  EXPECT_EQ(load_case(source).spec.cable.model, CableModel::chain);
}

}  // namespace rigid_rod_test
}  // namespace plumb
