#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/model/cable.h"
#include "engine/model/compression_limit.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace statics_test {

/// At rest along x, unloaded, without gravity, with its first end clamped.
Case cantilever(double length, double area, double second_moment, double youngs_modulus, int elements) {
  Case spec;
  spec.title = "statics";
  spec.cable = {.length = length,
                .area = area,
                .density = 1000,
                .youngs_modulus = youngs_modulus,
                .second_moment = second_moment,
                .elements = elements};
  spec.supports.first = Support::clamped;
  return spec;
}

Trajectory settle(const Case& spec, int load_steps) {
  return run(spec, method("statics", 1.0 / load_steps), {1, 1});
}

// Gerstmayr and Irschik (2008) print 0.5089228704 and 1.2083981311 for Green's strain; all figures are those
// of a shooting solution of the continuum.
TEST(Statics, CantileverBendsAsTheContinuumDoesAtTheOrderOfTheMesh) {
  struct Known {
    StrainModel strain;
    double ux, uy;
  };
  for (const Known& known : {Known{StrainModel::green_geometric, 0.508922870415, 1.208398131108},
                             Known{StrainModel::engineering_material, 0.508537304326, 1.207239854550}}) {
    std::string seen(word(known.strain));
    double previous = 0, error = 0;
    for (const int elements : {16, 32, 64}) {
      const double I = 1e-4 / 12, E = 2.07e11;
      Case spec = cantilever(2, 1e-2, I, E, elements);
      spec.cable.strain = known.strain;
      spec.loads.end_force = {0, 3 * E * I / 4, 0};
      const Trajectory trajectory = settle(spec, 4);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
      error = std::hypot(2 - tip(trajectory).x() - known.ux, tip(trajectory).y() - known.uy);
      seen += fmt::format("\n  {} elements: tip {:.3g} m off", elements, error);
      if (previous > 0) {
        const double order = std::log2(previous / error);
        seen += fmt::format(", order {:.2f}", order);
        // From above: the coarse meshes are not yet where their error is its leading term.
        EXPECT_GT(order, 3.85) << seen;
        EXPECT_LT(order, elements == 64 ? 4.5 : 5.2) << seen;
      }
      previous = error;
    }
    EXPECT_LE(error, 3e-9) << seen;
  }
}

// Mattiasson (1981), by elliptic integrals, to five digits.
TEST(Statics, TransverseTipForceMakesTheElastica) {
  for (const auto& [alpha, w, u] : {std::tuple{1.0, 0.30172, 0.05643},
                                    {2.0, 0.49346, 0.16064},
                                    {5.0, 0.71379, 0.38763},
                                    {10.0, 0.81061, 0.55500}}) {
    Case spec = cantilever(1, 1, 1e-8, 1, 32);        // EA L²/EI = 1e8: as good as inextensible
    spec.cable.quadrature = QuadratureRule::reduced;  // the full one locks at that
    spec.loads.end_force = {0, 0, alpha * 1e-8};
    const Trajectory trajectory = settle(spec, 5);
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    EXPECT_NEAR(tip(trajectory).z(), w, 6e-6) << "α = " << alpha;
    EXPECT_NEAR(1 - tip(trajectory).x(), u, 6e-6) << "α = " << alpha;
  }
}

TEST(Statics, HangingCableStretchesByHalfOfItsWeight) {
  Case spec = pendulum(5, 4);
  spec.cable.strain = StrainModel::engineering_material;
  spec.start = {.direction = {0, -1, 0}};
  spec.supports.first = Support::clamped;
  const Trajectory trajectory = settle(spec, 3);
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  EXPECT_NEAR(-tip(trajectory).y() - 1, 8e-3 * 9.81 / (2 * 40), 1e-12);  // ρA g L²/(2EA)
}

