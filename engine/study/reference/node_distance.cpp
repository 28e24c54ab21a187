#include "engine/study/reference/node_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

double distance_at(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double greatest = 0;
  for (Eigen::Index node = 0; node < a.size(); node += 6) {
    const double distance = (a.segment<3>(node) - b.segment<3>(node)).norm();
    if (!std::isfinite(distance)) return std::numeric_limits<double>::infinity();
    greatest = std::max(greatest, distance);
  }
  return greatest;
}

}  // namespace

double node_distance(const Trajectory& a, const Trajectory& b, double until) {
  double greatest = -1;
  for (std::size_t k = 0; k < std::min(a.times.size(), b.times.size()); ++k) {
    if (a.times[k] > until) break;
    if (a.times[k] != b.times[k] || a.q[k].size() != b.q[k].size()) return -1;
    greatest = std::max(greatest, distance_at(a.q[k], b.q[k]));
  }
  return greatest;
}

double together_until(const Trajectory& a, const Trajectory& b, double apart) {
  double until = -1;
  for (std::size_t k = 0; k < std::min(a.times.size(), b.times.size()); ++k) {
    if (a.times[k] != b.times[k] || a.q[k].size() != b.q[k].size()) break;
    if (!(distance_at(a.q[k], b.q[k]) <= apart)) break;
    until = a.times[k];
  }
  return until;
}

}  // namespace plumb
