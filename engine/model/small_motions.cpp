#include "engine/model/small_motions.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/base/dense.h"
#include "engine/model/cross_matrix.h"
#include "engine/model/inertia.h"

namespace plumb {
namespace {

/// A matrix on positions and on slopes.
Block6 on_both(const Eigen::Matrix3d& A) {
  Block6 result = Block6::Zero();
  result.topLeftCorner<3, 3>() = result.bottomRightCorner<3, 3>() = A;
  return result;
}

/// The three translations and the rotations about the middle of mass, of norm 1 in M; of a straight cable
/// that about itself is none.
Eigen::MatrixXd rigid_motions(const SmallMotions& motions) {
  const Cable& cable = motions.cable();
  const Eigen::VectorXd& q = motions.state();
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(cable.size(), 6);
  for (int node = 0; node < cable.nodes(); ++node)
    rigid.block<3, 3>(6 * node, 0) = Eigen::Matrix3d::Identity();
  Eigen::VectorXd momentum;
  cable.mass().multiply(rigid.col(0), momentum);
  const double mass = rigid.col(0).dot(momentum);
  Vec3 middle = Vec3::Zero();
  for (Eigen::Index at = 0; at < q.size(); at += 3) middle += momentum[at] / mass * q.segment<3>(at);
  for (int node = 0; node < cable.nodes(); ++node) {
    rigid.block<3, 3>(6 * node, 3) = -cross_matrix(q.segment<3>(6 * node) - middle);
    // Those of a chain are no unknowns.
    if (!cable.chain()) rigid.block<3, 3>(6 * node + 3, 3) = -cross_matrix(q.segment<3>(6 * node + 3));
  }
  rigid.leftCols<3>() /= std::sqrt(mass);
  // Rotations about the principal axes, which M does not couple with translations.
  Eigen::MatrixXd moved(cable.size(), 3);
  for (Eigen::Index k = 0; k < 3; ++k) {
    cable.mass().multiply(rigid.col(3 + k), momentum);
    moved.col(k) = momentum;
  }
  constexpr double none = 1e-12;
  const Eigen::Matrix3d inertia = rigid.rightCols<3>().transpose() * moved;
  const SymmetricEigen axes = symmetric_eigen(inertia);
  const double greatest = axes.values[2];
  Eigen::MatrixXd result = rigid;
  result.conservativeResize(cable.size(), 3);
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (!(axes.values[k] > none * greatest)) continue;
    result.conservativeResize(Eigen::NoChange, result.cols() + 1);
    result.rightCols<1>() = rigid.rightCols<3>() * (axes.vectors.col(k) / std::sqrt(axes.values[k]));
  }
  return result;
}

/// Columns that span where a symmetric matrix ≥ 0 is no more than `none`.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A, double none) {
  const SymmetricEigen eigen = symmetric_eigen(A);
  const auto count = (eigen.values.array().abs() <= none).count();
  // A matrix that is 0 leaves the axes as they are.
  if (count == A.cols()) return Eigen::MatrixXd::Identity(A.rows(), A.cols());
  Eigen::MatrixXd result(A.rows(), count);
  Eigen::Index to = 0;
  for (Eigen::Index k = 0; k < A.cols(); ++k)
    if (std::abs(eigen.values[k]) <= none) result.col(to++) = eigen.vectors.col(k);
  return result;
}

}  // namespace

SmallMotions::SmallMotions(const Cable& cable, const Eigen::VectorXd& q, double t)
    : cable_(cable),
      q_(q),
      strains_(cable, q),
      spin_(cross_matrix(cable.spin())),
      mass_(cable.nodes()),
      stiffness_(cable.nodes()) {
  const bool spins = !cable.spin().isZero(0);
  cable.system(q, 1, 0, mass_);
  cable.system(q, 0, 1, stiffness_);
  if (spins) {
    const Block6 S2 = on_both(spin_ * spin_);
    for (int node = 0; node < cable.nodes(); ++node) {
      const Block6 own = mass_.diagonal(node).selfadjointView<Eigen::Lower>();
      stiffness_.diagonal(node) += own * S2;
      if (node + 1 < cable.nodes()) stiffness_.below(node) += mass_.below(node) * S2;
    }
  }
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(q.size());
  if (cable.variable_loads().has_tangent()) {
    of_loads_.emplace(cable.nodes());
    cable.add_other_system(t, 1, q, rest, 1, 0, *of_loads_);
  }
  if (!spins && cable.damping().none()) return;
  rates_.emplace(cable.nodes());
  cable.add_other_system(t, 1, q, rest, 0, 1, *rates_);
  const Block6 turn = on_both(cable.damping().by_mass() * Eigen::Matrix3d::Identity() + 2 * spin_);
  const GeneralBlockTridiagonal<double> mass(mass_);
  for (std::size_t node = 0; node < mass.diagonal.size(); ++node) {
    rates_->diagonal[node] += mass.diagonal[node] * turn;
    if (node + 1 == mass.diagonal.size()) break;
    rates_->below[node] += mass.below[node] * turn;
    rates_->above[node] += mass.above[node] * turn;
  }
}

void SmallMotions::mass_times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  cable_.mass().multiply(x, y);
  cable_.supports().apply(y);
}

void SmallMotions::rates_times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  // Those of damping are made of strains, in which less cancels than in a matrix.
  Eigen::VectorXd force = Eigen::VectorXd::Zero(x.size());
  cable_.add_rate_forces(q_, x, force, {});
  y = -force;
  if (!spin_.isZero(0)) {
    cable_.mass().multiply(turned(x), force);
    y += 2 * force;
  }
  cable_.supports().apply(y);
}

