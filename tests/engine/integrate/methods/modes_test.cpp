#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/model/cable.h"
#include "engine/model/small_motions.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace modes_test {

constexpr double pi = std::numbers::pi;
constexpr double turn = 2 * pi;

/// The modes of a case: so many, about its equilibrium or about its start.
Trajectory modes(const Case& spec, int count, bool about_start = false) {
  MethodSpec with = method("modes", {});
  with.parameters["count"] = count;
  with.parameters["about"] = about_start ? 1 : 0;
  return run(spec, with, {1, 1});
}

/// A round steel wire along x, at rest.
Case wire(double length, double radius, int elements, Support first, Support last) {
  Case spec;
  spec.title = "wire";
  spec.cable.length = length;
  spec.cable.area = pi * radius * radius;
  spec.cable.second_moment = spec.cable.area * spec.cable.area / (4 * pi);
  spec.cable.density = 7800;
  spec.cable.youngs_modulus = 2e11;
  spec.cable.elements = elements;
  spec.supports = {first, last};
  return spec;
}

double EI(const Case& spec) {
  return spec.cable.youngs_modulus * spec.cable.second_moment;
}
double mass_per_length(const Case& spec) {
  return spec.cable.density * spec.cable.area;
}

/// The stretch at which Green's bar pulls with so many N.
double stretch_under(double tension, const Case& spec) {
  const double EA = spec.cable.youngs_modulus * spec.cable.area;
  double stretch = 1;
  for (int i = 0; i < 50; ++i)
    stretch -=
        (0.5 * EA * (stretch * stretch - 1) * stretch - tension) / (0.5 * EA * (3 * stretch * stretch - 1));
  return stretch;
}

/// A taut string without bending stiffness, of that length and mass once it is pulled.
Case string_under(double tension, double length, double area, int elements) {
  Case spec = wire(length, 1, elements, Support::pinned, Support::pinned);
  spec.cable.area = area;
  spec.cable.second_moment = 0;
  spec.start.stretch = stretch_under(tension, spec);
  spec.cable.length = length / spec.start.stretch;
  spec.cable.density *= spec.start.stretch;
  return spec;
}

std::vector<double> frequencies(const Trajectory& trajectory) {
  std::vector<double> result;
  for (const VibrationMode& mode : trajectory.vibrations.modes) result.push_back(mode.frequency);
  return result;
}

// Blevins 1979, Formulas for Natural Frequency and Mode Shape, corrected, as Code_Aster's SDLL101 prints it.
TEST(Modes, PianoWireHasThePublishedFrequenciesInBothPlanesWithAndWithoutTension) {
  const std::array<double, 5> slack{4.9713, 19.8851, 44.7414, 79.5403, 124.2818};
  const std::array<double, 5> taut{5.0728, 19.9874, 44.8439, 79.6429, 124.3844};
  for (const auto& [tension, published] : {std::pair{0.0, slack}, std::pair{10.0, taut}}) {
    Case spec = wire(2, 5e-3, 96, Support::pinned, Support::pinned);
    spec.start.stretch = stretch_under(tension, spec);
    const Trajectory found = modes(spec, 10);
    ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
    ASSERT_EQ(found.vibrations.modes.size(), 10U);
    for (std::size_t k = 0; k < 10; ++k)
      // Half a unit of the last digit, and the 3e-7 by which the taut wire is longer.
      EXPECT_NEAR(frequencies(found)[k], published[k / 2], 0.5e-4 + 3e-6 * published[k / 2])
          << tension << " N, mode " << k + 1;
  }
}

// Code_Aster SDNL138.
TEST(Modes, TautStringHasThePublishedFrequencyToItsLastDigit) {
  for (const auto& [tension, published] :
       {std::pair{6171.050459855, 62.73227096}, std::pair{12345.2954376, 88.72830898}}) {
    const Trajectory found = modes(string_under(tension, 1, 5.026e-5, 40), 2);
    ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
    for (const double frequency : frequencies(found))
      EXPECT_NEAR(frequency, published, 1e-8) << tension << " N";
  }
}

