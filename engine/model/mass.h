#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "engine/model/supports.h"

namespace plumb {

class BlockTridiagonal;

/// The constant, consistent mass matrix ∫ ρA sᵢsⱼ dx of a mesh of equal elements. It is m ⊗ I₃ with a scalar
/// band matrix m of half bandwidth 3 over (r₀, r'₀, r₁, r'₁, …), which is all that is stored; it is factored
/// once, with the supports applied.
class MassMatrix {
 public:
  /// ρA in kg/m and l in m, both > 0.
  MassMatrix(double mass_per_length, double element_length, int elements, const SupportProjection& supports);

  /// y := M v, without supports.
  void multiply(const Eigen::VectorXd& v, Eigen::VectorXd& y) const;

  /// x := the acceleration that the force x gives the supported cable: P M P a = P x with a = P a.
  void solve(Eigen::VectorXd& x) const;

  /// Adds factor · M to A.
  void add_to(BlockTridiagonal& A, double factor) const;

  /// ½ vᵀ M v, J.
  double kinetic_energy(const Eigen::VectorXd& v) const;

 private:
  static constexpr int half_bandwidth = 3;

  /// L D Lᵀ of the scalar band matrix with some rows and columns replaced by those of the identity.
  struct Factor {
    std::vector<std::array<double, half_bandwidth>> lower;  // L(i, i−1), L(i, i−2), L(i, i−3)
    std::vector<double> inverse_diagonal;                   // 0 where held

    /// Solves for `components` right-hand sides that lie interleaved in x.
    template <int components>
    void solve(double* x) const;
  };

  /// `slopes_held`: clamped ends hold their slope too.
  Factor factor(bool slopes_held) const;
  double entry(int i, int j) const;

  SupportProjection supports_;
  int scalars_;                             // 2 (elements + 1)
  std::array<std::array<double, 4>, 4> m_;  // of one element
  Factor across_;                           // for motion across the clamped direction
  std::optional<Factor> along_;             // for motion along it; only with a clamped end
};

}  // namespace plumb