// Code_Aster, SSNL114: a sag of 6.352 m; the closed form of the elastic catenary gives 6.35216.
TEST(Statics, CableBetweenTwoPinsSagsAsTheElasticCatenary) {
  Case spec = cantilever(325, 2.2783e-4, 1e-11, 5.7e10, 32);
  spec.cable.strain = StrainModel::engineering_material;
  spec.cable.density = 2844.23;
  spec.supports = {Support::pinned, Support::pinned};
  spec.loads.gravity = {0, -9.81, 0};
  const Trajectory trajectory = settle(spec, 10);
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  EXPECT_NEAR(-Cable(spec).at(trajectory.q.back(), 0.5).position.y(), 6.35216, 5e-5);
}

TEST(Statics, LoadGrowsInProportionToTimeAndOutputsBetweenStepsFollowIt) {
  Case spec = cantilever(2, 1e-2, 1e-5, 1e6, 3);
  spec.cable.strain = StrainModel::engineering_material;
  spec.loads.end_force = {500, 0, 0};  // a strain of 0.05
  const Trajectory trajectory = run(spec, method("statics", 1), {4, 0.5});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  EXPECT_EQ(trajectory.counters.steps, 4);
  EXPECT_EQ(trajectory.interpolated_outputs, 4);
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    EXPECT_NEAR(tip(trajectory, k).x(), 2 * (1 + 0.05 * trajectory.times[k] / 4), 1e-12);
    EXPECT_EQ(trajectory.v[k].norm(), 0);
  }
}

TEST(Statics, OutputsBetweenLoadStepsAreEquilibriaToo) {
  Case spec = cantilever(1, 1e-2, 1e-5, 1e6, 8);
  spec.loads.end_force = {0, 50, 0};
  const Trajectory coarse = run(spec, method("statics", 0.5), {1, 0.125});
  const Trajectory fine = run(spec, method("statics", 0.125), {1, 0.125});
  ASSERT_EQ(coarse.outcome, Outcome::completed) << coarse.message;
  EXPECT_EQ(coarse.interpolated_outputs, 6);
  EXPECT_EQ(fine.interpolated_outputs, 0);
  EXPECT_LE(tip_distance(coarse, fine), 1e-9);
  EXPECT_GT((tip(fine) - tip(fine, 0)).norm(), 0.5) << "m: hardly bent";
}

// ½(λ³ − λ) = −0.19 has the root λ = 0.63139; it has none for −0.2.
TEST(Statics, GreenBarIsRefusedBeyondItsLimitPointByName) {
  const double EA = 1e4;
  const auto pressed = [&](double share, StrainModel strain) {
    Case spec = cantilever(1, 1e-2, 1e-2, 1e6, 2);  // too stiff to buckle first
    spec.cable.strain = strain;
    spec.loads.end_force = {-share * EA, 0, 0};
    return settle(spec, 1);
  };
  const Trajectory within = pressed(0.19, StrainModel::green_geometric);
  ASSERT_EQ(within.outcome, Outcome::completed) << within.message;
  const double stretch = tip(within).x();
  EXPECT_NEAR(0.5 * (stretch * stretch * stretch - stretch), -0.19, 1e-10) << "λ = " << stretch;
  EXPECT_GT(stretch, 1 / std::sqrt(3.0));
  const Trajectory beyond = pressed(0.2, StrainModel::green_geometric);
  EXPECT_EQ(beyond.outcome, Outcome::no_convergence) << beyond.message;
  EXPECT_NE(beyond.message.find("the Green-Lagrange bar bears at most 0.19245 EA in compression"),
            beyond.message.npos)
      << beyond.message;
  EXPECT_NE(beyond.message.find("0.2 EA"), beyond.message.npos) << beyond.message;
  const Trajectory engineering = pressed(0.2, StrainModel::engineering_material);
  ASSERT_EQ(engineering.outcome, Outcome::completed) << engineering.message;
  EXPECT_NEAR(tip(engineering).x(), 0.8, 1e-12);
}

