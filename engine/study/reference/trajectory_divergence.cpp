#include "engine/study/reference/trajectory_divergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/integrate/method_roles.h"
#include "engine/integrate/monitor.h"
#include "engine/model/cable.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "engine/study/reference/node_distance.h"

namespace plumb {
namespace {

/// The same steps for every motion, so that what the method does wrong it does to both neighbours: ωh of the
/// fastest vibration at the start, about half of the method's limit, and fewer where that does not serve.
constexpr double first_z = 1.5;
constexpr int most_halved = 3;

double greatest_distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double greatest = 0;
  for (Eigen::Index node = 0; node < a.size(); node += 6)
    greatest = std::max(greatest, (a.segment<3>(node) - b.segment<3>(node)).norm());
  return greatest;
}

/// A change of the coordinates that the supports allow, with no direction preferred, whose greatest change of
/// a position is 1 m.
Eigen::VectorXd random_change(const Cable& cable) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Eigen::VectorXd change(cable.size());
  for (Eigen::Index i = 0; i < change.size(); ++i)
    change[i] = normal(random) / (i % 6 < 3 ? 1 : cable.length());
  cable.supports().apply(change);
  return change / greatest_distance(change, Eigen::VectorXd::Zero(change.size()));
}

class Neighbours {
 public:
  Neighbours(const Case& spec, double time_limit)
      : spec_(spec), cable_(spec), change_(random_change(cable_)), time_limit_(time_limit) {
    constexpr double outputs = 500;
    swing_ = Monitor(cable_, {0, cable_.start_q(spec.start), cable_.start_v(spec.start)}, spec.time.end)
                 .own_time() /
             (4 * std::numbers::pi);
    const double wished = std::min(spec.time.output_interval, spec.time.end / outputs);
    time_ = {spec.time.end, spec.time.end / std::ceil(spec.time.end / wished)};
    method_ = plain_method(accurate_explicit(spec));
    const double omega = fastest_vibration(cable_, cable_.start_q(spec.start)).frequency;
    double steps = std::ceil(std::max(time_.output_interval * omega / first_z, 4.0));
    for (int halvings = 0; halvings <= most_halved; ++halvings, steps *= 2) {
      method_.step = time_.output_interval / steps;
      motion_ = run(0);
      if (motion_.outcome == Outcome::completed || motion_.outcome == Outcome::out_of_time) break;
    }
  }

  const Trajectory& motion() const { return motion_; }

  double length() const { return cable_.length(); }

  /// The motion from a start moved by that much, m.
  Trajectory run(double apart) const {
    State start{0, cable_.start_q(spec_.start), cable_.start_v(spec_.start)};
    start.q += apart * change_;
    return integrate(cable_, start, method_, time_, {}, time_limit_);
  }

  /// Mean growth of the logarithm of a small distance along the motion, 1/s.
  double exponent() const {
    // Small against the motion and large against its round-off.
    const double small = 1e-8 * cable_.length();
    // The change first turns into the direction that grows most.
    constexpr double turning = 0.2;
    const TimeSpec once{time_.output_interval, time_.output_interval};
    Eigen::VectorXd dq = change_, dv = Eigen::VectorXd::Zero(cable_.size());
    double sum = 0, time = 0;
    for (std::size_t k = 0; k + 1 < motion_.q.size(); ++k) {
      const double scale = small / size(dq, dv);
      dq *= scale;
      dv *= scale;
      const State start{0, motion_.q[k] + dq, motion_.v[k] + dv};
      const Trajectory step = integrate(cable_, start, method_, once, {}, time_limit_);
      if (step.outcome != Outcome::completed) break;
      dq = step.q.back() - motion_.q[k + 1];
      dv = step.v.back() - motion_.v[k + 1];
      const double after = size(dq, dv);
      if (!(after > 0) || !std::isfinite(after)) break;
      if (motion_.times[k] < turning * motion_.times.back()) continue;
      sum += std::log(after / small);
      time += time_.output_interval;
    }
    return time > 0 ? sum / time : 0;
  }

 private:
  /// Of a change of the state, m: rates count by the time that a swing of the cable takes.
  double size(const Eigen::VectorXd& dq, const Eigen::VectorXd& dv) const {
    Eigen::VectorXd inertia;
    cable_.mass().multiply(dq, inertia);
    double squares = dq.dot(inertia);
    cable_.mass().multiply(dv, inertia);
    squares += swing_ * swing_ * dv.dot(inertia);
    return std::sqrt(squares / (cable_.constants().mass_per_length * cable_.length()));
  }

  Case spec_;
  Cable cable_;
  Eigen::VectorXd change_;
  double swing_;  // s
  double time_limit_;
  TimeSpec time_;
  MethodSpec method_;
  Trajectory motion_;
};

std::string in_words(const TrajectoryDivergence& s, double tolerance, double apart) {
  if (s.times.empty()) return "the motion could not be followed";
  const double end = s.times.back();
  if (s.beyond_end)
    return fmt::format(
        "two starts {:.1g} m apart stay within {:.2g} m of each other up to {:.3g} s: trajectories can be "
        "compared to the end",
        apart, *std::ranges::max_element(s.distances), end);
  if (s.horizon == end)
    return fmt::format(
        "two starts {:.1g} m apart stay within {:.2g} m of each other up to {:.3g} s, where the motion could "
        "be followed no longer: nothing is known of what comes after",
        apart, tolerance, end);
  const std::string pace =
      s.exponent > 0 ? fmt::format(", tenfold in {:.2g} s at the mean", std::log(10) / s.exponent) : "";
  return fmt::format(
      "two starts {:.1g} m apart are more than {:.2g} m apart after {:.3g} s{}: beyond that no trajectory "
      "can "
      "be held against another, only energies and statistics",
      apart, tolerance, s.horizon, pace);
}

}  // namespace

TrajectoryDivergence divergence(const Case& spec, double parameter, double tolerance, double apart,
                                double time_limit) {
  TrajectoryDivergence result;
  result.parameter = parameter;
  result.elements = spec.cable.elements;
  const Neighbours neighbours(spec, time_limit);
  const double metres = apart * neighbours.length();
  const Trajectory other = neighbours.run(metres);
  const Trajectory& motion = neighbours.motion();
  for (std::size_t k = 0; k < std::min(motion.q.size(), other.q.size()); ++k) {
    result.times.push_back(motion.times[k]);
    result.distances.push_back(greatest_distance(motion.q[k], other.q[k]));
  }
  result.exponent = neighbours.exponent();
  result.horizon = together_until(motion, other, tolerance);
  // A motion that could not be followed to its end says nothing of what comes after.
  result.beyond_end = !result.times.empty() && result.horizon == result.times.back() &&
                      motion.outcome == Outcome::completed && other.outcome == Outcome::completed;
  result.in_words = in_words(result, tolerance, metres);
  return result;
}

}  // namespace plumb
