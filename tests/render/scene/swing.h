#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "render/scene/scene.h"

namespace plumb {

/// A made-up motion for tests of drawing: a slightly curved cable of 1 m, held at the origin, that circles
/// the Y axis and swings below it. Four elements, 101 outputs over 2 s.
inline Trajectory swing(int outputs = 101) {
  Trajectory trajectory;
  trajectory.outcome = Outcome::completed;
  trajectory.elements = 4;
  trajectory.element_length = 0.25;
  const auto state = [](double t) {
    // Integrated along the cable in small pieces: position from direction.
    Eigen::VectorXd q(30);
    Vec3 place = Vec3::Zero();
    const int pieces = 50;
    for (int node = 0; node <= 4; ++node) {
      for (int i = 0; i <= pieces; ++i) {
        const double s = 0.25 * (node + static_cast<double>(i) / pieces);
        const double dip = 0.45 - 0.45 * std::cos(7 * t) + 0.35 * (s - 0.4) * std::sin(9 * t + 2 * s);
        const double azimuth = 3.3 * t - 0.5 * s * std::sin(5 * t);
        const Vec3 direction(std::cos(dip) * std::cos(azimuth), -std::sin(dip),
                             -std::cos(dip) * std::sin(azimuth));
        if (i == 0) q.segment<6>(6 * node) << place, direction;
        if (i < pieces) place += 0.25 / pieces * direction;
      }
    }
    return q;
  };
  for (int k = 0; k < outputs; ++k) {
    const double t = 0.02 * k;
    trajectory.times.push_back(t);
    trajectory.q.push_back(state(t));
    trajectory.v.push_back((state(t + 1e-5) - state(t - 1e-5)) / 2e-5);
    trajectory.energies.emplace_back();
  }
  trajectory.end_time = trajectory.times.back();
  return trajectory;
}

inline SceneInput swing_input() {
  SceneInput input;
  input.length = 1;
  input.radius = 0.0028;
  input.supports.first = Support::pinned;
  input.gravity = {0, -9.81, 0};
  input.title = "Spatial cable pendulum";
  return input;
}

}  // namespace plumb
