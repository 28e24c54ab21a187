#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/base/time_function.h"
#include "engine/case/case.h"
#include "engine/model/own_units.h"

namespace plumb {

/// Where the supports have moved to at one time, as a frame that the first end carries along and a
/// displacement of the last end in it. Coordinates relative to the supports are those in the frame, without
/// that displacement: what the supports hold keeps its value there. With ground coordinates r and relative
/// ones w,
///   r = Q + R (w + U),   r' = R w',
/// U being 0 but at the last node. All vectors but Q are in the frame's own directions.
struct MovedSupports {
  Vec3 origin = Vec3::Zero();                                            ///< Q, m
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();                    ///< R
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();             ///< Rᵀ Q', Rᵀ Q''; m/s, m/s²
  Vec3 spin = Vec3::Zero(), spin_rate = Vec3::Zero();                    ///< Ω, Ω'; rad/s, rad/s²
  Vec3 last = Vec3::Zero(), last_rate = last, last_acceleration = last;  ///< U, U', U''

  /// The same places at rest.
  MovedSupports at_rest() const;

  /// Adds U, or U', to the last node: what is left relative is only the frame.
  void add_last(Eigen::VectorXd& q) const { q.segment<3>(q.size() - 6) += last; }
  void add_last_rate(Eigen::VectorXd& v) const { v.segment<3>(v.size() - 6) += last_rate; }

  /// Relative coordinates and rates become those of the ground.
  void to_ground(Eigen::VectorXd& q, Eigen::VectorXd& v) const;
  /// And the other way.
  void to_relative(Eigen::VectorXd& q, Eigen::VectorXd& v) const;

  // Of coordinates and rates in the frame, with U.
  /// Rates of the ground, in the frame's directions.
  Eigen::VectorXd ground_rates(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const;
  /// Those of a body that the frame carries along.
  Eigen::VectorXd carried_rates(const Eigen::VectorXd& q) const;
  /// How those of what is now at q change in a second, for what moves at v.
  Eigen::VectorXd carried_accelerations(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const;
  /// What accelerations of the ground have beside those in the frame without U.
  Eigen::VectorXd accelerations(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const;
};

/// x := R x, or Rᵀ x, of each three numbers.
void turn_vectors(const Eigen::Matrix3d& turn, Eigen::VectorXd& x);

/// How the supports of a case move, with exact rates and accelerations.
class SupportMotion {
 public:
  explicit SupportMotion(const Case& spec);

  SupportMotion in_units(const OwnUnits& units) const;

  /// They stay where they are.
  bool none() const { return !moves_; }
  /// The first end is turned.
  bool turns() const { return turns_; }

  /// At t (s).
  MovedSupports at(double t) const;
  /// Greatest speed that they give to the cable within that duration (s), m/s; seen at some hundreds of
  /// times.
  double greatest_speed(double duration) const;

 private:
  using Displacement = std::array<TimeFunction, 3>;

  bool moves_, turns_, last_held_;
  Displacement first_, last_;  // m, of a time in s
  TimeFunction angle_;         // rad, of a time in s
  Vec3 axis_;
  Vec3 span_;                      // from the first end to the last at the start, m
  double length_;                  // of the cable, m
  double metre_ = 1, second_ = 1;  // in which all is given
};

}  // namespace plumb
