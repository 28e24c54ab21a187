#include "engine/kernels/kernels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <random>

#include "engine/model/block_tridiagonal.h"
#include "engine/model/hermite.h"
#include "engine/model/mass.h"
#include "tests/engine/model/plain_element.h"

namespace plumb {
namespace kernels_test {

constexpr double EA = 40, EI = 7.96e-5, cable_length = 1, mass_per_length = 8e-3;
constexpr double gravity[] = {30, -981, 200};  // strong, so that it counts beside the elastic forces

/// Forces on the first node, one between and the last.
class Loads {
 public:
  explicit Loads(int elements) {
    for (const int node : {0, elements / 2, elements})
      if (forces_.empty() || forces_.back().node != node)
        forces_.push_back({node, {0.1 + node, -0.2, 0.3, 1e-3, 2e-3, -3e-3}});
  }

  operator NodeForces() const { return {forces_.data(), static_cast<int>(forces_.size())}; }

  void add_to(Eigen::VectorXd& f) const {
    for (const NodeForce& on : forces_)
      f.segment<6>(6 * on.node) += Eigen::Map<const Eigen::Matrix<double, 6, 1>>(on.force);
  }

 private:
  std::vector<NodeForce> forces_;
};

/// A chain of elements, straight but for `spread` (a share of the element length, and of the unit slope).
Eigen::VectorXd chain(int elements, double spread, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double l = cable_length / elements;
  Eigen::VectorXd q(6 * (elements + 1));
  for (int node = 0; node <= elements; ++node)
    for (int k = 0; k < 3; ++k) {
      q[6 * node + k] = (k == 0 ? node * l : 0) + spread * l * unit(generator);
      q[6 * node + 3 + k] = (k == 0 ? 1 : 0) + spread * unit(generator);
    }
  return q;
}

/// ∫ ρA sᵢ g dx by a rule that is exact for cubic functions.
Eigen::VectorXd weight(int elements) {
  const double l = cable_length / elements;
  Eigen::VectorXd f = Eigen::VectorXd::Zero(6 * (elements + 1));
  for (int e = 0; e < elements; ++e)
    for (const QuadraturePoint& p : gauss_rule(2)) {
      const auto shape = Hermite::values(p.x, l);
      for (int i = 0; i < 4; ++i)
        f.segment<3>(6 * e + 3 * i) += mass_per_length * l * p.weight * shape[static_cast<std::size_t>(i)] *
                                       Vec3(gravity[0], gravity[1], gravity[2]);
    }
  return f;
}

using Model = std::tuple<StrainModel, QuadratureRule>;

class KernelsOf : public testing::TestWithParam<Model> {
 protected:
  PlainElement element(int elements) const {
    return {EA, EI, cable_length / elements, std::get<0>(GetParam()), std::get<1>(GetParam())};
  }
  ElementConstants constants(int elements) const {
    return {EA,
            EI,
            cable_length / elements,
            mass_per_length,
            {gravity[0], gravity[1], gravity[2]},
            std::get<0>(GetParam()) == StrainModel::green_geometric,
            std::get<1>(GetParam()) == QuadratureRule::full};
  }
};

// Lengths that fill vectors of four and lengths that leave one to three elements over.
constexpr int lengths[] = {1, 2, 3, 4, 5, 6, 7, 8, 13, 64};

TEST_P(KernelsOf, ForceIsThatOfTheElementsOneByOne) {
  for (const int n : lengths)
    for (const double spread : {0.0, 1e-6, 0.1, 0.4}) {
      const Eigen::VectorXd q = chain(n, spread, 11);
      Eigen::VectorXd expected = weight(n), f(q.size());
      const PlainElement one = element(n);
      for (int e = 0; e < n; ++e) one.add_force(q.data() + 6 * e, expected.data() + 6 * e);
      EXPECT_EQ(best_kernels().force(constants(n), n, q.data(), f.data()), -1);
      EXPECT_LE((f - expected).lpNorm<Eigen::Infinity>(), 2e-13 * (EA + expected.lpNorm<Eigen::Infinity>()))
          << n << " elements, spread " << spread;
    }
}

/// mass_factor M + stiffness_factor K, assembled from single elements.
Eigen::MatrixXd assembled(const PlainElement& one, int n, const Eigen::VectorXd& q, double mass_factor,
                          double stiffness_factor) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(q.size(), q.size());
  PlainElement::Matrix12 k;
  for (int e = 0; e < n; ++e) {
    one.tangent(q.data() + 6 * e, k);
    sum.block<12, 12>(6 * e, 6 * e) += stiffness_factor * k;
    // ∫ ρA sᵢsⱼ dx by a rule that is exact for degree 6 and more.
    for (const QuadraturePoint& p : gauss_rule(5)) {
      const auto shape = Hermite::values(p.x, one.length());
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          sum.block<3, 3>(6 * e + 3 * i, 6 * e + 3 * j).diagonal().array() +=
              mass_factor * mass_per_length * one.length() * p.weight * shape[static_cast<std::size_t>(i)] *
              shape[static_cast<std::size_t>(j)];
    }
  }
  return sum;
}

/// The symmetric matrix of which block columns hold the lower triangle.
Eigen::MatrixXd full(const std::vector<double>& columns) {
  const auto nodes = static_cast<int>(columns.size()) / block_column_size;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6 * nodes, 6 * nodes);
  for (int node = 0; node < nodes; ++node) {
    const int rows = node + 1 < nodes ? 12 : 6;
    const Eigen::Map<const Eigen::Matrix<double, 12, 6>> column(columns.data() + block_column_size * node);
    A.block(6 * node, 6 * node, rows, 6) = column.topRows(rows);
  }
  return A.selfadjointView<Eigen::Lower>();
}