// Zeros of J₀.
TEST(Modes, HangingChainHasTheFrequenciesOfItsBesselFunction) {
  Case spec = wire(1, 1e-3, 24, Support::pinned, Support::free);
  spec.cable.second_moment = 0;
  spec.start.direction = {0, 0, -1};
  spec.loads.gravity = {0, 0, -9.81};
  const Trajectory found = modes(spec, 6);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  const std::array<double, 3> exact{3.76606739, 8.64469611, 13.5521358};
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(turn * frequencies(found)[k] / exact[k / 2], 1, 2e-6) << "mode " << k + 1;
}

TEST(Modes, HangingCableIsFoundFromWhereverItStarts) {
  Case down = pendulum(5, 8);
  down.start.angular_velocity.setZero();
  down.start.direction = {0, -1, 0};
  Case across = down;
  across.start.direction = {1, 0, 0};
  const Trajectory from_below = modes(down, 6), from_beside = modes(across, 6);
  ASSERT_EQ(from_below.outcome, Outcome::completed) << from_below.message;
  ASSERT_EQ(from_beside.outcome, Outcome::completed) << from_beside.message;
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(frequencies(from_beside)[k] / frequencies(from_below)[k], 1, 1e-9) << "mode " << k + 1;
}

TEST(Modes, BeamFrequenciesConvergeWithTheFourthOrderOfTheMesh) {
  struct Known {
    const char* what;
    Support first, last;
    std::size_t mode;
    double root;  // βL
  };
  for (const Known& known : {Known{"clamped-free, first", Support::clamped, Support::free, 0, 1.87510406871},
                             Known{"clamped-free, third", Support::clamped, Support::free, 4, 7.85475743824},
                             Known{"free-free, second", Support::free, Support::free, 7, 7.85320462410}}) {
    std::string seen = known.what;
    double previous = 0;
    for (const int elements : {8, 16, 32}) {
      const Case spec = wire(2, 5e-3, elements, known.first, known.last);
      const Trajectory found = modes(spec, static_cast<int>(known.mode) + 2);
      ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
      const double exact = known.root * known.root / 4 * std::sqrt(EI(spec) / mass_per_length(spec)) / turn;
      const double error = frequencies(found)[known.mode] / exact - 1;
      seen += fmt::format("\n  {} elements: {:.3g} too high", elements, error);
      EXPECT_GT(error, 0) << seen;
      if (previous > 0) {
        const double order = std::log2(previous / error);
        seen += fmt::format(", order {:.2f}", order);
        EXPECT_GT(order, 3.8) << seen;
        EXPECT_LT(order, 4.3) << seen;
      }
      previous = error;
    }
  }
}

TEST(Modes, FreeCableHasFiveRigidBodyMotionsAndThenBends) {
  const Case spec = wire(2, 5e-3, 48, Support::free, Support::free);
  const Trajectory found = modes(spec, 9);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  EXPECT_EQ(found.vibrations.rigid_body, 5) << "it has no torsion";
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(found.vibrations.modes[k].kind, ModeKind::rigid_body) << k;
    EXPECT_EQ(frequencies(found)[k], 0) << k;
  }
  const double unit = std::sqrt(EI(spec) / mass_per_length(spec)) / 4 / turn;
  for (const auto& [k, root] :
       {std::pair{5, 4.73004074486}, {6, 4.73004074486}, {7, 7.85320462410}, {8, 7.85320462410}})
    EXPECT_NEAR(frequencies(found)[static_cast<std::size_t>(k)] / (root * root * unit), 1, 1e-6) << k;
}

