#include "engine/model/lowest_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/base/dense.h"
#include "engine/base/interrupt.h"
#include "engine/model/mode_shapes.h"

namespace plumb {
namespace {

/// Modes whose ω² differ by less, as a share, are of one frequency.
constexpr double same_square = 1e-7;

/// Vectors of norm 1 in M and orthogonal in it, which are added block by block.
class Basis {
 public:
  explicit Basis(const SmallMotions& motions) : motions_(motions), vectors_(motions.cable().size(), 0) {}

  Eigen::Index size() const { return count_; }
  auto vectors() const { return vectors_.leftCols(count_); }
  auto vector(Eigen::Index k) const { return vectors_.col(k); }

  /// Adds what columns of X hold that is new. Returns X in terms of the basis as it is then.
  Eigen::MatrixXd add(Eigen::MatrixXd X) {
    constexpr double nothing_new = 1e-10;
    const Eigen::Index before = count_, most = before + X.cols();
    constexpr Eigen::Index at_a_time = 24;
    if (vectors_.cols() < most) vectors_.conservativeResize(Eigen::NoChange, most + at_a_time);
    Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(most, X.cols());
    Eigen::VectorXd x, y;
    for (Eigen::Index k = 0; k < X.cols(); ++k) {
      x = X.col(k);
      motions_.cable().supports().apply(x);
      const double whole = std::sqrt(motions_.mass_of(x));
      for (int pass = 0; pass < 2; ++pass) {
        motions_.mass_times(x, y);
        const Eigen::VectorXd part = vectors_.leftCols(count_).transpose() * y;
        x -= vectors_.leftCols(count_) * part;
        terms.col(k).head(count_) += part;
      }
      const double left = std::sqrt(std::max(0.0, motions_.mass_of(x)));
      if (!(left > nothing_new * whole)) continue;
      terms(count_, k) = left;
      vectors_.col(count_++) = x / left;
    }
    return terms.topRows(count_);
  }

 private:
  const SmallMotions& motions_;
  Eigen::MatrixXd vectors_;
  Eigen::Index count_ = 0;
};

class Lanczos {
 public:
  Lanczos(const SmallMotions& motions, int wanted)
      : motions_(motions), wanted_(wanted), rigid_(free_rigid_motions(motions)), basis_(motions) {}

  LowestModes modes() {
    LowestModes result;
    result.rigid_body = static_cast<int>(rigid_.cols());
    basis_.add(rigid_);
    if (!choose_shift()) {
      result.failure = "the stiffness is not finite, or as singular as the masses";
      return result;
    }
    if (result.rigid_body < wanted_) iterate(result);
    finish(result);
    return result;
  }

 private:
  /// Sets the shift so that K + shift M has no negative eigenvalue, and factors it.
  bool choose_shift() {
    constexpr int most = 80;
    const Cable& cable = motions_.cable();
    const Element& element = cable.element();
    const double L = cable.length(), mass = cable.constants().mass_per_length;
    // Well below the first bending vibration of a cantilever.
    shift_ = (element.bending_stiffness() / (L * L) + 1e-9 * element.axial_stiffness()) / (mass * L * L);
    if (!(shift_ > 0)) shift_ = 1 / (L * L);
    for (int tries = 0; tries < most; ++tries, shift_ *= 4) {
      const std::optional<int> below = motions_.count_below(-shift_);
      if (tries == 0) negative_ = below.value_or(0);
      if (below == 0) return !motions_.factor(shift_, factors_);
    }
    return false;
  }

  /// (K + shift M)⁻¹ M of each vector from `first` on.
  Eigen::MatrixXd applied(Eigen::Index first) const {
    Eigen::MatrixXd result(motions_.cable().size(), basis_.size() - first);
    Eigen::VectorXd y;
    for (Eigen::Index k = first; k < basis_.size(); ++k) {
      motions_.mass_times(basis_.vector(k), y);
      factors_.solve(y);
      result.col(k - first) = y;
    }
    return result;
  }

  Eigen::MatrixXd random_block() {
    std::uniform_real_distribution<double> any(-1, 1);
    Eigen::MatrixXd block(motions_.cable().size(), block_size);
    for (double& number : block.reshaped()) number = any(random_);
    return block;
  }