std::vector<double> block_columns(int elements) {
  return std::vector<double>(static_cast<std::size_t>(block_column_size * (elements + 1)), 7);
}

std::vector<double> factors_of(int elements) {
  return std::vector<double>(static_cast<std::size_t>(factor_size * (elements + 1)), 7);
}

TEST_P(KernelsOf, SystemIsThatOfTheElementsOneByOne) {
  for (const int n : lengths)
    for (const double spread : {0.0, 1e-6, 0.1, 0.4})
      for (const auto& [mass_factor, stiffness_factor] :
           {std::pair{0.0, 1.0}, std::pair{1.0, 0.0}, std::pair{2.0, 1e-6}}) {
        const Eigen::VectorXd q = chain(n, spread, 12);
        const Eigen::MatrixXd expected = assembled(element(n), n, q, mass_factor, stiffness_factor);
        std::vector<double> columns = block_columns(n);
        best_kernels().system(constants(n), mass_factor, stiffness_factor, n, q.data(), columns.data());
        const Eigen::MatrixXd seen = full(columns);
        EXPECT_LE((seen - expected).lpNorm<Eigen::Infinity>(), 2e-13 * expected.lpNorm<Eigen::Infinity>())
            << n << " elements, spread " << spread << ", " << mass_factor << " M + " << stiffness_factor
            << " K";
      }
}

TEST_P(KernelsOf, FactorsSolveThePositiveDefiniteSystem) {
  for (const int n : lengths) {
    const Eigen::VectorXd q = chain(n, 0.02, 16), expected = Eigen::VectorXd::LinSpaced(q.size(), -1, 2);
    std::vector<double> columns = block_columns(n);
    best_kernels().system(constants(n), 1, 1e-6, n, q.data(), columns.data());
    const Eigen::MatrixXd A = full(columns);
    Eigen::VectorXd x = A * expected;
    std::vector<double> factors = factors_of(n);
    ASSERT_EQ(best_kernels().factor(n + 1, columns.data(), factors.data()), -1) << n << " elements";
    best_kernels().solve(n + 1, factors.data(), x.data());
    EXPECT_LE((A * (x - expected)).norm(), 1e-11 * (A * expected).norm()) << n << " elements";
    EXPECT_LE((x - expected).norm(), 1e-6 * expected.norm()) << n << " elements";
  }
}

constexpr SupportsSpec some_supports[] = {{Support::free, Support::free},
                                          {Support::pinned, Support::free},
                                          {Support::clamped, Support::pinned},
                                          {Support::free, Support::clamped}};

