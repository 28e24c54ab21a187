#pragma once

#include <Eigen/Core>

namespace plumb {

/// The state of a cable at a time.
struct State {
  double t = 0;       ///< s
  Eigen::VectorXd q;  ///< m and 1
  Eigen::VectorXd v;  ///< m/s and 1/s
};

}  // namespace plumb
