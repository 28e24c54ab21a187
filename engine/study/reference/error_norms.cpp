#include "engine/study/reference/error_norms.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/model/hermite.h"
#include "engine/model/quadrature.h"

namespace plumb {

std::string_view word(ErrorNorm norm) {
  switch (norm) {
    case ErrorNorm::tip_max:
      return "tip-max";
    case ErrorNorm::tip_rms:
      return "tip-rms";
    case ErrorNorm::curve:
      return "curve";
    case ErrorNorm::energy:
      return "energy";
  }
  return "";
}

std::string_view unit(ErrorNorm norm) {
  return norm == ErrorNorm::energy ? "1" : "m";
}

double value(const ErrorNorms& norms, ErrorNorm norm) {
  switch (norm) {
    case ErrorNorm::tip_max:
      return norms.tip_max;
    case ErrorNorm::tip_rms:
      return norms.tip_rms;
    case ErrorNorm::curve:
      return norms.curve;
    case ErrorNorm::energy:
      return norms.energy;
  }
  return -1;
}

namespace {

/// A point of the cable on one mesh: where its element's coordinates begin in q, and their shape functions.
struct Sample {
  Eigen::Index first;
  std::array<double, 4> shape;

  Eigen::Vector3d position(const Eigen::VectorXd& q) const {
    Eigen::Vector3d r = Eigen::Vector3d::Zero();
    for (int i = 0; i < 4; ++i) r += shape[static_cast<std::size_t>(i)] * q.segment<3>(first + 3 * i);
    return r;
  }
};

Sample sample(const Trajectory& on, int element, double s) {
  return {6 * Eigen::Index{element}, Hermite::values(s * on.elements - element, on.element_length)};
}

struct PairOfSamples {
  Sample a, b;
  double weight;  // they add up to 1
};

/// Gauss points between all neighbouring nodes of the two meshes.
std::vector<PairOfSamples> common_samples(const Trajectory& a, const Trajectory& b) {
  constexpr int points = 5;
  std::vector<PairOfSamples> samples;
  double from = 0;
  for (int i = 0, j = 0; i < a.elements && j < b.elements;) {
    const long end_a = long{i + 1} * b.elements, end_b = long{j + 1} * a.elements;
    const double to = end_a <= end_b ? double(i + 1) / a.elements : double(j + 1) / b.elements;
    for (const QuadraturePoint& point : gauss_rule(points)) {
      const double s = from + (to - from) * point.x;
      samples.push_back({sample(a, i, s), sample(b, j, s), (to - from) * point.weight});
    }
    i += end_a <= end_b ? 1 : 0;
    j += end_b <= end_a ? 1 : 0;
    from = to;
  }
  return samples;
}

}  // namespace

ErrorNorms error_norms(const Trajectory& run, const Trajectory& reference) {
  ErrorNorms norms;
  norms.energy = run.relative_energy_drift();
  // At the start alone every run is where its reference is.
  if (run.times.size() < 2 || run.times != reference.times) return norms;
  const std::vector<PairOfSamples> samples = common_samples(run, reference);
  double tip_squares = 0, curve_squares = 0, worst = 0;
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    const Eigen::VectorXd &a = run.q[k], &b = reference.q[k];
    const double tip = (a.segment<3>(a.size() - 6) - b.segment<3>(b.size() - 6)).norm();
    // One that is not a number stays.
    if (!(tip <= worst) && !std::isnan(worst)) worst = tip;
    tip_squares += tip * tip;
    for (const PairOfSamples& pair : samples)
      curve_squares += pair.weight * (pair.a.position(a) - pair.b.position(b)).squaredNorm();
  }
  const auto outputs = static_cast<double>(run.times.size());
  norms.tip_max = worst;
  norms.tip_rms = std::sqrt(tip_squares / outputs);
  norms.curve = std::sqrt(curve_squares / outputs);
  return norms;
}

}  // namespace plumb
