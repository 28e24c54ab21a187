#include "engine/model/mass.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/kernels/element_mass.h"

namespace plumb {
namespace {

using Block = Eigen::Matrix2d;

/// Σ sᵢ vᵢ: the rate of the point.
Vec3 rate_of(const PointMass& point, const Eigen::VectorXd& v) {
  Vec3 rate = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    rate += point.shape[static_cast<std::size_t>(i)] * v.segment<3>(6 * point.element + 3 * i);
  return rate;
}

/// Its mass between the nodes `row` and `column` of its element, 0 or 1.
Block block_of(const PointMass& point, int row, int column) {
  const Eigen::Map<const Eigen::Vector4d> s(point.shape.data());
  return point.mass * s.segment<2>(2 * row) * s.segment<2>(2 * column).transpose();
}

}  // namespace

std::vector<PointMass> point_masses(const Case& spec) {
  std::vector<PointMass> points;
  for (const MassSpec& mass : spec.masses) {
    const auto [element, place] = place_on_cable(spec.cable, mass.at);
    if (spec.cable.model == CableModel::chain) {
      points.push_back({element, {1, 0, 0, 0}, mass.mass * place.position[0]});
      points.push_back({element, {0, 0, 1, 0}, mass.mass * place.position[2]});
    } else {
      points.push_back({element, place.position, mass.mass});
    }
  }
  return points;
}

std::vector<PointMass> in_units(std::vector<PointMass> points, const OwnUnits& units) {
  for (PointMass& point : points) {
    for (const std::size_t of_slope : {1U, 3U}) point.shape[of_slope] /= units.length;
    point.mass /= units.mass;
  }
  return points;
}

MassMatrix::MassMatrix(const ElementConstants& element, int elements, const SupportProjection& supports,
                       std::vector<PointMass> points)
    : element_(element),
      elements_(elements),
      supports_(supports),
      points_(std::move(points)),
      across_(factor(true)) {
  if (supports_.first().direction || supports_.last().direction) along_ = factor(false);
}

std::shared_ptr<const MassMatrix::Factors> MassMatrix::factor(bool slopes_held) const {
  // Factors whose multipliers differ by less have settled: they follow from one another by a contraction.
  constexpr double settled = 1e-16;
  const double l = element_.length;
  const ElementMass m(element_);
  const Block first{{m.rr, m.rg}, {m.rg, m.gg}}, second{{m.rr, -m.rg}, {-m.rg, m.gg}};
  const Block below{{m.r1r0, -m.g1r0}, {m.g1r0, m.g1g0}};  // rows of the element's second node
  const int nodes = elements_ + 1, middle = nodes / 2;
  const auto free = [&](int node) {
    const Hold hold = node == 0 ? supports_.first() : node == elements_ ? supports_.last() : Hold{};
    return Eigen::Vector2d(hold.position ? 0 : 1, hold.direction && slopes_held ? 0 : 1);
  };
  // The rows and columns that are held are replaced by those of the identity, and their inverse by zeros.
  const auto inverse_of = [&](int node, const Block& taken_off) -> Block {
    const Block held = Block((Eigen::Vector2d::Ones() - free(node)).asDiagonal());
    Block block = Block::Zero();
    if (node < elements_) block += first;
    if (node > 0) block += second;
    for (const PointMass& point : points_)
      if (const int own = node - point.element; own == 0 || own == 1) block += block_of(point, own, own);
    return (free(node).asDiagonal() * block * free(node).asDiagonal() - taken_off + held).inverse() - held;
  };
  const auto entry = [](const Block& inverse, const Block& multiplier) {
    return MassFactor{multiplier(0, 0), multiplier(0, 1), multiplier(1, 0), multiplier(1, 1),
                      inverse(0, 0),    inverse(0, 1),    inverse(1, 1)};
  };
  // On the way from a node to another, or on the element just left.
  const auto has_point_between = [&](int node, int to) {
    return std::any_of(points_.begin(), points_.end(), [&](const PointMass& point) {
      return to > node ? point.element >= node - 1 && point.element < to
                       : point.element <= node && point.element >= to;
    });
  };
  // What the node at the end of a list takes off the block of its neighbour towards the middle.
  const auto eliminate = [&](int from, int step, std::vector<MassFactor>& list) {
    Block taken_off = Block::Zero(), before = Block::Zero();
    for (int node = from; node != middle; node += step) {
      const int towards = node + step, element = std::min(node, towards);
      Block lower = below;
      for (const PointMass& point : points_)
        if (point.element == element) lower += block_of(point, 1, 0);
      const Block B = free(towards).asDiagonal() * (step > 0 ? lower : Block(lower.transpose())) *
                      free(node).asDiagonal();
      const Block inverse = inverse_of(node, taken_off), multiplier = B * inverse;
      list.push_back(entry(inverse, multiplier));
      taken_off = multiplier * B.transpose();
      // The node before the middle may have a held neighbour.
      const bool inner = node != from && towards != middle && !has_point_between(node, middle);
      const Block change = (multiplier - before).cwiseAbs();
      const Block scale = Block{{1, 1 / l}, {l, 1}};
      if (inner && (change.array() <= settled * scale.array()).all() && std::abs(middle - node) > 2) break;
      before = multiplier;
    }
    return taken_off;
  };
  auto result = std::make_shared<Factors>();
  Block taken_off = eliminate(0, 1, result->from_left);
  taken_off += eliminate(nodes - 1, -1, result->from_right);
  // The chain of one element has no right half.
  if (result->from_right.empty()) result->from_right.emplace_back();
  result->middle = entry(inverse_of(middle, taken_off), Block::Zero());
  result->view = {result->from_left.data(), result->from_right.data(),
                  static_cast<int>(result->from_left.size()), static_cast<int>(result->from_right.size()),
                  &result->middle};
  return result;
}

void MassMatrix::solve(Eigen::VectorXd& x, Eigen::VectorXd& scratch) const {
  const Kernels& k = best_kernels();
  if (!along_) {
    k.mass_solve(elements_ + 1, across_->view, x.data());
    return;
  }
  scratch = x;
  k.mass_solve(elements_ + 1, across_->view, x.data());
  k.mass_solve(elements_ + 1, along_->view, scratch.data());
  const Vec3 d = supports_.direction();
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    auto part = x.segment<3>(i);
    part += d * d.dot(scratch.segment<3>(i) - part);
  }
}

