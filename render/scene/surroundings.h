#pragma once

#include <vector>

#include "engine/case/scene_settings.h"

namespace plumb {

/// What surrounds the cable and stays while it moves. Places on the ground are given by two numbers, along
/// `across` and `forward` from `origin`.
struct Surroundings {
  Vec3 up;      ///< unit vector against gravity
  Vec3 across;  ///< unit vectors in the ground, at right angles to each other
  Vec3 forward;
  Vec3 origin;               ///< the point of the ground below the first end at the start, m
  Eigen::Vector2d middle;    ///< of what the motion covers, m from the origin
  double reach = 0;          ///< how far from the middle the motion's projection reaches, m
  double ground_radius = 0;  ///< where the ground has faded out, m from the middle
  double grid = 0;           ///< distance of grid lines, m
  std::vector<Vec3> places;  ///< that the motion covers, and those below them on the ground, m
  Vec3 best_side;            ///< unit vector, from the motion to where it is seen best from
  Vec3 center;               ///< of a ball that encloses the motion and the ground, m
  double radius = 0;         ///< of that ball, m

  Vec3 on_ground(const Vec3& place) const { return place - up * up.dot(place - origin); }
  Eigen::Vector2d ground_coordinates(const Vec3& place) const {
    return {across.dot(place - origin), forward.dot(place - origin)};
  }
  double height(const Vec3& place) const { return up.dot(place - origin); }
};

/// The surroundings for a motion that covers `places` (one or more, the first being the first end at the
/// start) of a cable of a length, drawn with a radius (m): the ground is below the lowest place at right
/// angles to gravity (to Y without gravity). `face_on`: the best side is that from which what is side by side
/// looks equally large.
Surroundings make_surroundings(std::vector<Vec3> places, double length, double radius, const Vec3& gravity,
                               bool face_on = false);

}  // namespace plumb