// Near the limit point the root is almost double, and Newton's iteration halves the error for long.
TEST(Statics, ToleranceIsAShareOfTheLengthAlsoWhereConvergenceIsSlow) {
  const double EA = 1e4, share = 0.192;
  double below = 1 / std::sqrt(3.0), stretch = 1;
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double middle = 0.5 * (below + stretch);
    (0.5 * (middle * middle * middle - middle) > -share ? stretch : below) = middle;
  }
  for (const double tolerance : {1e-3, 1e-6, 1e-11}) {
    std::vector<long> iterations;
    for (const double length : {1.0, 1000.0}) {
      Case spec = cantilever(length, 1e-2, 1e-2 * length * length, 1e6, 2);  // too stiff to buckle first
      spec.cable.strain = StrainModel::green_geometric;
      spec.loads.end_force = {-share * EA, 0, 0};
      MethodSpec with = method("statics", 1);
      with.parameters["newton_tolerance"] = tolerance;
      const Trajectory trajectory = run(spec, with, {1, 1});
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
      const double error = std::abs(tip(trajectory).x() / length - stretch);
      EXPECT_LE(error, tolerance) << "of " << length << " m";
      iterations.push_back(trajectory.counters.newton_iterations);
    }
    EXPECT_EQ(iterations[0], iterations[1]) << "to " << tolerance << " of the length";
  }
}

TEST(Statics, LimitPointIsNamedWithTheLoadThatWasReached) {
  Case spec = cantilever(1, 1e-2, 1e-2, 1e6, 4);  // too stiff to buckle first
  spec.loads.end_force = {-0.25e4, 0, 0};
  const Trajectory trajectory = settle(spec, 20);
  EXPECT_EQ(trajectory.outcome, Outcome::no_convergence) << trajectory.message;
  EXPECT_EQ(trajectory.end_time, 0.75) << trajectory.message;  // 0.1875 EA; 0.2 EA is next
  EXPECT_NE(trajectory.message.find("equilibrium was reached at 0.75 of the load and not at 0.8 of it"),
            trajectory.message.npos)
      << trajectory.message;
}

TEST(Statics, WeightBeyondTheLimitPointIsNamedTooAtEitherEnd) {
  for (const bool last : {false, true}) {
    Case spec = cantilever(1, 1e-2, 1e-5, 1e6, 4);
    spec.start.direction = {0, 1, 0};
    spec.loads.gravity = {0, -0.3e4 / 10, 0};  // 10 kg; stands on its first end
    if (last) {
      spec.supports = {Support::free, Support::clamped};
      spec.loads.gravity *= -1;
    }
    const Trajectory trajectory = settle(spec, 1);
    EXPECT_EQ(trajectory.outcome, Outcome::no_convergence) << trajectory.message;
    EXPECT_NE(trajectory.message.find(last ? "element 4" : "element 1"), trajectory.message.npos)
        << trajectory.message;
    EXPECT_NE(trajectory.message.find("0.19245 EA"), trajectory.message.npos) << trajectory.message;
  }
}

TEST(Statics, OverloadIsToldForEitherFreeEndAndNotForEngineeringStrain) {
  Case spec = cantilever(1, 1e-2, 1e-5, 1e6, 4);
  spec.loads.end_force = {-0.2e4, 0, 0};
  const auto told = [&](double fraction) {
    const Cable cable(spec);
    return overloaded_element(cable, cable.start_q(spec.start), fraction);
  };
  ASSERT_TRUE(told(1).has_value());
  EXPECT_NEAR(told(1)->compression, 0.2, 1e-15);
  EXPECT_FALSE(told(0.96).has_value()) << "0.192 EA";
  spec.cable.strain = StrainModel::engineering_material;
  EXPECT_FALSE(told(1).has_value());
  spec.cable.strain = StrainModel::green_geometric;
  spec.supports = {Support::free, Support::clamped};
  EXPECT_FALSE(told(1).has_value()) << "the load goes into the support at once";
  spec.loads.end_force.setZero();
  spec.loads.gravity = {300, 0, 0};
  ASSERT_TRUE(told(1).has_value());
  EXPECT_EQ(told(1)->element, 3);
}