/// The frequency and the displacement of the last end of a rotating beam's first two modes, in units of
/// √(EI/ρA L⁴): in the plane and across.
TEST(Modes, RotatingBeamFlapsAndSwingsAsTheTableHasIt) {
  const std::array<double, 5> flap{3.51601527, 3.68164681, 4.13731957, 4.79727853, 5.58500142};
  for (int eta = 0; eta <= 4; ++eta) {
    Case spec = wire(2, 1e-3, 24, Support::clamped, Support::free);
    const double unit = std::sqrt(EI(spec) / mass_per_length(spec)) / 4;
    spec.start.angular_velocity = {0, 0, eta * unit};
    const Trajectory found = modes(spec, 2);
    ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
    const double exact = flap[static_cast<std::size_t>(eta)];
    const double in_plane = std::sqrt(exact * exact - eta * eta);
    EXPECT_NEAR(turn * frequencies(found)[0] / unit, in_plane, 1e-5) << "in the plane, η = " << eta;
    EXPECT_NEAR(turn * frequencies(found)[1] / unit, exact, 2e-6) << "across, η = " << eta;
    if (eta == 0) continue;
    EXPECT_NEAR(found.vibrations.spin, eta * unit, 1e-12 * eta * unit);
    const auto tip = [&](std::size_t k) -> Vec3 {
      return found.vibrations.modes[k].shape.tail<6>().head<3>();
    };
    EXPECT_LT(std::abs(tip(0).z()), 1e-6 * tip(0).norm()) << "it swings in the plane it turns in";
    EXPECT_LT(std::abs(tip(1).y()), 1e-6 * tip(1).norm()) << "it flaps across";
  }
}

// ω = Ω √(n (2n − 1)) across; ω² − Ω² is that in the plane, where the first is a turn about the axis.
TEST(Modes, RotatingStringHasTheFrequenciesOfLegendresPolynomials) {
  Case spec = wire(2, 1e-3, 16, Support::pinned, Support::free);
  spec.cable.second_moment = 0;
  const double spin = 5;
  spec.start.angular_velocity = {0, 0, spin};
  const Trajectory found = modes(spec, 6);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  EXPECT_EQ(found.vibrations.rigid_body, 1) << "the turn about the axis of the spin";
  const std::array<double, 6> squares{0, 1, 5, 6, 14, 15};
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(turn * frequencies(found)[k] / spin, std::sqrt(squares[k]), 3e-6) << "mode " << k + 1;
}

// A rod that whirls about itself loses ρA Ω² of its stiffness across, and Coriolis's forces couple both
// planes.
TEST(Modes, ShaftThatTurnsAboutItselfWhirlsAtTheFrequenciesSpunApart) {
  Case spec = wire(2, 5e-3, 16, Support::pinned, Support::pinned);
  const double still = frequencies(modes(spec, 1)).front();
  spec.start.angular_velocity = {0.25 * turn * still, 0, 0};
  const Trajectory found = modes(spec, 2);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  EXPECT_NEAR(frequencies(found)[0] / still, 0.75, 1e-6) << "forward, as seen from the frame";
  EXPECT_NEAR(frequencies(found)[1] / still, 1.25, 1e-6) << "backward";
}

TEST(Modes, DampingInProportionMovesExponentsAsItsClosedFormHasIt) {
  Case spec = wire(2, 5e-3, 12, Support::pinned, Support::pinned);
  const std::vector<double> undamped = frequencies(modes(spec, 6));
  const double by_mass = 3, of_material = 2e-3;
  spec.damping = {by_mass, of_material};
  const Trajectory found = modes(spec, 6);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  for (std::size_t k = 0; k < 6; ++k) {
    const double omega = turn * undamped[k], ratio = 0.5 * (by_mass / omega + of_material * omega);
    const VibrationMode& mode = found.vibrations.modes[k];
    EXPECT_EQ(mode.kind, ModeKind::vibration) << k;
    EXPECT_NEAR(mode.damping_ratio, ratio, 1e-8 * ratio) << k;
    EXPECT_NEAR(turn * mode.frequency, omega * std::sqrt(1 - ratio * ratio), 1e-8 * omega) << k;
    EXPECT_NEAR(mode.decay, ratio * omega, 1e-8 * omega) << k;
  }
}

