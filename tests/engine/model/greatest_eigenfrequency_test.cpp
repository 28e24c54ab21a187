#include "engine/model/greatest_eigenfrequency.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <random>

#include "engine/base/dense.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace greatest_eigenfrequency_test {

double speed_of_sound(const Case& spec) {
  return std::sqrt(spec.cable.youngs_modulus / spec.cable.density);
}

/// By a dense decomposition, on the coordinates that the supports leave; no clamped end may lie oblique.
double dense_frequency(const Cable& cable, const Eigen::VectorXd& q) {
  BlockTridiagonal K(cable.nodes()), M(cable.nodes());
  cable.system(q, 0, 1, K);
  cable.system(q, 1, 0, M);
  std::vector<int> kept;
  for (int i = 0; i < cable.size(); ++i) {
    Eigen::VectorXd unit = Eigen::VectorXd::Unit(cable.size(), i);
    cable.supports().apply(unit);
    if (unit[i] != 0) kept.push_back(i);
  }
  const Eigen::MatrixXd k = K.dense()(kept, kept), m = M.dense()(kept, kept);
  const double greatest = symmetric_eigen(k, m).values.maxCoeff();
  return std::sqrt(std::max(greatest, 0.0));
}

Eigen::VectorXd disturbed(const Cable& cable, const Case& spec, double by, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd q = cable.start_q(spec.start);
  for (Eigen::Index i = 0; i < q.size(); ++i)
    q[i] += by * (i % 6 < 3 ? cable.element().length() : 1) * normal(random);
  return q;
}

// Closed form: the vibration of the free end of a long cable of cubic elements.
TEST(FastestVibration, OfTheStraightPinnedCableIsAtItsFreeEnd) {
  for (const double f : {1.0, 5.0})
    for (const int elements : {4, 8, 16, 32}) {
      const Case spec = pendulum(f, elements);
      const Cable cable(spec);
      const FastestVibration fastest = fastest_vibration(cable, cable.start_q(spec.start));
      const double scaled = fastest.frequency * cable.element().length() / speed_of_sound(spec);
      EXPECT_NEAR(scaled, 9.548, elements == 4 ? 3e-3 : 5e-4) << "f = " << f << ", elements " << elements;
      EXPECT_EQ(fastest.element, elements - 1);
    }
}

TEST(FastestVibration, IsThatOfTheDensePairAtRandomStates) {
  for (const int elements : {1, 2, 5, 12})
    for (const Support last : {Support::free, Support::pinned, Support::clamped})
      for (const double by : {0.0, 0.01, 0.1, 0.3}) {
        Case spec = pendulum(5, elements);
        spec.supports.last = last;
        const Cable cable(spec);
        const Eigen::VectorXd q = disturbed(cable, spec, by, 7);
        const double exact = dense_frequency(cable, q);
        EXPECT_NEAR(fastest_vibration(cable, q).frequency, exact, 1e-6 * exact)
            << elements << " elements, last end " << word(last) << ", disturbed by " << by;
      }
}

TEST(FastestVibration, HasAShapeOfUnitMassThatTheSupportsAllowAndThatSolvesThePair) {
  Case spec = pendulum(5, 6);
  spec.supports = {Support::clamped, Support::pinned};
  spec.start.direction = Vec3(1, 2, -2) / 3;
  const Cable cable(spec);
  const Eigen::VectorXd q = disturbed(cable, spec, 0.05, 3);
  const FastestVibration fastest = fastest_vibration(cable, q);
  Eigen::VectorXd inertia, admissible = fastest.shape, force;
  cable.mass().multiply(fastest.shape, inertia);
  EXPECT_NEAR(fastest.shape.dot(inertia), 1, 1e-9);
  cable.supports().apply(admissible);
  EXPECT_LE((admissible - fastest.shape).norm(), 1e-12 * fastest.shape.norm());
  BlockTridiagonal K(cable.nodes());
  cable.system(q, 0, 1, K);
  K.multiply(fastest.shape, force);
  force -= fastest.frequency * fastest.frequency * inertia;
  cable.supports().apply(force);
  EXPECT_LE(force.norm(), 1e-5 * fastest.frequency * fastest.frequency * inertia.norm());
}

TEST(FastestVibration, OfAChainIsThatOfItsLinks) {
  for (const int links : {1, 2, 7}) {
    Case spec = pendulum(5, links);
    spec.cable.model = CableModel::chain;
    spec.cable.second_moment = 0;
    const Cable cable(spec);
    const Eigen::VectorXd straight = cable.start_q(spec.start), bent = disturbed(cable, spec, 0.1, 5);
    for (const Eigen::VectorXd& q : {straight, bent}) {
      const double exact = dense_frequency(cable, q);
      EXPECT_NEAR(fastest_vibration(cable, q).frequency, exact, 1e-6 * exact) << links;
    }
    // One spring k = EA/l with half of a link's mass m at its free end.
    if (links == 1) {
      EXPECT_NEAR(fastest_vibration(cable, straight).frequency, std::sqrt(2) * speed_of_sound(spec), 1e-6);
    }
  }
}

// A cable in compression has a stiffness that is not positive definite.
TEST(FastestVibration, IsFoundWhereTheStiffnessIsIndefinite) {
  const Case spec = pendulum(5, 6);
  const Cable cable(spec);
  Eigen::VectorXd pressed = 0.8 * cable.start_q(spec.start);
  const double exact = dense_frequency(cable, pressed);
  EXPECT_NEAR(fastest_vibration(cable, pressed).frequency, exact, 1e-6 * exact);
}

TEST(FastestVibration, IsNoneOfAStateThatIsNotFinite) {
  const Case spec = pendulum(5, 6);
  const Cable cable(spec);
  Eigen::VectorXd q = cable.start_q(spec.start);
  q[9] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fastest_vibration(cable, q).frequency, 0);
  EXPECT_EQ(fastest_vibration(cable, q).shape.norm(), 0);
}

// What a dense pair of this size would need is 10 GB.
TEST(FastestVibration, OfAFineCableTakesNoLongerThanItsLength) {
  const Case spec = pendulum(20, 4096);
  const Cable cable(spec);
  const std::clock_t started = std::clock();
  const double frequency = fastest_vibration(cable, cable.start_q(spec.start)).frequency;
  const double taken = static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
  // Bending is the fastest in so fine a mesh, as 1/l²: four times as fast in one twice as fine.
  const Case coarse_spec = pendulum(20, 2048);
  const Cable coarse(coarse_spec);
  const double coarse_frequency = fastest_vibration(coarse, coarse.start_q(coarse_spec.start)).frequency;
  EXPECT_NEAR(frequency / coarse_frequency, 4, 1e-3);
  EXPECT_LT(taken, 5) << "s of the processor";
}

}  // namespace greatest_eigenfrequency_test
}  // namespace plumb