TEST(Statics, ABarIsPulledToMoreThanTenTimesItsLength) {
  const auto stretched = [](double strain) {
    Case spec = cantilever(1, 1e-2, 1e-5, 1e6, 1);
    spec.cable.strain = StrainModel::engineering_material;
    spec.loads.end_force = {strain * 1e4, 0, 0};
    return settle(spec, 1);
  };
  EXPECT_NEAR(tip(stretched(10.5)).x(), 11.5, 1e-9);
  EXPECT_NE(stretched(1.1e10).outcome, Outcome::completed) << stretched(1.1e10).message;
}

// Up to six times the load it buckles at.
TEST(Statics, AColumnThatIsPressedFarBeyondBucklingInOneStepIsBentAsInForty) {
  const double EI = 30;
  for (int load = 5; load <= 15; ++load) {
    Case spec = cantilever(1, 1e-2, 3e-5, 1e6, 1);
    spec.cable.strain = StrainModel::engineering_material;
    spec.loads.end_force = {-load * EI, 0.01 * load * EI, 0};
    const Trajectory at_once = settle(spec, 1), slowly = settle(spec, 40);
    ASSERT_EQ(at_once.outcome, Outcome::completed) << "load " << load << ": " << at_once.message;
    ASSERT_EQ(slowly.outcome, Outcome::completed) << "load " << load << ": " << slowly.message;
    EXPECT_LE((tip(at_once) - tip(slowly)).norm(), 1e-9) << "m, load " << load;
    EXPECT_GT(tip(slowly).y(), 0.6) << "m, load " << load << ": hardly bent";
  }
}

/// A bar along x, too stiff to buckle, under that many times EA of weight along itself, towards the free end.
Trajectory under_weight(double share, StrainModel strain, int elements, bool held_at_last) {
  Case spec = cantilever(1, 1e-2, 1e-2, 1e6, elements);
  spec.cable.strain = strain;
  spec.loads.gravity = {share * 1e3, 0, 0};  // 10 kg, EA = 1e4 N
  if (held_at_last) {
    spec.supports = {Support::free, Support::clamped};
    spec.loads.gravity *= -1;
  }
  return settle(spec, 1);
}

// Turned inside out it would be in equilibrium, and stable.
TEST(Statics, ABarThatItsWeightPressesToNothingIsRefusedWhicheverEndIsHeld) {
  for (const StrainModel strain : {StrainModel::green_geometric, StrainModel::engineering_material}) {
    for (const int elements : {1, 2}) {
      for (const bool last : {false, true}) {
        const Trajectory trajectory = under_weight(-5, strain, elements, last);
        EXPECT_NE(trajectory.outcome, Outcome::completed)
            << word(strain) << ", " << elements << " elements held at the " << (last ? "last" : "first")
            << " end, which has the free end at "
            << trajectory.q.back().segment<3>(last ? 0 : 6 * elements).transpose() << " m";
      }
    }
  }
}

// The free end then goes as far as to the other side of the origin, without an element that points back.
TEST(Statics, ABarThatItsWeightPullsIsStretchedWhicheverEndIsHeld) {
  for (const int elements : {1, 2, 8}) {
    for (const bool last : {false, true}) {
      const Trajectory trajectory = under_weight(3, StrainModel::engineering_material, elements, last);
      ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
      EXPECT_NEAR(trajectory.q.back()[last ? 0 : 6 * elements], last ? -1.5 : 2.5, 1e-9)
          << elements << " elements held at the " << (last ? "last" : "first") << " end";
    }
  }
}