TEST_P(KernelsOf, FactorsMadeAtOnceAreThoseOfTheMatrixWithItsSupports) {
  for (const SupportsSpec& supports : some_supports)
    for (const int n : lengths) {
      const Eigen::VectorXd q = chain(n, 0.02, 16);
      const SupportProjection ends(supports, Vec3(0.6, 0, -0.8), n + 1);
      BlockTridiagonal A(n + 1);
      best_kernels().system(constants(n), 1, 1e-6, n, q.data(), A.data());
      ends.apply(A);
      std::vector<double> expected = factors_of(n), seen = expected;
      ASSERT_EQ(best_kernels().factor(n + 1, A.data(), expected.data()), -1) << n << " elements";
      EXPECT_EQ(best_kernels().system_factors(constants(n), 1, 1e-6, n, ends, q.data(), seen.data()), -1);
      EXPECT_EQ(seen, expected) << n << " elements";
    }
}

/// An implicit stage with all its terms, and the arrays that they are made of.
struct Stage {
  explicit Stage(int n)
      : q(chain(n, 0.02, 31)), v(chain(n, 0.3, 32)), a(chain(n, 0.3, 33)), known(chain(n, 0.01, 34)) {
    terms.base = Sum(q).plus(1e-4, v);
    terms.mass = 0.8;
    terms.force = 0.7;
    terms.before = {0.3, v.data()};
    terms.known = {0.2, known.data()};
    terms.from = {-0.5, a.data()};
  }

  Eigen::VectorXd q, v, a, known;
  StageTerms terms{.base = Sum(q), .reach = 1e-6};
};

TEST_P(KernelsOf, ACorrectionIsTheResidualSolved) {
  constexpr double stiffness_factor = 1e-6;
  for (const SupportsSpec& supports : some_supports)
    for (const int n : lengths) {
      const Stage stage(n);
      const StageTerms& terms = stage.terms;
      const SupportProjection ends(supports, Vec3(0.6, 0, -0.8), n + 1);
      const Eigen::VectorXd x = -0.5 * stage.a, at = stage.q + 1e-4 * stage.v + terms.reach * x;
      const MassMatrix mass(constants(n), n, ends);
      Eigen::VectorXd f(at.size()), inertia;
      best_kernels().force(constants(n), n, at.data(), f.data());
      Loads(n).add_to(f);
      mass.multiply(x + 0.3 * stage.v, inertia);
      Eigen::VectorXd change = 0.7 * f + 0.2 * stage.known - 0.8 * inertia;
      ends.apply(change);
      std::vector<double> factors = factors_of(n);
      ASSERT_EQ(best_kernels().system_factors(constants(n), 0.8, stiffness_factor, n, ends, at.data(),
                                              factors.data()),
                -1);
      best_kernels().solve(n + 1, factors.data(), change.data());
      double position = 0, slope = 0;
      for (int node = 0; node <= n; ++node) {
        position = std::max(position, change.segment<3>(6 * node).lpNorm<Eigen::Infinity>());
        slope = std::max(slope, change.segment<3>(6 * node + 3).lpNorm<Eigen::Infinity>());
      }
      // With the matrix made anew, and then with the one at hand.
      for (const double renewed : {stiffness_factor, 0.0}) {
        Eigen::VectorXd seen(at.size());
        const StageCorrection result = best_kernels().correct(constants(n), n, ends, Loads(n), terms, renewed,
                                                              factors.data(), nullptr, seen.data());
        EXPECT_EQ(result.unsound, -1);
        EXPECT_EQ(result.singular, -1);
        EXPECT_TRUE(result.finite);
        EXPECT_LE((seen - x - change).norm(), 1e-11 * change.norm()) << n << " elements";
        EXPECT_NEAR(result.position, position, 1e-11 * change.norm());
        EXPECT_NEAR(result.slope, slope, 1e-11 * change.norm());
      }
    }
}

/// A cable bent and stretched in the plane of x and y, turned about z by an angle.
Eigen::VectorXd bent_in_plane(int n, double angle) {
  Eigen::VectorXd q(6 * (n + 1));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  for (int node = 0; node <= n; ++node) {
    const double x = cable_length / n * node;
    q.segment<3>(6 * node) = turn * Vec3(1.01 * x, 0.05 * std::sin(3 * x), 0);
    q.segment<3>(6 * node + 3) = turn * Vec3(1.01, 0.15 * std::cos(3 * x), 0);
  }
  return q;
}

