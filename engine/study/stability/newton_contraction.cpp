#include "engine/study/stability/newton_contraction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/integrate/dynamics.h"
#include "engine/integrate/method_info.h"
#include "engine/integrate/state_at.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

std::optional<NewtonMatrix> newton_matrix(const MethodSpec& method) {
  const MethodInfo* info = find_method(method.name);
  if (info == nullptr || info->newton_matrix == nullptr) return std::nullopt;
  return info->newton_matrix(method);
}

double newton_contraction(const Cable& cable, const NewtonMatrix& matrix, double h, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& q_solution, double roughly) {
  constexpr int most_iterations = 200;
  constexpr double settled = 1e-4, roughly_settled = 0.1;
  Dynamics dynamics(cable);
  if (dynamics.factor(q, matrix.mass, matrix.stiffness * h * h)) return unbounded;
  BlockTridiagonal solution(cable.nodes());
  cable.system(q_solution, matrix.mass, matrix.stiffness * h * h, solution);
  cable.supports().apply(solution);
  Eigen::VectorXd error = Eigen::VectorXd::LinSpaced(cable.size(), 1, 2), left;
  for (Eigen::Index i = 0; i < error.size(); i += 2) error[i] = -error[i];
  cable.supports().apply(error);
  error.normalize();
  // Of two iterations together: the greatest eigenvalues may come as ±θ.
  double before = 0, theta = 0;
  for (int i = 0; i < most_iterations; ++i) {
    double growth = 1;
    for (int twice = 0; twice < 2; ++twice) {
      solution.multiply(error, left);
      dynamics.solve(left);
      error -= left;
      cable.supports().apply(error);
      const double size = error.norm();
      if (!(size > 0)) return 0;
      if (!std::isfinite(size)) return unbounded;
      error /= size;
      growth *= size;
    }
    theta = std::sqrt(growth);
    if (std::abs(theta - before) <= (theta < roughly ? roughly_settled : settled) * theta) break;
    before = theta;
  }
  return theta;
}

PredictedLimit contraction_limit(const Cable& cable, const MethodSpec& method, const Trajectory& motion) {
  const auto matrix = newton_matrix(method);
  if (!matrix || motion.times.size() < 2) return {};
  const double end = motion.times.back();
  const auto theta = [&](double t, double h) {
    constexpr double far_below_1 = 0.5;
    return newton_contraction(cable, *matrix, h, state_at(motion, t).q,
                              state_at(motion, t + matrix->point * h).q, far_below_1);
  };
  // The first step at t that is too long, below `longest`.
  const auto limit_at = [&](double t, double longest) {
    constexpr double ratio = 1.1, first = 1e-4, precision = 0.01;
    double contracts = 0;
    for (double h = first * end; h <= longest && t + h <= end; h *= ratio) {
      if (theta(t, h) < 1) {
        contracts = h;
        continue;
      }
      double fails = h;
      while (contracts > 0 && fails > (1 + precision) * contracts) {
        const double middle = std::sqrt(contracts * fails);
        (theta(t, middle) < 1 ? contracts : fails) = middle;
      }
      return fails;
    }
    return unbounded;
  };
  PredictedLimit limit;
  limit.at_start = limit.at_worst = limit_at(0, end);
  constexpr int states = 100;
  for (int k = 1; k < states; ++k)
    limit.at_worst = std::min(limit.at_worst, limit_at(end * k / states, limit.at_worst));
  return limit;
}

}  // namespace plumb