TEST(Modes, OverdampedModesAreNamedAndComeBackByTheSlowerExponent) {
  Case spec = wire(2, 5e-3, 12, Support::pinned, Support::pinned);
  const double omega = turn * frequencies(modes(spec, 2)).front(), ratio = 1.6;
  spec.damping.mass = 2 * ratio * omega;
  const Trajectory found = modes(spec, 2);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  for (const VibrationMode& mode : found.vibrations.modes) {
    EXPECT_EQ(mode.kind, ModeKind::overdamped);
    EXPECT_EQ(mode.frequency, 0);
    EXPECT_NEAR(mode.damping_ratio, ratio, 1e-8);
    EXPECT_NEAR(mode.decay, omega * (ratio - std::sqrt(ratio * ratio - 1)), 1e-8 * omega);
  }
}

TEST(Modes, FreeCableKeepsItsRigidBodyMotionsUnderDamping) {
  Case spec = wire(2, 5e-3, 12, Support::free, Support::free);
  spec.damping = {3, 1e-3};
  const Trajectory found = modes(spec, 7);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  EXPECT_EQ(found.vibrations.rigid_body, 5);
  for (std::size_t k = 5; k < 7; ++k) EXPECT_EQ(found.vibrations.modes[k].kind, ModeKind::vibration);
}

// A point mass m at the end of a massless bar: ω² = 3EI/(m L³), with 33/140 of the bar's own.
TEST(Modes, MassAtTheEndSlowsTheCantileverAsRayleighHasIt) {
  Case spec = wire(2, 5e-3, 8, Support::clamped, Support::free);
  const double own = mass_per_length(spec) * 2, mass = 500 * own;
  spec.masses = {{1, mass}};
  const Trajectory found = modes(spec, 2);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  const double exact = std::sqrt(3 * EI(spec) / (8 * (mass + own * 33 / 140)));
  for (const double frequency : frequencies(found)) EXPECT_NEAR(turn * frequency / exact, 1, 1e-6);
}

/// A cable of any kind: bent or not, held in some way, with loads and masses, about a state of no rest.
Case random_case(std::mt19937& random, int elements) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  Case spec = wire(between(0.5, 3), between(1e-3, 1e-2), elements,
                   std::array{Support::pinned, Support::clamped}[random() % 2],
                   std::array{Support::free, Support::pinned, Support::clamped}[random() % 3]);
  spec.cable.youngs_modulus = std::pow(10, between(7, 9));
  spec.cable.quadrature = random() % 2 ? QuadratureRule::full : QuadratureRule::reduced;
  spec.cable.strain = random() % 2 ? StrainModel::green_geometric : StrainModel::engineering_material;
  spec.start.stretch = between(1.01, 1.1);
  spec.start.direction = Vec3(between(-1, 1), between(-1, 1), 1.5).normalized();
  if (random() % 2) spec.masses = {{between(0.1, 0.9), between(0.1, 2)}};
  return spec;
}

TEST(Modes, AgreeWithADenseSolutionOfRandomSmallCables) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    const int elements = 1 + static_cast<int>(random() % 6);
    const Case spec = random_case(random, elements);
    const int count = std::min(8, 6 * elements - 4);
    const Trajectory found = modes(spec, count, true);
    const Cable cable(spec);
    BlockTridiagonal K(cable.nodes()), M(cable.nodes());
    cable.system(cable.start_q(spec.start), 0, 1, K);
    cable.system(cable.start_q(spec.start), 1, 0, M);
    // An orthonormal basis of what the supports leave free.
    Eigen::MatrixXd P = Eigen::MatrixXd::Identity(cable.size(), cable.size());
    for (Eigen::Index k = 0; k < P.cols(); ++k) {
      Eigen::VectorXd x = P.col(k);
      cable.supports().apply(x);
      P.col(k) = x;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> projection(P);
    const auto free = (projection.eigenvalues().array() > 0.5).count();
    const Eigen::MatrixXd B = projection.eigenvectors().rightCols(free);
    const Eigen::VectorXd squares = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                                        B.transpose() * K.dense() * B, B.transpose() * M.dense() * B)
                                        .eigenvalues();
    ASSERT_EQ(static_cast<int>(found.vibrations.modes.size()), std::min<int>(count, static_cast<int>(free)))
        << "trial " << trial << ": " << found.message;
    ASSERT_GT(squares[0], 0) << "trial " << trial;
    const double round_off = 1e-14 * squares[free - 1];
    for (int k = 0; k < count; ++k)
      EXPECT_NEAR(std::pow(turn * frequencies(found)[static_cast<std::size_t>(k)], 2), squares[k],
                  1e-9 * squares[k] + round_off)
          << "trial " << trial << ", " << elements << " elements, mode " << k + 1 << " of " << free;
    EXPECT_LT(found.vibrations.orthonormality, 1e-10) << "trial " << trial;
  }
}

