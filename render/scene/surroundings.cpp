#include "render/scene/surroundings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/plot/axis_ticks.h"

namespace plumb {

namespace {

constexpr double clearance = 0.06;  // of the ground below the lowest place, in cable lengths
constexpr double elevation = 24 * std::numbers::pi / 180;
constexpr double turn = 28 * std::numbers::pi / 180;  // away from facing the main direction of the motion

// Direction in the ground along which the motion spreads most, as an angle from `across`; 0 where it spreads
// alike.
double main_direction(const std::vector<Eigen::Vector2d>& spread) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : spread) mean += p / static_cast<double>(spread.size());
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& p : spread) covariance += (p - mean) * (p - mean).transpose();
  const double difference = covariance(0, 0) - covariance(1, 1);
  const double mixed = 2 * covariance(0, 1);
  constexpr double alike = 0.2;
  if (std::hypot(difference, mixed) <= alike * covariance.trace()) return 0;
  return std::atan2(mixed, difference) / 2;
}

}  // namespace

Surroundings make_surroundings(std::vector<Vec3> places, double length, double radius, const Vec3& gravity,
                               bool face_on) {
  Surroundings surroundings;
  surroundings.up = gravity.stableNorm() > 0 ? Vec3(-gravity.stableNormalized()) : Vec3(Vec3::UnitY());
  const Vec3 reference = std::abs(surroundings.up.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
  surroundings.across = (reference - surroundings.up * surroundings.up.dot(reference)).normalized();
  surroundings.forward = surroundings.across.cross(surroundings.up);

  double lowest = surroundings.up.dot(places.front());
  for (const Vec3& place : places) lowest = std::min(lowest, surroundings.up.dot(place));
  const Vec3 first = places.front();
  surroundings.origin =
      first - surroundings.up * (surroundings.up.dot(first) - lowest + radius + clearance * length);

  std::vector<Eigen::Vector2d> spread;
  for (const Vec3& place : places) spread.push_back(surroundings.ground_coordinates(place));
  Eigen::Vector2d low = spread.front();
  Eigen::Vector2d high = low;
  for (const auto& p : spread) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  surroundings.middle = (low + high) / 2;
  for (const auto& p : spread)
    surroundings.reach = std::max(surroundings.reach, (p - surroundings.middle).norm());
  surroundings.ground_radius = 2.2 * std::max(surroundings.reach, 0.4 * length);
  surroundings.grid = round_step(surroundings.ground_radius / 14);

  const std::size_t moving = places.size();
  for (std::size_t i = 0; i < moving; ++i) places.push_back(surroundings.on_ground(places[i]));
  const Vec3 middle = surroundings.origin + surroundings.middle.x() * surroundings.across +
                      surroundings.middle.y() * surroundings.forward;
  surroundings.center = middle;
  surroundings.radius = surroundings.ground_radius;
  for (const Vec3& place : places)
    surroundings.radius = std::max(surroundings.radius, (place - middle).norm() + 4 * radius);

  const double angle = main_direction(spread) + (face_on ? 0 : turn);
  // Of the two sides from which the motion spreads across the view, the one towards `forward`.
  Vec3 side = std::sin(angle) * -surroundings.across + std::cos(angle) * surroundings.forward;
  if (side.dot(surroundings.forward) < 0) side = -side;
  surroundings.best_side = std::cos(elevation) * side + std::sin(elevation) * surroundings.up;
  surroundings.places = std::move(places);
  return surroundings;
}

}  // namespace plumb