  void iterate(LowestModes& result) {
    constexpr double converged = 1e-11;
    const Eigen::Index rigid = basis_.size(), most = rigid + block_size * (10 + 2 * wanted_);
    const Eigen::MatrixXd start = starting_modes(motions_.cable().nodes(), block_size);
    basis_.add(start);
    if (basis_.size() == rigid) basis_.add(random_block());
    Eigen::MatrixXd T;
    for (Eigen::Index done = rigid; done < basis_.size();) {
      stop_if_interrupted();
      const Eigen::Index size = basis_.size() - rigid, block = basis_.size() - done;
      const Eigen::MatrixXd terms = basis_.add(applied(done));
      Eigen::Index next = basis_.size() - rigid;
      T.conservativeResizeLike(Eigen::MatrixXd::Zero(next, next));
      T.block(0, done - rigid, next, block) = terms.bottomRows(next);
      const Eigen::MatrixXd beyond = terms.bottomRows(next - size);
      const Eigen::MatrixXd within = T.topLeftCorner(size, size);
      const SymmetricEigen ritz = symmetric_eigen(0.5 * (within + within.transpose()));
      // Rising: the greatest 1/(ω² + σ) come last.
      const Eigen::VectorXd values = ritz.values.reverse();
      const Eigen::MatrixXd vectors = ritz.vectors.rowwise().reverse();
      Eigen::Index good = 0;
      while (good < size && (beyond * vectors.col(good).tail(block)).norm() <= converged * values[good])
        ++good;
      done = basis_.size() - (next - size);
      // One more, as the last may be one of a pair.
      const bool enough = rigid + good > wanted_, whole = next == size;
      if (whole && !enough) {
        // All that this start leads to; what is left has no part in it.
        basis_.add(random_block());
        if (basis_.size() - rigid == next) done = basis_.size();
      }
      if (enough || done == basis_.size() || basis_.size() > most) {
        // Those that are not converged yet have a part in what is lost to round-off of K.
        shapes_ = basis_.vectors().middleCols(rigid, size) *
                  vectors.leftCols(std::min(size, good + 2 * block_size));
        sharpen(good);
        if (!enough && done != basis_.size()) {
          result.failure =
              fmt::format("after {} steps of Lanczos's method {} modes are known", next, rigid + good);
          return;
        }
        if (is_complete() || done == basis_.size()) return;
        if (basis_.size() > most) {
          result.failure = "a mode is missing below those that were found";
          return;
        }
        basis_.add(random_block());
      }
    }
  }

  /// Whether no mode is missing below the last that is asked for: as many eigenvalues are below as are known.
  bool is_complete() const {
    constexpr double beyond = 1e-6, most_noise = 1e-3;
    const auto asked = std::clamp<Eigen::Index>(wanted_ - rigid_.cols(), 1, squares_.size()) - 1;
    // Of those without any stiffness there may be as many as nodes, and any will do.
    if (squares_[asked] == 0) return true;
    const double limit = squares_[asked] + beyond * std::max(std::abs(squares_[asked]), shift_);
    const auto known = rigid_.cols() + (squares_.array() < limit).count();
    const std::optional<int> counted = motions_.count_below(limit);
    if (!counted || *counted <= known) return true;
    // Where the entries of K leave nothing of the lowest modes, they cannot be counted by them.
    Eigen::VectorXd Kx;
    motions_.stiffness_times(shapes_.col(0), Kx);
    return std::abs(shapes_.col(0).dot(Kx) - squares_[0]) > most_noise * std::abs(limit);
  }

  /// ω² and shapes from strains among what Lanczos's method found, of which `good` are converged.
  void sharpen(Eigen::Index good) {
    const SymmetricEigen ritz = symmetric_eigen(motions_.stiffness_of(shapes_));
    const Eigen::Index kept = std::min(good, shapes_.cols());
    shapes_ = (shapes_ * ritz.vectors.leftCols(kept)).eval();
    squares_ = ritz.values.head(kept);
    for (Eigen::Index k = 0; k < kept; ++k)
      if (motions_.stiffness_along(shapes_.col(k)) == 0) squares_[k] = 0;
  }

  /// Rigid-body motions and what was found, those of one frequency turned.
  void finish(LowestModes& result) const {
    const Eigen::Index found = shapes_.cols(), rigid = rigid_.cols();
    result.squares.setZero(rigid + found);
    result.squares.tail(found) = squares_;
    result.shapes.resize(motions_.cable().size(), rigid + found);
    result.shapes.leftCols(rigid) = rigid_;
    result.shapes.rightCols(found) = shapes_;
    for (Eigen::Index first = rigid, last; first < rigid + found; first = last) {
      for (last = first + 1; last < rigid + found; ++last)
        if (result.squares[last] - result.squares[first] > same_square * std::abs(result.squares[first]))
          break;
      Eigen::MatrixXd alike = result.shapes.middleCols(first, last - first);
      turn_towards_axes(alike);
      result.shapes.middleCols(first, last - first) = alike;
    }
    // There may be more of these than are asked for.
    const auto negative = static_cast<int>((result.squares.array() < 0).count());
    result.negative = negative > 0 ? std::max(negative_, negative) : 0;
  }

  static constexpr Eigen::Index block_size = 6;  // as many as modes can be alike without being slack

  const SmallMotions& motions_;
  Eigen::Index wanted_;
  Eigen::MatrixXd rigid_, shapes_;
  Eigen::VectorXd squares_;
  Basis basis_;
  BlockLu<double> factors_;
  double shift_ = 0;  // σ, 1/s²
  int negative_ = 0;  // eigenvalues below the first shift that was tried
  std::mt19937 random_{1};
};

}  // namespace

LowestModes lowest_modes(const SmallMotions& motions, int count) {
  return Lanczos(motions, count).modes();
}

}  // namespace plumb