TEST_P(KernelsOf, AnOldMatrixThatIsTurnedWithTheNodesIsThatOfTheTurnedCable) {
  constexpr double stiffness_factor = 1e-6;
  for (const SupportsSpec& supports : some_supports)
    for (const int n : lengths)
      for (const double angle : {1e-3, 0.5, -1.5}) {
        const SupportProjection ends(supports, Vec3::UnitZ(), n + 1);
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(6 * (n + 1));
        const auto correct = [&](const Eigen::VectorXd& q, double renewed, std::vector<double>& factors,
                                 double* turns) {
          StageTerms terms{.base = Sum(q), .reach = 1e-6};
          terms.from = {1, zero.data()};
          Eigen::VectorXd x(q.size());
          const StageCorrection result = best_kernels().correct(constants(n), n, ends, Loads(n), terms,
                                                                renewed, factors.data(), turns, x.data());
          EXPECT_EQ(result.singular, -1);
          EXPECT_TRUE(result.finite);
          return x;
        };
        const Eigen::VectorXd before = bent_in_plane(n, 0), after = bent_in_plane(n, angle);
        std::vector<double> factors = factors_of(n), renewed = factors,
                            turns(static_cast<std::size_t>(turns_size(n + 1)));
        correct(before, stiffness_factor, factors, turns.data());
        const Eigen::VectorXd expected = correct(after, stiffness_factor, renewed, nullptr),
                              turned = correct(after, 0, factors, turns.data()),
                              as_it_was = correct(after, 0, factors, nullptr);
        EXPECT_LE((turned - expected).norm(), 1e-9 * expected.norm())
            << n << " elements, turned by " << angle;
        EXPECT_GT((as_it_was - expected).norm(), 1e-7 * expected.norm()) << n << " elements, by " << angle;

        std::vector<double> one_by_one(turns.size());
        Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(after.size(), -1, 1), y = x;
        best_kernels().mark_slopes(n + 1, before.data(), one_by_one.data());
        best_kernels().turn_back(n + 1, after.data(), one_by_one.data(), x.data());
        EXPECT_EQ(one_by_one, turns) << n << " elements";
        best_kernels().turn(n + 1, one_by_one.data(), x.data());
        EXPECT_LE((x - y).norm(), 1e-14 * y.norm()) << "there and back";
      }
}

TEST_P(KernelsOf, NothingTurnsWhereASlopeHasTurnedRoundOrIsNone) {
  const int n = 5;
  for (const double angle : {3.1, 0.0}) {
    Eigen::VectorXd before = bent_in_plane(n, 0), after = bent_in_plane(n, angle);
    if (angle == 0) before.setZero();
    if (angle == 0) after.setZero();
    std::vector<double> turns(static_cast<std::size_t>(turns_size(n + 1)));
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(after.size(), -1, 1), y = x;
    best_kernels().mark_slopes(n + 1, before.data(), turns.data());
    best_kernels().turn_back(n + 1, after.data(), turns.data(), x.data());
    EXPECT_LE((x - y).norm(), 1e-14 * y.norm()) << "turned by " << angle;
  }
}

TEST_P(KernelsOf, ACorrectionThatGoesWrongSaysWhere) {
  const SupportProjection ends({}, Vec3::UnitX(), 1);
  for (const int n : lengths)
    for (int bad = 0; bad < n; ++bad) {
      std::vector<double> factors = factors_of(n);
      Eigen::VectorXd x(6 * (n + 1));
      const auto correct = [&](const Stage& stage, double stiffness_factor) {
        return best_kernels().correct(constants(n), n, ends, Loads(n), stage.terms, stiffness_factor,
                                      factors.data(), nullptr, x.data());
      };
      Stage sound(n);
      ASSERT_EQ(correct(sound, 1e-6).singular, -1);
      // A stiffness that takes more off the mass than there is.
      EXPECT_GE(correct(sound, -1).singular, 0);
      ASSERT_EQ(correct(sound, 1e-6).singular, -1);
      Stage collapsed(n);
      collapsed.q[6 * bad + 7] = std::numeric_limits<double>::quiet_NaN();
      EXPECT_EQ(correct(collapsed, 0).unsound, bad) << n << " elements";
      const StageCorrection both = correct(collapsed, 1e-6);
      EXPECT_TRUE(both.unsound == bad || both.singular >= 0) << n << " elements";
      ASSERT_EQ(correct(sound, 1e-6).singular, -1);
      Stage infinite(n);
      infinite.known[6 * bad + 1] = std::numeric_limits<double>::infinity();
      EXPECT_FALSE(correct(infinite, 0).finite) << n << " elements";
    }
}