TEST(Statics, CableThatNothingHoldsIsSingular) {
  const auto outcome = [](Case spec) {
    spec.loads.gravity = {0, -9.81, 0};
    const Trajectory trajectory = settle(spec, 2);
    EXPECT_NE(trajectory.message.find("the stiffness is singular"), trajectory.message.npos)
        << trajectory.message;
    EXPECT_NE(trajectory.message.find("at 0 of the load"), trajectory.message.npos) << trajectory.message;
    EXPECT_EQ(trajectory.message.find(fmt::format("element {}:", spec.cable.elements + 1)),
              trajectory.message.npos)
        << trajectory.message;
    return trajectory.outcome;
  };
  for (const int elements : {1, 4, 32}) {
    Case spec = cantilever(1, 1e-4, 1e-10, 1e8, elements);
    spec.start.direction = Vec3(3, 0, 4) / 5;
    spec.supports.first = Support::pinned;
    EXPECT_EQ(outcome(spec), Outcome::singular) << "can turn, " << elements << " elements";
    spec.supports = {Support::free, Support::free};
    EXPECT_EQ(outcome(spec), Outcome::singular) << "is free, " << elements << " elements";
    spec.supports = {Support::clamped, Support::pinned};
    spec.cable.second_moment = 0;
    EXPECT_EQ(outcome(spec), Outcome::singular) << "straight, EI = 0, " << elements << " elements";
    if (elements == 1) continue;  // a link between two pins is held
    spec.supports = {Support::pinned, Support::pinned};
    spec.cable.model = CableModel::chain;
    EXPECT_EQ(outcome(spec), Outcome::singular) << "straight chain, " << elements << " links";
  }
}

// ½(λ³ − λ) EA has its least value, −EA/(3 √3), at λ = 1/√3.
TEST(Statics, ArcLengthPassesTheLimitPointOfTheGreenBarAndNamesIt) {
  Case spec = cantilever(1, 1e-2, 1e-2, 1e6, 4);  // too stiff to buckle first
  spec.loads.end_force = {-0.2e4, 0, 0};
  MethodSpec primary = method("statics", 0.1);
  primary.parameters["follow"] = 1;
  const Trajectory run = plumb::run(spec, primary, {1, 0.1});
  EXPECT_EQ(run.outcome, Outcome::no_convergence) << run.message;
  ASSERT_EQ(run.equilibria.critical_points.size(), 1U) << run.message;
  const CriticalPoint& limit = run.equilibria.critical_points.front();
  EXPECT_EQ(word(limit.kind), "limit-point");
  EXPECT_NEAR(limit.load, green_compression_limit / 0.2, 1e-6);
  EXPECT_NEAR(limit.displacement, 1 - 1 / std::sqrt(3.0), 1e-4);
  EXPECT_EQ(limit.negative_before, 0);
  EXPECT_GT(limit.negative_after, 0);
  int unstable = 0;
  double farthest = 0;
  for (const PathPoint& point : run.equilibria.path) {
    const double stretch = 1 - point.displacement;
    EXPECT_NEAR(0.2 * point.load, -0.5 * (std::pow(stretch, 3) - stretch), 1e-8)
        << "a point of the path at a stretch of " << stretch;
    EXPECT_EQ(point.negative > 0, stretch < 1 / std::sqrt(3.0)) << "at a stretch of " << stretch;
    unstable += point.negative > 0 ? 1 : 0;
    farthest = std::max(farthest, point.displacement);
  }
  EXPECT_GE(unstable, 5);
  EXPECT_GT(farthest, 0.9) << "m: not followed far beyond the limit point";
}

// Mattiasson (1981): 0.71379 and 0.38763.
TEST(Statics, RaisingTheAxialStiffnessLeadsToTheInextensibleElastica) {
  std::string seen;
  double previous = 0;
  for (const double EA : {1e3, 1e4, 1e5, 1e8}) {
    Case spec = cantilever(1, EA, 1, 1, 32);
    spec.cable.quadrature = QuadratureRule::reduced;
    spec.loads.end_force = {0, 5, 0};
    const Trajectory trajectory = settle(spec, 1);
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
    const double error = std::hypot(tip(trajectory).y() - 0.71379, 1 - tip(trajectory).x() - 0.38763);
    seen += fmt::format("\n  EA L²/EI = {:g}: {:.3g} m off", EA, error);
    if (EA == 1e4 || EA == 1e5) {
      EXPECT_NEAR(previous / error, 10, 1.5) << seen;
    }
    previous = error;
  }
  EXPECT_LE(previous, 1e-5) << seen;
}

