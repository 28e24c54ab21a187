#include "engine/integrate/linear_stability.h"

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <limits>

#include "engine/integrate/method_info.h"

namespace plumb {

double radius_of_pair(const Eigen::Matrix2d& map) {
  const double half_trace = 0.5 * map.trace(), half_difference = 0.5 * (map(0, 0) - map(1, 1));
  const double discriminant = half_difference * half_difference + map(0, 1) * map(1, 0);
  if (discriminant < 0) return std::sqrt(map.determinant());
  return std::abs(half_trace) + std::sqrt(discriminant);
}

double runge_kutta_amplification(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double z) {
  using Complex = std::complex<double>;
  const Eigen::Index s = b.size();
  const Complex iz(0, z);
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(s, s) - iz * A;
  const Eigen::VectorXcd stages = system.partialPivLu().solve(Eigen::VectorXcd::Ones(s));
  return std::abs(1.0 + iz * (b.cast<Complex>().transpose() * stages).value());
}

std::optional<double> amplification(const MethodSpec& method, double z) {
  const bool chooses_steps = method.rtol && !method.step;
  const MethodInfo* info = find_method(method.name);
  if (chooses_steps || info == nullptr || info->amplification == nullptr) return std::nullopt;
  // As z goes to 0 the largest root of every method that converges goes to 1; 0 itself has no scale.
  return info->amplification(method, z == 0 ? std::numeric_limits<double>::min() : z);
}

std::optional<double> stability_limit(const MethodSpec& method) {
  // Growth by less is round-off of a root on the unit circle.
  constexpr double round_off = 1e-9, small_round_off = 1e-12;
  constexpr double fine = 0.01, fine_until = 20, ratio = 1.05;
  // Beyond, the roots of every method here have all but settled, and those of some are so close that their
  // round-off is more.
  constexpr double last = 1e3;
  if (!amplification(method, 1)) return std::nullopt;
  const auto grows = [&](double z) { return *amplification(method, z) > 1 + round_off; };
  double stable = 0;
  for (double z = fine; z <= last; z = z < fine_until ? z + fine : z * ratio) {
    if (!grows(z)) {
      stable = z;
      continue;
    }
    double unstable = z;
    while (unstable - stable > 1e-12 * unstable) {
      const double middle = 0.5 * (stable + unstable);
      (grows(middle) ? unstable : stable) = middle;
    }
    // What grows at half of that already, and by less than round_off only because growth is a power of z,
    // grows at every step.
    return *amplification(method, 0.5 * stable) > 1 + small_round_off ? 0 : stable;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace plumb