TEST_P(KernelsOf, AMatrixThatIsNotPositiveDefiniteIsToldByItsNode) {
  for (const int n : lengths)
    for (int bad = 0; bad <= n; ++bad)
      for (const double entry : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
        std::vector<double> columns = block_columns(n);
        best_kernels().system(constants(n), 1, 0, n, chain(n, 0, 1).data(), columns.data());
        columns[static_cast<std::size_t>(block_column_size * bad + 12 * 4 + 4)] = entry;
        std::vector<double> factors = factors_of(n);
        EXPECT_EQ(best_kernels().factor(n + 1, columns.data(), factors.data()), bad)
            << n << " elements, " << entry;
      }
}

TEST_P(KernelsOf, AccelerationIsTheForceSolvedWithTheMassBesideItsSums) {
  std::vector<const Kernels*> built{&plain_kernels()};
  if (v3_kernels() != nullptr) built.push_back(v3_kernels());
  std::vector<int> long_too(std::begin(lengths), std::end(lengths));
  long_too.insert(long_too.end(), {127, 128, 129, 130, 260});
  for (const Kernels* kernels : built)
    for (const int n : long_too) {
      // Every other length has other supports.
      const SupportsSpec supports =
          n % 2 == 0 ? SupportsSpec{.first = Support::pinned} : SupportsSpec{Support::free, Support::pinned};
      const MassMatrix mass(constants(n), n, SupportProjection(supports, Vec3::UnitX(), n + 1));
      const Eigen::VectorXd q = chain(n, 0.01, 17), v = chain(n, 0.3, 18), w = chain(n, 0.3, 19);
      const Eigen::VectorXd at = q + 1e-3 * v + 2e-3 * w;
      Eigen::VectorXd expected(q.size()), scratch;
      kernels->force(constants(n), n, at.data(), expected.data());
      Loads(n).add_to(expected);
      mass.solve(expected, scratch);
      for (const bool kept : {false, true}) {
        Eigen::VectorXd a(q.size()), q_kept(q.size()), before(q.size()), after = w;
        Sum coordinates = Sum(q).plus(1e-3, v).plus(2e-3, w);
        if (kept) coordinates.into(q_kept);
        const std::vector<Sum> first{Sum(v).plus(2, w).into(before)},
            then{Sum(after).plus(0.5, a).into(after)};
        EXPECT_EQ(kernels->acceleration(
                      constants(n), n, *mass.factors(), Loads(n),
                      {coordinates, {first.data(), first.size()}, {then.data(), then.size()}}, a.data()),
                  -1);
        EXPECT_LE((a - expected).norm(), 1e-14 * expected.norm()) << n << " elements";
        if (kept) {
          EXPECT_LE((q_kept - at).norm(), 1e-15 * at.norm()) << n << " elements";
        }
        EXPECT_LE((before - (v + 2 * w)).norm(), 1e-15 * before.norm()) << n << " elements";
        EXPECT_LE((after - (w + 0.5 * a)).norm(), 1e-15 * after.norm()) << n << " elements";
      }
    }
}

TEST_P(KernelsOf, AnAccelerationSaysWhereASlopeHasCollapsed) {
  for (const int n : lengths)
    for (int bad = 0; bad < n; ++bad) {
      const MassMatrix mass(constants(n), n, SupportProjection({}, Vec3::UnitX(), n + 1));
      Eigen::VectorXd q = chain(n, 0.1, 24), a(q.size());
      q[6 * bad + 7] = std::numeric_limits<double>::quiet_NaN();
      const Sum coordinates(q);
      EXPECT_EQ(best_kernels().acceleration(constants(n), n, *mass.factors(), Loads(n), {coordinates, {}, {}},
                                            a.data()),
                bad)
          << n << " elements";
    }
}

