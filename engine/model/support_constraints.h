#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// What the supports hold, as linear constraints G q = G q₀ with orthonormal rows, G Gᵀ = I: the complement
/// of SupportProjection, P = I − Gᵀ G. Of an end the rows are the three components of r, where its position
/// is held, and two components of r' across the straight cable, where its direction is; the first end comes
/// first. A multiplier λ with M v' = f + Gᵀ λ is the force of the joint on the cable: N, and N m for rows of
/// r'.
class SupportConstraints {
 public:
  /// `direction`: unit vector of the straight cable; only used where a direction is held.
  SupportConstraints(const SupportsSpec& supports, const Vec3& direction, int nodes);

  Eigen::Index count() const { return static_cast<Eigen::Index>(rows_.size()); }

  /// G x.
  template <class Derived>
  auto apply(const Eigen::MatrixBase<Derived>& x) const {
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1> result(count());
    for (std::size_t i = 0; i < rows_.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = rows_[i].direction.dot(x.template segment<3>(rows_[i].at));
    return result;
  }

  /// x := x + Gᵀ λ.
  template <class Vector, class Multipliers>
  void add_transposed(const Multipliers& lambda, Vector& x) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      x.template segment<3>(rows_[i].at) += lambda[static_cast<Eigen::Index>(i)] * rows_[i].direction;
  }

  /// Turns the forces among the multipliers, those of positions.
  void turn(const Eigen::Matrix3d& by, Eigen::VectorXd& lambda) const {
    for (std::size_t i = 0; i < rows_.size(); i += rows_[i].at % 6 == 0 ? 3 : 1)
      if (const auto at = static_cast<Eigen::Index>(i); rows_[i].at % 6 == 0)
        lambda.segment<3>(at) = (by * lambda.segment<3>(at)).eval();
  }

  /// Multiplies the multipliers of positions and of slopes each by its factor.
  void scale(double positions, double slopes, Eigen::VectorXd& lambda) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      lambda[static_cast<Eigen::Index>(i)] *= rows_[i].at % 6 == 0 ? positions : slopes;
  }

 private:
  static constexpr int most = 10;  // both ends held altogether

  struct Row {
    Eigen::Index at;  // of the three coordinates it looks at
    Vec3 direction;
  };
  std::vector<Row> rows_;
};

/// The greatest force of a joint in a list of multipliers of these supports, N.
double greatest_reaction(const SupportsSpec& supports, const std::vector<Eigen::VectorXd>& multipliers);

}  // namespace plumb
