#pragma once

#include <array>

namespace plumb {

/// The Runge-Kutta-Nyström pair of orders 8 and 6 of Dormand, El-Mikkawy and Prince (1987, IMA Journal of
/// Numerical Analysis 7, 423–430) for q'' = f(q), nine stages of which the last is the first of the next
/// step:
///   kᵢ = f(q + cᵢ h v + h² Σ aᵢⱼ kⱼ),   q₁ = q + h v + h² Σ bᵢ kᵢ,   v₁ = v + h Σ b'ᵢ kᵢ;
/// the last row of a is b. `lower` are the position weights of the embedded formula of order 6.
struct NystromPair {
  static constexpr int stages = 9;
  using Row = std::array<double, stages>;

  static constexpr Row c{0, 1.0 / 20, 1.0 / 10, 3.0 / 10, 1.0 / 2, 7.0 / 10, 9.0 / 10, 1, 1};
  static constexpr std::array<Row, stages> a{{
      {},
      {1.0 / 800},
      {1.0 / 600, 1.0 / 300},
      {9.0 / 200, -9.0 / 100, 9.0 / 100},
      {-66701.0 / 197352, 28325.0 / 32892, -2665.0 / 5482, 2170.0 / 24669},
      {227015747.0 / 304251000, -54897451.0 / 30425100, 12942349.0 / 10141700, -9499.0 / 304251,
       539.0 / 9250},
      {-1131891597.0 / 901789000, 41964921.0 / 12882700, -6663147.0 / 3220675, 270954.0 / 644135,
       -108.0 / 5875, 114.0 / 1645},
      {13836959.0 / 3667458, -17731450.0 / 1833729, 1063919505.0 / 156478208, -33213845.0 / 39119552,
       13335.0 / 28544, -705.0 / 14272, 1645.0 / 57088},
      {223.0 / 7938, 0, 1175.0 / 8064, 925.0 / 6048, 41.0 / 448, 925.0 / 14112, 1175.0 / 72576},
  }};
  static constexpr const Row& b = a[8];
  static constexpr Row velocity{
      223.0 / 7938, 0, 5875.0 / 36288, 4625.0 / 21168, 41.0 / 224, 4625.0 / 21168, 5875.0 / 36288,
      223.0 / 7938, 0};
  static constexpr Row lower{7987313.0 / 109941300,
                             0,
                             1610737.0 / 44674560,
                             10023263.0 / 33505920,
                             -497221.0 / 12409600,
                             10023263.0 / 78180480,
                             1610737.0 / 402071040,
                             0,
                             0};
};

}  // namespace plumb
