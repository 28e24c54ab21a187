#include "engine/base/least_squares.h"

#include <Eigen/QR>

namespace plumb {

LeastSquares least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(A);
  return {factors.solve(b), factors.rank()};
}

}  // namespace plumb