// An iteration that is stopped by the size of its corrections alone ends far from any equilibrium here.
TEST(Statics, ALooseToleranceLeavesNoResidual) {
  Case spec = cantilever(1, 1e-2, 1 / 4.52e8, 4.52e8, 8);
  spec.loads.end_force = {-0.608, 0.038, -0.39};
  MethodSpec loose = method("statics", 1);
  loose.parameters["newton_tolerance"] = 1e-5;
  const Trajectory trajectory = run(spec, loose, {1, 1});
  ASSERT_EQ(trajectory.outcome, Outcome::completed) << trajectory.message;
  const Cable cable(spec);
  Eigen::VectorXd residual;
  cable.force(trajectory.q.back(), residual);
  cable.supports().apply(residual);
  EXPECT_LE(residual.lpNorm<Eigen::Infinity>(), 1e-5 * spec.loads.end_force.norm()) << "N";
  EXPECT_LE(tip_distance(trajectory, run(spec, method("statics", 0.01), {1, 1})), 1e-5) << "m";
}

TEST(Statics, OutputsOfOneLargeStepAreThoseOfManySmallOnesInASlenderCable) {
  Case spec = cantilever(1, 1e-2, 1 / 3e8, 3e8, 8);
  spec.loads.end_force = {0, 8, 0};
  const Trajectory at_once = run(spec, method("statics", 1), {1, 0.05});
  const Trajectory slowly = run(spec, method("statics", 0.01), {1, 0.05});
  ASSERT_EQ(at_once.outcome, Outcome::completed) << at_once.message;
  EXPECT_EQ(at_once.interpolated_outputs, 19);
  EXPECT_LE(tip_distance(at_once, slowly), 1e-9) << "m";
}

TEST(Statics, PotentialEnergyIsThatOfTheLoadThatActs) {
  Case spec = cantilever(1, 1e-4, 1e-9, 1e7, 4);
  spec.loads.end_force = {0, 0.01, 0};
  const Trajectory done = run(spec, method("statics", 0.5), {1, 0.25});
  ASSERT_EQ(done.outcome, Outcome::completed) << done.message;
  ASSERT_EQ(done.interpolated_outputs, 2);
  for (std::size_t k = 0; k < done.times.size(); ++k) {
    const double work = -done.times[k] * 0.01 * tip(done, k).y();
    EXPECT_NEAR(done.energies[k].potential, work, 1e-12 * std::abs(work)) << "at " << done.times[k];
    EXPECT_EQ(done.energies[k].interpolation, 0) << "an equilibrium is no interpolation";
    // A small load does half of its work on the way, which is stored as strain energy.
    if (k > 0) {
      EXPECT_NEAR(done.energies[k].total() / done.energies[k].potential, 0.5, 0.1);
    }
  }
}

TEST(Statics, RefusesAMeshOnWhichEquilibriaAreRoundOff) {
  Case spec = cantilever(1, 1e-4, 8e-10, 1e7, 40000);
  spec.loads.end_force = {0, 0.1, 0};
  const Trajectory done = settle(spec, 1);
  EXPECT_EQ(done.outcome, Outcome::no_convergence);
  EXPECT_NE(done.message.find("the mesh is too fine"), std::string::npos) << done.message;
  EXPECT_EQ(done.message.find("more elements"), std::string::npos) << done.message;
  EXPECT_LE(done.counters.factorizations, 10) << "it is known at the start";
}

TEST(Statics, GivesUpSoonWhereRoundOffHidesThePath) {
  Case spec = cantilever(1, 1e-4, 8e-10, 1e7, 8000);
  spec.loads.end_force = {-0.1, 0, 0};  // five times what it bears
  const Trajectory done = settle(spec, 1);
  if (done.outcome == Outcome::no_convergence) {
    EXPECT_NE(done.message.find("the mesh is too fine"), std::string::npos) << done.message;
  } else {
    EXPECT_EQ(done.outcome, Outcome::completed) << done.message;
    EXPECT_EQ(done.equilibria.negative_eigenvalues.back(), 0);
  }
  EXPECT_LE(done.counters.newton_iterations, 700);
}

}  // namespace statics_test
}  // namespace plumb
