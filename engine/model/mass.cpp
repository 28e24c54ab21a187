#include "engine/model/mass.h"

#include <algorithm>

#include "engine/model/block_tridiagonal.h"

namespace plumb {

MassMatrix::MassMatrix(double mass_per_length, double element_length, int elements,
                       const SupportProjection& supports)
    : supports_(supports), scalars_(2 * (elements + 1)) {
  const double l = element_length, unit = mass_per_length * l / 420;
  // ∫ sᵢsⱼ of the Hermite functions, exact.
  m_ = {{{156, 22 * l, 54, -13 * l},
         {22 * l, 4 * l * l, 13 * l, -3 * l * l},
         {54, 13 * l, 156, -22 * l},
         {-13 * l, -3 * l * l, -22 * l, 4 * l * l}}};
  for (auto& row : m_)
    for (double& number : row) number *= unit;
  across_ = factor(true);
  const SupportsSpec& ends = supports_.spec();
  if (ends.first == Support::clamped || ends.last == Support::clamped) along_ = factor(false);
}

double MassMatrix::entry(int i, int j) const {
  const int last_element = scalars_ / 2 - 2;
  double sum = 0;
  for (int e = std::max(0, std::max(i, j) / 2 - 1); e <= std::min(last_element, std::min(i, j) / 2); ++e)
    sum += m_[static_cast<std::size_t>(i - 2 * e)][static_cast<std::size_t>(j - 2 * e)];
  return sum;
}

MassMatrix::Factor MassMatrix::factor(bool slopes_held) const {
  const SupportsSpec& ends = supports_.spec();
  const auto held = [&](int i) {
    if (i >= 2 && i < scalars_ - 2) return false;
    const Support support = i < 2 ? ends.first : ends.last;
    if (i % 2 == 0) return support != Support::free;
    return support == Support::clamped && slopes_held;
  };
  Factor result;
  const auto n = static_cast<std::size_t>(scalars_);
  result.lower.resize(n);
  result.inverse_diagonal.resize(n);
  std::vector<double> diagonal(n, 0);
  for (int i = 0; i < scalars_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    result.lower[at] = {0, 0, 0};
    result.inverse_diagonal[at] = 0;
    if (held(i)) continue;
    double pivot = entry(i, i);
    // Row i of L from left to right: L(i,j) D(j) = m(i,j) − Σ_{k<j} L(i,k) D(k) L(j,k).
    const int first = std::max(0, i - half_bandwidth);
    for (int j = first; j < i; ++j) {
      if (held(j)) continue;
      double sum = entry(i, j);
      for (int k = std::max(first, j - half_bandwidth); k < j; ++k)
        sum -= result.lower[at][static_cast<std::size_t>(i - k - 1)] * diagonal[static_cast<std::size_t>(k)] *
               result.lower[static_cast<std::size_t>(j)][static_cast<std::size_t>(j - k - 1)];
      const double multiplier = sum * result.inverse_diagonal[static_cast<std::size_t>(j)];
      result.lower[at][static_cast<std::size_t>(i - j - 1)] = multiplier;
      pivot -= multiplier * sum;
    }
    diagonal[at] = pivot;
    result.inverse_diagonal[at] = 1 / pivot;
  }
  return result;
}

template <int components>
void MassMatrix::Factor::solve(double* x) const {
  const auto n = static_cast<int>(lower.size());
  for (int i = 0; i < n; ++i) {
    const auto& row = lower[static_cast<std::size_t>(i)];
    for (int j = 1; j <= std::min(half_bandwidth, i); ++j)
      for (int c = 0; c < components; ++c)
        x[components * i + c] -= row[static_cast<std::size_t>(j - 1)] * x[components * (i - j) + c];
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int c = 0; c < components; ++c)
      x[components * i + c] *= inverse_diagonal[static_cast<std::size_t>(i)];
    for (int j = 1; j <= std::min(half_bandwidth, n - 1 - i); ++j) {
      const double multiplier = lower[static_cast<std::size_t>(i + j)][static_cast<std::size_t>(j - 1)];
      for (int c = 0; c < components; ++c) x[components * i + c] -= multiplier * x[components * (i + j) + c];
    }
  }
}

void MassMatrix::solve(Eigen::VectorXd& x) const {
  if (!along_) {
    across_.solve<3>(x.data());
    return;
  }
  const Vec3 d = supports_.direction();
  Eigen::VectorXd along(scalars_);
  for (int i = 0; i < scalars_; ++i) along[i] = d.dot(x.segment<3>(3 * i));
  across_.solve<3>(x.data());
  along_->solve<1>(along.data());
  for (int i = 0; i < scalars_; ++i) {
    auto part = x.segment<3>(3 * i);
    part += d * (along[i] - d.dot(part));
  }
}

void MassMatrix::multiply(const Eigen::VectorXd& v, Eigen::VectorXd& y) const {
  y.setZero(v.size());
  for (int e = 0; e + 1 < scalars_ / 2; ++e)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        y.segment<3>(6 * e + 3 * i) +=
            m_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] * v.segment<3>(6 * e + 3 * j);
}

void MassMatrix::add_to(BlockTridiagonal& A, double factor) const {
  const auto add = [&](BlockTridiagonal::Block& block, std::size_t row, std::size_t column) {
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        for (int k = 0; k < 3; ++k)
          block(3 * static_cast<int>(i) + k, 3 * static_cast<int>(j) + k) += factor * m_[row + i][column + j];
  };
  for (int e = 0; e + 1 < A.nodes(); ++e) {
    add(A.diagonal(e), 0, 0);
    add(A.upper(e), 0, 2);
    add(A.diagonal(e + 1), 2, 2);
  }
}

double MassMatrix::kinetic_energy(const Eigen::VectorXd& v) const {
  double sum = 0;
  for (int e = 0; e + 1 < scalars_ / 2; ++e)
    for (int i = 0; i < 4; ++i) {
      const auto vi = v.segment<3>(6 * e + 3 * i);
      sum += 0.5 * m_[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)] * vi.squaredNorm();
      for (int j = 0; j < i; ++j)
        sum += m_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] *
               vi.dot(v.segment<3>(6 * e + 3 * j));
    }
  return sum;
}

}  // namespace plumb