TEST(Modes, SolveTheirEquationAndAreOrthonormalInTheMasses) {
  Case spec = wire(2, 5e-3, 16, Support::pinned, Support::pinned);
  spec.cable.youngs_modulus = 2e8;
  spec.loads.gravity = {0, -9.81, 0};
  const Trajectory found = modes(spec, 8);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  const Cable cable(spec);
  const SmallMotions motions(cable, found.q.front(), 1);
  Eigen::VectorXd Kx, Mx;
  for (std::size_t i = 0; i < 8; ++i) {
    const VibrationMode& mode = found.vibrations.modes[i];
    EXPECT_LT(mode.residual, 1e-6) << "mode " << i + 1;
    motions.stiffness_times(mode.shape, Kx);
    motions.mass_times(mode.shape, Mx);
    const double square = std::pow(turn * mode.frequency, 2);
    EXPECT_LT((Kx - square * Mx).norm(), 1e-6 * Kx.norm()) << "mode " << i + 1 << ", in m and kg";
    for (std::size_t j = 0; j <= i; ++j)
      EXPECT_NEAR(found.vibrations.modes[j].shape.dot(Mx), i == j ? 1 : 0, 1e-10)
          << i + 1 << " and " << j + 1;
  }
}

TEST(Modes, OfOneFrequencyComeAlongTheAxes) {
  const Trajectory found = modes(wire(2, 5e-3, 8, Support::pinned, Support::pinned), 6);
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::VectorXd& shape = found.vibrations.modes[k].shape;
    const Eigen::Index axis = k % 2 == 0 ? 1 : 2;
    for (Eigen::Index at = 0; at < shape.size(); at += 3)
      EXPECT_LT((shape.segment<3>(at) - shape[at + axis] * Vec3::Unit(axis)).norm(), 1e-7 * shape.norm())
          << "mode " << k + 1 << ", coordinate " << at;
  }
}

TEST(Modes, OfOneFrequencyComeAlongTheAxesAlsoWhereDampedAndCutOffBetween) {
  Case spec = wire(2, 5e-3, 8, Support::pinned, Support::pinned);
  spec.damping.material = 1e-3;
  const Trajectory found = modes(spec, 3);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  ASSERT_EQ(found.vibrations.modes.size(), 3U);
  const Eigen::VectorXd& shape = found.vibrations.modes[2].shape;
  for (Eigen::Index at = 0; at < shape.size(); at += 3)
    EXPECT_LT((shape.segment<3>(at) - shape[at + 1] * Vec3::UnitY()).norm(), 1e-6 * shape.norm()) << at;
}

TEST(Modes, ScaleWithTheUnitsOfTheirCase) {
  Case spec = wire(2, 5e-3, 8, Support::clamped, Support::pinned);
  const std::vector<double> before = frequencies(modes(spec, 4));
  // A thousandth as long, of the same stuff.
  Case small = spec;
  small.cable.length *= 1e-3;
  small.cable.area *= 1e-6;
  small.cable.second_moment *= 1e-12;
  const Trajectory found = modes(small, 4);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(frequencies(found)[k] / (1e3 * before[k]), 1, 1e-9) << "mode " << k + 1;
}

