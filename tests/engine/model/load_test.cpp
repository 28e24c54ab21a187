#include "engine/model/load.h"

#include <gtest/gtest.h>

#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace load_test {

TEST(Loads, AreAddedUpByNodeAndInTheirOrder) {
  const Load first{{0, -9.81, 0}, {{4, {1, 2, 3, 4, 5, 6}}, {0, {7, 0, 0, 0, 0, 0}}}, 3};
  const Load second{{1, 0, 0}, {{4, {10, 20, 30, 40, 50, 60}}, {2, {0, 0, 0, 0, 0, 8}}}, 4};
  const LoadSum sum({first, second});
  EXPECT_EQ(sum.per_mass(), Vec3(1, -9.81, 0));
  EXPECT_EQ(sum.size(), 7);
  ASSERT_EQ(sum.on_nodes().count, 3);
  const NodeForce* on = sum.on_nodes().begin();
  EXPECT_EQ(on[0].node, 0);
  EXPECT_EQ(on[0].force[0], 7);
  EXPECT_EQ(on[1].node, 2);
  EXPECT_EQ(on[1].force[5], 8);
  EXPECT_EQ(on[2].node, 4);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(on[2].force[k], 11 * (k + 1)) << k;
}

TEST(Loads, OfACaseAreItsWeightAndItsEndForceWhereThereAreAny) {
  Case spec = pendulum(5, 4);
  spec.loads = {};
  EXPECT_TRUE(loads_of(spec).empty());
  spec.loads = {.gravity = {0, 0, -2}, .end_force = {3, -4, 0}, .applied = {}};
  EXPECT_EQ(loads_of(spec).size(), 2U);
  const Cable cable(spec);
  const double mass = spec.cable.density * spec.cable.area * spec.cable.length;
  EXPECT_NEAR(cable.loads().size(), 2 * mass + 5, 1e-14);
  Vec3 sum = Vec3::Zero();
  for (int node = 0; node < cable.nodes(); ++node) sum += cable.external_force().segment<3>(6 * node);
  EXPECT_LE((sum - Vec3(3, -4, -2 * mass)).norm(), 1e-14) << sum.transpose() << " N";
}

TEST(Loads, OnNodesActAlikeInTheForceAndInTheAcceleration) {
  Case spec = pendulum(5, 4);
  spec.supports = {};
  spec.loads = {.gravity = {1, -9.81, 2}, .end_force = {0.03, -0.02, 0.04}, .applied = {}};
  const Cable cable(spec);
  const Eigen::VectorXd q = cable.start_q(spec.start);
  Eigen::VectorXd f, a, scratch;
  ASSERT_EQ(cable.force(q, f), std::nullopt);
  // A straight, unstretched cable has no forces of its own.
  EXPECT_LE((f - cable.external_force()).norm(), 1e-14 * f.norm());
  ASSERT_EQ(cable.acceleration({Sum(q), {}, {}}, a, scratch), std::nullopt);
  Eigen::VectorXd inertia;
  cable.mass().multiply(a, inertia);
  EXPECT_LE((inertia - cable.external_force()).norm(), 1e-13 * f.norm());
}

}  // namespace load_test
}  // namespace plumb
