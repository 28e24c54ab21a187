#include "engine/model/supports.h"

#include <cmath>

#include "engine/model/block_lu.h"
#include "engine/model/block_tridiagonal.h"

namespace plumb {
namespace {

/// P of one node.
Block6 node_projection(const Hold& hold, const Vec3& direction) {
  Block6 P = Block6::Identity();
  if (hold.position) P.topLeftCorner<3, 3>().setZero();
  if (hold.direction) P.bottomRightCorner<3, 3>() = direction * direction.transpose();
  return P;
}

/// P x of one node, in place.
void hold_numbers(const Hold& hold, const Vec3& direction, double* numbers) {
  if (hold.position) Eigen::Map<Vec3>(numbers).setZero();
  if (!hold.direction) return;
  Eigen::Map<Vec3> slope(numbers + 3);
  slope = direction * direction.dot(slope);
}

/// A positive number of the size of a diagonal of D, for what is held there: beside a 1, which is of no unit,
/// the numbers of a small or a light cable are round-off.
template <class Diagonal>
double size_of(const Diagonal& diagonal) {
  const double greatest = diagonal.cwiseAbs().maxCoeff();
  return greatest > 0 && std::isfinite(greatest) ? greatest : 1;
}

/// A node's diagonal block becomes P D P + s (I − P); of D the lower triangle counts.
void hold_diagonal(const Hold& hold, const Vec3& direction, BlockTridiagonal::Map D) {
  if (hold.position) {
    const double size = size_of(D.diagonal().head<3>());
    D.leftCols<3>().setZero();
    D.topLeftCorner<3, 3>().diagonal().setConstant(size);
  }
  if (!hold.direction) return;
  const Eigen::Matrix3d along = direction * direction.transpose();
  if (!hold.position) D.bottomLeftCorner<3, 3>() = (along * D.bottomLeftCorner<3, 3>()).eval();
  const Eigen::Matrix3d slopes = D.bottomRightCorner<3, 3>().selfadjointView<Eigen::Lower>();
  D.bottomRightCorner<3, 3>() = direction.dot(slopes * direction) * along +
                                size_of(slopes.diagonal()) * (Eigen::Matrix3d::Identity() - along);
}

}  // namespace

Hold hold_of(Support support) {
  switch (support) {
    case Support::free:
      return {};
    case Support::pinned:
      return {.position = true};
    case Support::clamped:
      return {.position = true, .direction = true};
  }
  return {};
}

SupportProjection::SupportProjection(const SupportsSpec& supports, const Vec3& direction, int nodes,
                                     CableModel model)
    : spec_(supports),
      first_(hold_of(supports.first)),
      last_(hold_of(supports.last)),
      direction_(direction),
      nodes_(nodes),
      slopes_held_(model == CableModel::chain) {}

void SupportProjection::apply(Eigen::VectorXd& x) const {
  hold(false, x.data());
  hold(true, x.data() + 6 * (nodes_ - 1));
  if (!slopes_held_) return;
  for (int node = 0; node < nodes_; ++node) x.segment<3>(6 * node + 3).setZero();
}

void SupportProjection::hold(bool last, double* numbers) const {
  hold_numbers(last ? last_ : first_, direction_, numbers);
}

void SupportProjection::hold_first(double* column) const {
  if (first_.none()) return;
  hold_diagonal(first_, direction_, BlockTridiagonal::Map(column));
  BlockTridiagonal::Map below(column + 6);
  if (first_.position) below.leftCols<3>().setZero();
  if (!first_.direction) return;
  const Eigen::Matrix<double, 6, 1> along = below.rightCols<3>() * direction_;
  below.rightCols<3>() = along * direction_.transpose();
}

void SupportProjection::hold_last(double* column_before, double* column) const {
  if (last_.none()) return;
  hold_diagonal(last_, direction_, BlockTridiagonal::Map(column));
  for (int j = 0; j < 6; ++j) hold_numbers(last_, direction_, column_before + 12 * j + 6);
}

void SupportProjection::apply(BlockTridiagonal& A) const {
  const auto column = [&](int node) { return A.data() + block_column_size * node; };
  hold_first(column(0));
  hold_last(column(nodes_ - 2), column(nodes_ - 1));
  if (!slopes_held_) return;
  // Slopes are coupled to nothing.
  for (int node = 0; node < nodes_; ++node)
    A.diagonal(node).bottomRightCorner<3, 3>().setIdentity() *=
        size_of(A.diagonal(node).diagonal().head<3>());
}

void SupportProjection::apply(GeneralBlockTridiagonal<double>& A) const {
  const auto apply_at = [&](const Hold& hold, int node) {
    if (hold.none()) return;
    const Block6 P = node_projection(hold, direction_);
    Block6& diagonal = A.diagonal[static_cast<std::size_t>(node)];
    Block6 size = Block6::Zero();
    size.diagonal().head<3>().setConstant(size_of(diagonal.diagonal().head<3>()));
    size.diagonal().tail<3>().setConstant(size_of(diagonal.diagonal().tail<3>()));
    diagonal = (P * diagonal * P + size * (Block6::Identity() - P)).eval();
    const std::size_t beside = static_cast<std::size_t>(node == 0 ? 0 : node - 1);
    Block6& rows = node == 0 ? A.above[beside] : A.below[beside];
    Block6& columns = node == 0 ? A.below[beside] : A.above[beside];
    rows = (P * rows).eval();
    columns = (columns * P).eval();
  };
  apply_at(first_, 0);
  apply_at(last_, nodes_ - 1);
  if (!slopes_held_) return;
  for (Block6& diagonal : A.diagonal)
    diagonal.bottomRightCorner<3, 3>().setIdentity() *= size_of(diagonal.diagonal().head<3>());
}

}  // namespace plumb