TEST(Modes, TellAnEquilibriumThatTheCableWouldLeave) {
  Case pressed = wire(2, 5e-3, 8, Support::pinned, Support::pinned);
  pressed.start.stretch =
      1 - 1.5 * EI(pressed) * pi * pi / 4 / (pressed.cable.youngs_modulus * pressed.cable.area);
  const Trajectory found = modes(pressed, 4, true);
  EXPECT_EQ(found.outcome, Outcome::unstable_equilibrium);
  EXPECT_NE(found.message.find("2 negative eigenvalues"), std::string::npos) << found.message;
  ASSERT_EQ(found.vibrations.modes.size(), 4U);
  // ω² = (nπ/L)² (EI (nπ/L)² − P)/ρA.
  const double decay = pi / 2 * std::sqrt(0.5 * EI(pressed) * pi * pi / 4 / mass_per_length(pressed));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(found.vibrations.modes[k].kind, ModeKind::growing) << k;
    EXPECT_NEAR(found.vibrations.modes[k].decay / -decay, 1, 1e-3) << k;
  }
  EXPECT_EQ(found.vibrations.modes[2].kind, ModeKind::vibration);
  Case upright = pendulum(5, 4);
  upright.start.angular_velocity.setZero();
  upright.start.direction = {0, 1, 0};
  EXPECT_EQ(modes(upright, 2).outcome, Outcome::unstable_equilibrium);
}

TEST(Modes, SaySoWhereNothingIsAtRest) {
  Case falling = wire(2, 5e-3, 4, Support::free, Support::free);
  falling.loads.gravity = {0, 0, -9.81};
  const Trajectory found = modes(falling, 4);
  EXPECT_NE(found.outcome, Outcome::completed);
  EXPECT_FALSE(found.message.empty());
  EXPECT_TRUE(found.vibrations.modes.empty());
  EXPECT_EQ(modes(falling, 4, true).vibrations.rigid_body, 4)
      << "about its start there are as many as asked for";
}

TEST(Modes, NameWhatNothingResists) {
  Case spec = wire(2, 5e-3, 6, Support::pinned, Support::pinned);
  spec.cable.model = CableModel::chain;
  const Trajectory found = modes(spec, 12);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  ASSERT_EQ(found.vibrations.modes.size(), 12U);
  for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(found.vibrations.modes[k].kind, ModeKind::slack) << k;
  // Half a mass at either end of each link: ω = 2 (c/l) sin(nπ/2N) along it.
  const double c = std::sqrt(spec.cable.youngs_modulus / spec.cable.density);
  EXPECT_NEAR(turn * frequencies(found)[10], 2 * c * 3 * std::sin(pi / 12), 1e-6 * c);
}

TEST(Modes, CableOfTwentyThousandElementsHasItsFirstFrequencies) {
  const Case spec = wire(2, 5e-3, 20'000, Support::pinned, Support::pinned);
  const Trajectory found = modes(spec, 2);
  ASSERT_EQ(found.outcome, Outcome::completed) << found.message;
  const double exact = pi / 8 * std::sqrt(EI(spec) / mass_per_length(spec));
  for (const double frequency : frequencies(found)) EXPECT_NEAR(frequency / exact, 1, 1e-5);
}

TEST(Modes, FollowerLoadMakesTheCantileverFlutterBeyondBecksLoad) {
  // Beck 1952: the column under a load along its end flutters from 20.05 EI/L² on.
  Case spec = wire(1, 5e-3, 12, Support::clamped, Support::free);
  const auto under = [&](double load) {
    spec.loads.applied = {{LoadKind::force, 1, {-load * EI(spec), 0, 0}, true, "1"}};
    return modes(spec, 4);
  };
  const Trajectory below = under(19.8), beyond = under(20.3);
  EXPECT_EQ(below.outcome, Outcome::completed) << below.message;
  EXPECT_EQ(beyond.outcome, Outcome::unstable_equilibrium) << beyond.message;
  ASSERT_FALSE(beyond.vibrations.modes.empty());
  EXPECT_EQ(beyond.vibrations.modes.front().kind, ModeKind::growing);
  EXPECT_GT(beyond.vibrations.modes.front().frequency, 0) << "it grows to and fro";
}

}  // namespace modes_test
}  // namespace plumb
