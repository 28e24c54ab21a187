#include "render/scene/motion.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/errors.h"
#include "engine/integrate/state_at.h"
#include "engine/model/hermite.h"

namespace plumb {

namespace {

// In a picture of the whole motion the cable would be a millionth of it.
constexpr double farthest = 1e6;  // cable lengths
constexpr int pieces = 48;        // of a cable, which tell where it is

}  // namespace

Motion::Motion(const Trajectory& trajectory, const Vec3& offset) : trajectory_(trajectory), offset_(offset) {
  const std::size_t count = trajectory.times.size();
  if (count == 0) throw OutputError("the run has no outputs: nothing to draw");
  if (trajectory.elements < 1 || !(trajectory.element_length > 0) || trajectory.q.size() != count ||
      trajectory.v.size() != count)
    throw OutputError(fmt::format(
        "the run cannot be drawn: {} elements of {} m, {} times, {} states, {} rates", trajectory.elements,
        trajectory.element_length, count, trajectory.q.size(), trajectory.v.size()));
  const Eigen::Index size = 6 * (trajectory.elements + 1);
  const double limit = farthest * trajectory.element_length * trajectory.elements;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::VectorXd& q = trajectory.q[i];
    const Eigen::VectorXd& v = trajectory.v[i];
    if (q.size() != size || v.size() != size)
      throw OutputError(
          fmt::format("the run cannot be drawn: output {} has {} coordinates and {} rates instead of {}", i,
                      q.size(), v.size(), size));
    if (!q.allFinite() || !v.allFinite())
      throw OutputError(
          fmt::format("the run cannot be drawn: the state at {} s is not finite", trajectory.times[i]));
    double distance = 0;
    for (Eigen::Index node = 0; node <= trajectory.elements; ++node)
      distance = std::max(distance, q.segment<3>(6 * node).lpNorm<Eigen::Infinity>());
    if (distance > limit)
      throw OutputError(fmt::format("the run cannot be drawn: at {} s the cable is {:.3g} m away",
                                    trajectory.times[i], distance));
  }
}

State Motion::at(double time) const {
  return state_at(trajectory_, std::clamp(time, trajectory_.times.front(), trajectory_.times.back()));
}

CurvePoint Motion::point(const Eigen::VectorXd& state, double place) const {
  const int e = std::clamp(static_cast<int>(place), 0, trajectory_.elements - 1);
  const double x = place - e;
  const auto node = [&](int k) -> Vec3 { return state.segment<3>(6 * e + 3 * k); };
  const auto s = Hermite::values(x, trajectory_.element_length);
  const auto d = Hermite::slopes(x, trajectory_.element_length);
  Vec3 slope = d[0] * node(0) + d[1] * node(1) + d[2] * node(2) + d[3] * node(3);
  // Where the slope has collapsed, the element's ends tell the direction.
  if (!(slope.norm() > 1e-12)) slope = node(2) - node(0);
  const double length = slope.norm();
  return {s[0] * node(0) + s[1] * node(1) + s[2] * node(2) + s[3] * node(3) + offset_,
          length > 0 ? Vec3(slope / length) : Vec3(Vec3::UnitX()), place};
}

Vec3 Motion::middle(const Eigen::VectorXd& state) const {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k <= pieces; ++k) sum += point(state, 1.0 * elements() * k / pieces).position;
  return sum / (pieces + 1);
}

std::vector<Vec3> covered_places(const Motion& motion) {
  // Outputs beyond some hundreds hardly add to the space that the motion fills.
  constexpr std::size_t enough = 500;
  const std::size_t stride = std::max<std::size_t>(1, motion.output_count() / enough);
  std::vector<Vec3> places;
  const auto add = [&](const Eigen::VectorXd& state) {
    for (int k = 0; k <= pieces; ++k)
      places.push_back(motion.point(state, static_cast<double>(motion.elements()) * k / pieces).position);
  };
  for (std::size_t i = 0; i < motion.output_count(); i += stride) add(motion.output(i));
  add(motion.output(motion.output_count() - 1));
  return places;
}

}  // namespace plumb