void SmallMotions::stiffness_times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  stiffness_.multiply(x, y);
  if (of_loads_) {
    Eigen::VectorXd more;
    of_loads_->multiply(x, more);
    y += more;
  }
  cable_.supports().apply(y);
}

double SmallMotions::mass_of(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y;
  cable_.mass().multiply(x, y);
  return x.dot(y);
}

Eigen::MatrixXd SmallMotions::turned(Eigen::MatrixXd X) const {
  for (Eigen::Index at = 0; at < X.rows(); at += 3)
    X.middleRows<3>(at) = (spin_ * X.middleRows<3>(at)).eval();
  return X;
}

Eigen::MatrixXd SmallMotions::stiffness_of(const Eigen::MatrixXd& X) const {
  Eigen::MatrixXd result = strains_.of(X);
  Eigen::MatrixXd of_loads(X.rows(), of_loads_ ? X.cols() : 0), turning = of_loads;
  Eigen::VectorXd y;
  for (Eigen::Index k = 0; k < of_loads.cols(); ++k) {
    of_loads_->multiply(X.col(k), y);
    of_loads.col(k) = y;
  }
  if (of_loads_) {
    const Eigen::MatrixXd more = X.transpose() * of_loads;
    result += 0.5 * (more + more.transpose());
  }
  if (spin_.isZero(0)) return result;
  const Eigen::MatrixXd SX = turned(X);
  turning.resize(X.rows(), X.cols());
  for (Eigen::Index k = 0; k < X.cols(); ++k) {
    cable_.mass().multiply(SX.col(k), y);
    turning.col(k) = y;
  }
  return result - SX.transpose() * turning;
}

double SmallMotions::stiffness_along(const Eigen::VectorXd& x) const {
  // A strain of less is what Newton's iteration leaves.
  constexpr double round_off = 1e-13;
  const double value = stiffness_of(x)(0, 0);
  const double scale = strains_.scale_of(x) + (spin_.isZero(0) ? 0 : mass_of(turned(x)));
  return std::abs(value) <= round_off * scale ? 0 : value;
}

BlockTridiagonal SmallMotions::symmetric(double shift) const {
  BlockTridiagonal A = stiffness_;
  for (int k = 0; k < block_column_size * A.nodes(); ++k) A.data()[k] += shift * mass_.data()[k];
  if (of_loads_)
    for (int node = 0; node < A.nodes(); ++node) {
      const auto at = static_cast<std::size_t>(node);
      A.diagonal(node) += 0.5 * (of_loads_->diagonal[at] + of_loads_->diagonal[at].transpose());
      if (node + 1 < A.nodes())
        A.below(node) += 0.5 * (of_loads_->below[at] + of_loads_->above[at].transpose());
    }
  cable_.supports().apply(A);
  return A;
}

std::optional<int> SmallMotions::factor(double shift, BlockLu<double>& factors) const {
  return factors.factor(GeneralBlockTridiagonal<double>(symmetric(shift)));
}

std::optional<int> SmallMotions::count_below(double square) const {
  return negative_eigenvalues(symmetric(-square));
}

std::optional<int> SmallMotions::factor(std::complex<double> exponent,
                                        BlockLu<std::complex<double>>& factors) const {
  const auto with_supports = [&](GeneralBlockTridiagonal<double> A) {
    cable_.supports().apply(A);
    return A;
  };
  GeneralBlockTridiagonal<std::complex<double>> A(cable_.nodes());
  GeneralBlockTridiagonal<double> K(stiffness_);
  if (of_loads_) K.add(1, *of_loads_);
  A.add(1, with_supports(std::move(K)));
  A.add(exponent * exponent, with_supports(GeneralBlockTridiagonal<double>(mass_)));
  if (rates_) A.add(exponent, with_supports(*rates_));
  return factors.factor(A);
}

Eigen::MatrixXd free_rigid_motions(const SmallMotions& motions) {
  constexpr double round_off = 1e-12;
  const Cable& cable = motions.cable();
  Eigen::MatrixXd rigid = rigid_motions(motions), held = rigid;
  for (Eigen::Index k = 0; k < rigid.cols(); ++k) {
    Eigen::VectorXd x = rigid.col(k);
    cable.supports().apply(x);
    if (cable.chain())
      // Its slopes are held everywhere, and no part of what moves.
      for (Eigen::Index at = 3; at < x.size(); at += 6) held.col(k).segment<3>(at).setZero();
    held.col(k) -= x;
  }
  for (Eigen::Index at = 0; at < held.rows(); at += 6) held.middleRows<3>(at) /= cable.length();
  rigid =
      (rigid * null_space(held.transpose() * held * (cable.total_mass() * cable.length() * cable.length()),
                          round_off))
          .eval();
  for (Eigen::Index k = 0; k < rigid.cols(); ++k) {
    Eigen::VectorXd x = rigid.col(k);
    cable.supports().apply(x);
    rigid.col(k) = x;
  }
  if (rigid.cols() == 0) return rigid;
  const SymmetricEigen resisted = symmetric_eigen(motions.stiffness_of(rigid));
  const auto is_free = [&](const Eigen::VectorXd& x) { return motions.stiffness_along(x) == 0; };
  Eigen::MatrixXd result(rigid.rows(), 0);
  const auto keep_free = [&](const Eigen::MatrixXd& motion) {
    for (Eigen::Index k = 0; k < motion.cols(); ++k) {
      if (!is_free(motion.col(k))) continue;
      result.conservativeResize(Eigen::NoChange, result.cols() + 1);
      result.rightCols<1>() = motion.col(k);
    }
  };
  keep_free(rigid);
  // As they are where nothing is resisted, so that translations stay translations.
  if (result.cols() == rigid.cols()) return result;
  result.resize(rigid.rows(), 0);
  keep_free(rigid * resisted.vectors);
  return result;
}

}  // namespace plumb
