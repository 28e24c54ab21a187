#pragma once

#include <Eigen/Core>
#include <cmath>

namespace plumb {

/// The Butcher table of the Gauss method of three stages (Hairer, Lubich and Wanner 2006, section II.1.3).
struct GaussTable {
  static constexpr int stages = 3;
  Eigen::Vector3d c, b;
  Eigen::Matrix3d A;

  GaussTable() {
    const double root = std::sqrt(15.0);
    c << 0.5 - root / 10, 0.5, 0.5 + root / 10;
    b << 5.0 / 18, 4.0 / 9, 5.0 / 18;
    A << 5.0 / 36, 2.0 / 9 - root / 15, 5.0 / 36 - root / 30,  //
        5.0 / 36 + root / 24, 2.0 / 9, 5.0 / 36 - root / 24,   //
        5.0 / 36 + root / 30, 2.0 / 9 + root / 15, 5.0 / 36;
  }
};

}  // namespace plumb