TEST_P(KernelsOf, SumsOfAnyNumberOfTermsAreThoseOfEachCoordinate) {
  for (const int n : {1, 2, 7})
    for (int count = 0; count <= Sum::most; ++count) {
      const Eigen::VectorXd first = chain(n, 0.3, 20), term = chain(n, 0.3, 21);
      Eigen::VectorXd result = Eigen::VectorXd::Zero(first.size()), expected = first;
      Sum sum(first);
      for (int k = 0; k < count; ++k) {
        sum.plus(1.0 + k, term);
        expected += (1.0 + k) * term;
      }
      best_kernels().add_up(n + 1, sum.into(result));
      EXPECT_EQ(result, expected) << n << " elements, " << count << " terms";
    }
}

TEST_P(KernelsOf, SumsFollowOneAnotherNodeByNode) {
  // As many nodes as one block has, and one more or less.
  for (const int n : {62, 63, 64, 129}) {
    const Eigen::VectorXd a = chain(n, 0.3, 22), b = chain(n, 0.3, 23);
    Eigen::VectorXd first(a.size()), second = b;
    const Sum sums[] = {Sum(a).plus(2, b).into(first),
                        Sum(second).plus(3, first).plus(-1, second).into(second)};
    best_kernels().add_up(n + 1, {sums, 2});
    EXPECT_EQ(first, a + 2 * b) << n << " elements";
    EXPECT_LE((second - 3 * first).norm(), 1e-15 * second.norm()) << n << " elements";
  }
}

TEST_P(KernelsOf, EnergyIsThatOfTheElementsOneByOne) {
  for (const int n : lengths)
    for (const double spread : {0.0, 0.1, 0.4}) {
      const Eigen::VectorXd q = chain(n, spread, 13);
      double axial = -1, bending = -1, expected_axial = 0, expected_bending = 0;
      const PlainElement one = element(n);
      for (int e = 0; e < n; ++e) {
        expected_axial += one.axial_energy(q.data() + 6 * e);
        expected_bending += one.bending_energy(q.data() + 6 * e);
      }
      best_kernels().energy(constants(n), n, q.data(), &axial, &bending);
      EXPECT_NEAR(axial, expected_axial, 1e-13 * (EA * 1e-3 + expected_axial)) << n << " elements";
      EXPECT_NEAR(bending, expected_bending, 1e-12 * (EI + expected_bending)) << n << " elements";
    }
}

