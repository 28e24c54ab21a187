#include "engine/model/support_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/model/supports.h"

namespace plumb {
namespace {

using Matrix3 = Eigen::Matrix3d;

struct VectorJet {
  Vec3 value, rate, second;
};

VectorJet jet_of(const std::array<TimeFunction, 3>& displacement, double t) {
  VectorJet result;
  for (int k = 0; k < 3; ++k) {
    const Jet jet = displacement[static_cast<std::size_t>(k)].jet(t);
    result.value[k] = jet.value;
    result.rate[k] = jet.rate;
    result.second[k] = jet.second;
  }
  return result;
}

std::array<TimeFunction, 3> functions_of(const std::optional<MotionSpec>& spec,
                                         const std::map<std::string, double>& parameters) {
  const MotionSpec motion = spec.value_or(MotionSpec{});
  return {TimeFunction(motion.x, parameters), TimeFunction(motion.y, parameters),
          TimeFunction(motion.z, parameters)};
}

/// For each three numbers of `result`: with those of q and v, and whether they are a slope.
template <class Of>
Eigen::VectorXd each_vector(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const Of& of) {
  Eigen::VectorXd result(q.size());
  for (Eigen::Index at = 0; at < q.size(); at += 3)
    result.segment<3>(at) = of(Vec3(q.segment<3>(at)), Vec3(v.segment<3>(at)), at % 6 == 3);
  return result;
}

}  // namespace

void turn_vectors(const Matrix3& turn, Eigen::VectorXd& x) {
  for (Eigen::Index at = 0; at < x.size(); at += 3) x.segment<3>(at) = (turn * x.segment<3>(at)).eval();
}

MovedSupports MovedSupports::at_rest() const {
  MovedSupports result;
  result.origin = origin;
  result.turn = turn;
  result.last = last;
  return result;
}

void MovedSupports::to_ground(Eigen::VectorXd& q, Eigen::VectorXd& v) const {
  add_last(q);
  add_last_rate(v);
  v = ground_rates(q, v);
  turn_vectors(turn, q);
  turn_vectors(turn, v);
  for (Eigen::Index at = 0; at < q.size(); at += 6) q.segment<3>(at) += origin;
}

void MovedSupports::to_relative(Eigen::VectorXd& q, Eigen::VectorXd& v) const {
  for (Eigen::Index at = 0; at < q.size(); at += 6) q.segment<3>(at) -= origin;
  turn_vectors(turn.transpose(), q);
  turn_vectors(turn.transpose(), v);
  v -= carried_rates(q);
  q.segment<3>(q.size() - 6) -= last;
  v.segment<3>(v.size() - 6) -= last_rate;
}

Eigen::VectorXd MovedSupports::ground_rates(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
  return carried_rates(q) + v;
}

Eigen::VectorXd MovedSupports::carried_rates(const Eigen::VectorXd& q) const {
  return each_vector(q, q, [&](const Vec3& x, const Vec3&, bool slope) -> Vec3 {
    return spin.cross(x) + (slope ? Vec3::Zero() : velocity);
  });
}

Eigen::VectorXd MovedSupports::carried_accelerations(const Eigen::VectorXd& q,
                                                     const Eigen::VectorXd& v) const {
  return each_vector(q, v, [&](const Vec3& x, const Vec3& rate, bool slope) -> Vec3 {
    return spin_rate.cross(x) + spin.cross(rate + spin.cross(x)) + (slope ? Vec3::Zero() : acceleration);
  });
}

Eigen::VectorXd MovedSupports::accelerations(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
  Eigen::VectorXd result = each_vector(q, v, [&](const Vec3& x, const Vec3& rate, bool slope) -> Vec3 {
    return spin_rate.cross(x) + spin.cross(2 * rate + spin.cross(x)) + (slope ? Vec3::Zero() : acceleration);
  });
  result.segment<3>(result.size() - 6) += last_acceleration;
  return result;
}

SupportMotion::SupportMotion(const Case& spec)
    : moves_(spec.supports.first_motion || spec.supports.last_motion || spec.supports.first_rotation),
      turns_(spec.supports.first_rotation.has_value()),
      last_held_(hold_of(spec.supports.last).position),
      first_(functions_of(spec.supports.first_motion, spec.parameters)),
      last_(functions_of(spec.supports.last_motion, spec.parameters)),
      angle_(spec.supports.first_rotation.value_or(RotationSpec{}).angle, spec.parameters),
      axis_(spec.supports.first_rotation.value_or(RotationSpec{}).axis),
      span_(spec.start.stretch * spec.cable.length * spec.start.direction),
      length_(spec.cable.length) {}

SupportMotion SupportMotion::in_units(const OwnUnits& units) const {
  SupportMotion result = *this;
  result.metre_ *= units.length;
  result.second_ *= units.time;
  result.span_ /= units.length;
  result.length_ /= units.length;
  return result;
}

MovedSupports SupportMotion::at(double t) const {
  MovedSupports moved;
  if (!moves_) return moved;
  const auto scaled = [&](VectorJet jet) {
    jet.value /= metre_;
    jet.rate *= second_ / metre_;
    jet.second *= second_ * second_ / metre_;
    return jet;
  };
  const double seconds = t * second_;
  const VectorJet first = scaled(jet_of(first_, seconds));
  if (turns_) {
    const Jet angle = angle_.jet(seconds);
    moved.turn = Eigen::AngleAxisd(angle.value, axis_).toRotationMatrix();
    // The axis is the same in the frame.
    moved.spin = angle.rate * second_ * axis_;
    moved.spin_rate = angle.second * second_ * second_ * axis_;
  }
  const Matrix3 back = moved.turn.transpose();
  moved.origin = first.value;
  moved.velocity = back * first.rate;
  moved.acceleration = back * first.second;
  if (!last_held_) return moved;
  const VectorJet last = scaled(jet_of(last_, seconds));
  const Vec3 &w = moved.spin, &dw = moved.spin_rate;
  const Vec3 place = back * (span_ + last.value - first.value);
  const Vec3 rate = back * (last.rate - first.rate), second = back * (last.second - first.second);
  moved.last = place - span_;
  moved.last_rate = rate - w.cross(place);
  moved.last_acceleration = second - 2 * w.cross(rate) - dw.cross(place) + w.cross(w.cross(place));
  return moved;
}

double SupportMotion::greatest_speed(double duration) const {
  constexpr int times = 256;
  double greatest = 0;
  for (int k = 0; k <= (moves_ ? times : 0); ++k) {
    const MovedSupports moved = at(k * (duration / times));
    greatest =
        std::max(greatest, moved.velocity.norm() + moved.spin.norm() * length_ + moved.last_rate.norm());
  }
  return greatest;
}

}  // namespace plumb
