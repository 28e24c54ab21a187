#include "engine/model/mass.h"

#include <Eigen/LU>

namespace plumb {
namespace {

using Block = Eigen::Matrix2d;

}  // namespace

MassMatrix::MassMatrix(const ElementConstants& element, int elements, const SupportProjection& supports)
    : element_(element), elements_(elements), supports_(supports), across_(factor(true)) {
  const SupportsSpec& ends = supports_.spec();
  if (ends.first == Support::clamped || ends.last == Support::clamped) along_ = factor(false);
}

std::vector<MassFactor> MassMatrix::factor(bool slopes_held) const {
  const double l = element_.length, unit = element_.mass_per_length * l / 420;
  // ∫ sᵢsⱼ of the Hermite functions, exact.
  const Block first = unit * Block{{156, 22 * l}, {22 * l, 4 * l * l}};
  const Block second = unit * Block{{156, -22 * l}, {-22 * l, 4 * l * l}};
  const Block below = unit * Block{{54, 13 * l}, {-13 * l, -3 * l * l}};  // rows of the element's second node
  const SupportsSpec& ends = supports_.spec();
  const int nodes = elements_ + 1, middle = nodes / 2;
  const auto free = [&](int node) {
    const Support support = node == 0 ? ends.first : node == elements_ ? ends.last : Support::free;
    return Eigen::Vector2d(support == Support::free ? 1 : 0,
                           support == Support::clamped && slopes_held ? 0 : 1);
  };
  const auto coupling = [&](int to, int from) -> Block {
    return free(to).asDiagonal() * (to > from ? below : Block(below.transpose())) * free(from).asDiagonal();
  };
  std::vector<Block> diagonal(static_cast<std::size_t>(nodes));
  for (int node = 0; node < nodes; ++node) {
    Block& block = diagonal[static_cast<std::size_t>(node)];
    block.setZero();
    if (node < elements_) block += first;
    if (node > 0) block += second;
    block = (free(node).asDiagonal() * block * free(node).asDiagonal()).eval();
  }
  std::vector<MassFactor> result(diagonal.size());
  const auto take = [&](int node) {
    // The rows and columns that are held are replaced by those of the identity, and their inverse by zeros.
    const Block held = Block((Eigen::Vector2d::Ones() - free(node)).asDiagonal());
    const Block inverse = (diagonal[static_cast<std::size_t>(node)] + held).inverse() - held;
    MassFactor& f = result[static_cast<std::size_t>(node)];
    f.inverse_rr = inverse(0, 0);
    f.inverse_rg = inverse(0, 1);
    f.inverse_gg = inverse(1, 1);
    if (node == middle) return;
    const int towards = node < middle ? node + 1 : node - 1;
    const Block B = coupling(towards, node), multiplier = B * inverse;
    diagonal[static_cast<std::size_t>(towards)] -= multiplier * B.transpose();
    f.rr = multiplier(0, 0);
    f.rg = multiplier(0, 1);
    f.gr = multiplier(1, 0);
    f.gg = multiplier(1, 1);
  };
  for (int node = 0; node < middle; ++node) take(node);
  for (int node = nodes - 1; node > middle; --node) take(node);
  take(middle);
  return result;
}

void MassMatrix::solve(Eigen::VectorXd& x, Eigen::VectorXd& scratch) const {
  const Kernels& k = best_kernels();
  if (along_.empty()) {
    k.mass_solve(elements_ + 1, across_.data(), x.data());
    return;
  }
  scratch = x;
  k.mass_solve(elements_ + 1, across_.data(), x.data());
  k.mass_solve(elements_ + 1, along_.data(), scratch.data());
  const Vec3 d = supports_.direction();
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    auto part = x.segment<3>(i);
    part += d * d.dot(scratch.segment<3>(i) - part);
  }
}

void MassMatrix::multiply(const Eigen::VectorXd& v, Eigen::VectorXd& y) const {
  y.resize(v.size());
  best_kernels().mass_multiply(element_, elements_, v.data(), y.data());
}

double MassMatrix::kinetic_energy(const Eigen::VectorXd& v) const {
  return best_kernels().kinetic_energy(element_, elements_, v.data());
}

}  // namespace plumb