TEST_P(KernelsOf, ResultsAreTheSameBitsOnEveryInstructionSet) {
  if (v3_kernels() == nullptr) GTEST_SKIP() << "this processor has no AVX2: there is nothing to compare";
  for (const int n : lengths) {
    const Eigen::VectorXd q = chain(n, 0.3, 14);
    Eigen::VectorXd f = q, other = q;
    std::vector<double> k = block_columns(n), l = k;
    Eigen::VectorXd x = q, y = q;
    double energies[4] = {};
    plain_kernels().force(constants(n), n, q.data(), f.data());
    v3_kernels()->force(constants(n), n, q.data(), other.data());
    plain_kernels().system(constants(n), 1, 1e-6, n, q.data(), k.data());
    v3_kernels()->system(constants(n), 1, 1e-6, n, q.data(), l.data());
    EXPECT_EQ(k, l) << n << " elements";
    std::vector<double> a = factors_of(n), b = a;
    EXPECT_EQ(plain_kernels().factor(n + 1, k.data(), a.data()),
              v3_kernels()->factor(n + 1, l.data(), b.data()));
    EXPECT_EQ(a, b) << n << " elements, factored";
    plain_kernels().solve(n + 1, a.data(), x.data());
    v3_kernels()->solve(n + 1, b.data(), y.data());
    EXPECT_EQ(x, y) << n << " elements, solved";
    const SupportProjection ends({.first = Support::pinned}, Vec3::UnitX(), n + 1);
    std::vector<double> plain_turns(static_cast<std::size_t>(turns_size(n + 1))), v3_turns = plain_turns;
    for (const double stiffness_factor : {1e-6, 0.0}) {
      const Stage stage(n);
      plain_kernels().correct(constants(n), n, ends, Loads(n), stage.terms, stiffness_factor, a.data(),
                              plain_turns.data(), x.data());
      v3_kernels()->correct(constants(n), n, ends, Loads(n), stage.terms, stiffness_factor, b.data(),
                            v3_turns.data(), y.data());
      EXPECT_EQ(plain_turns, v3_turns) << n << " elements";
      EXPECT_EQ(a, b) << n << " elements, renewed";
      EXPECT_EQ(x, y) << n << " elements, corrected";
    }
    const MassMatrix mass(constants(n), n, SupportProjection({}, Vec3::UnitX(), n + 1));
    const Sum coordinates = Sum(q).plus(1e-3, f);
    const auto masses = [&](const Kernels& kernels, Eigen::VectorXd& out) {
      const Sum after = Sum(q).plus(2, x).into(out);
      kernels.acceleration(constants(n), n, *mass.factors(), Loads(n), {coordinates, {}, after}, x.data());
      kernels.mass_multiply(constants(n), n, q.data(), y.data());
      kernels.mass_solve(n + 1, *mass.factors(), y.data());
      kernels.add_up(n + 1, Sum(out).plus(kernels.kinetic_energy(constants(n), n, q.data()), y).into(out));
    };
    Eigen::VectorXd of_plain(q.size()), of_v3(q.size());
    masses(plain_kernels(), of_plain);
    masses(*v3_kernels(), of_v3);
    EXPECT_EQ(of_plain, of_v3) << n << " elements, masses and sums";
    plain_kernels().system_factors(constants(n), 1, 1e-6, n, ends, q.data(), a.data());
    v3_kernels()->system_factors(constants(n), 1, 1e-6, n, ends, q.data(), b.data());
    EXPECT_EQ(a, b) << n << " elements, factors at once";
    plain_kernels().energy(constants(n), n, q.data(), energies, energies + 1);
    v3_kernels()->energy(constants(n), n, q.data(), energies + 2, energies + 3);
    EXPECT_EQ(f, other) << n << " elements: forces differ by " << (f - other).lpNorm<Eigen::Infinity>();
    EXPECT_EQ(energies[0], energies[2]);
    EXPECT_EQ(energies[1], energies[3]);
  }
}

TEST_P(KernelsOf, ACollapsedSlopeOrANumberThatIsNoneIsToldByItsElement) {
  for (const int n : lengths)
    for (int bad = 0; bad < n; ++bad) {
      Eigen::VectorXd q = chain(n, 0.1, 15), f = q;
      q[6 * bad + 7] = std::numeric_limits<double>::quiet_NaN();  // the end that it shares with the next
      EXPECT_EQ(best_kernels().force(constants(n), n, q.data(), f.data()), bad) << n << " elements";
      q = chain(n, 0, 15);
      q.segment<12>(6 * bad).setZero();  // r' = 0 all along the element
      for (int node = bad + 2; node <= n; ++node) q.segment<3>(6 * node) += Vec3(0, 1, 0);
      const int first = best_kernels().force(constants(n), n, q.data(), f.data());
      // A point of the reduced rule is on the node that the element before shares.
      EXPECT_TRUE(first == bad || (std::get<1>(GetParam()) == QuadratureRule::reduced && first == bad - 1))
          << n << " elements: " << first << " instead of " << bad;
      EXPECT_TRUE(f.allFinite());
    }
}

INSTANTIATE_TEST_SUITE_P(Models, KernelsOf,
                         testing::Combine(testing::Values(StrainModel::green_geometric,
                                                          StrainModel::engineering_material),
                                          testing::Values(QuadratureRule::full, QuadratureRule::reduced)),
                         [](const testing::TestParamInfo<Model>& tested) {
                           return std::string(std::get<0>(tested.param) == StrainModel::green_geometric
                                                  ? "Green"
                                                  : "Engineering") +
                                  (std::get<1>(tested.param) == QuadratureRule::full ? "Full" : "Reduced");
                         });

}  // namespace kernels_test
}  // namespace plumb