void MassMatrix::multiply(const Eigen::VectorXd& v, Eigen::VectorXd& y) const {
  y.resize(v.size());
  best_kernels().mass_multiply(element_, elements_, v.data(), y.data());
  for (const PointMass& point : points_) {
    const Vec3 momentum = point.mass * rate_of(point, v);
    for (int i = 0; i < 4; ++i)
      y.segment<3>(6 * point.element + 3 * i) += point.shape[static_cast<std::size_t>(i)] * momentum;
  }
}

void MassMatrix::add_points(double factor, BlockTridiagonal& A) const {
  // m ⊗ I₃: of each 3 by 3 block the diagonal.
  const auto add = [&](BlockTridiagonal::Map to, const Block& m) {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 3; ++k) to(3 * i + k, 3 * j + k) += factor * m(i, j);
  };
  for (const PointMass& point : points_) {
    add(A.diagonal(point.element), block_of(point, 0, 0));
    add(A.below(point.element), block_of(point, 1, 0));
    add(A.diagonal(point.element + 1), block_of(point, 1, 1));
  }
}

double MassMatrix::kinetic_energy_of_points(const Eigen::VectorXd& v) const {
  double sum = 0;
  for (const PointMass& point : points_) sum += 0.5 * point.mass * rate_of(point, v).squaredNorm();
  return sum;
}

double MassMatrix::kinetic_energy(const Eigen::VectorXd& v) const {
  return best_kernels().kinetic_energy(element_, elements_, v.data()) + kinetic_energy_of_points(v);
}

}  // namespace plumb
