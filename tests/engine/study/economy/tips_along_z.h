#pragma once

#include <algorithm>
#include <vector>

#include "engine/integrate/state_at.h"
#include "engine/study/economy/economy.h"

namespace plumb {

/// Seen along Z by parallel rays, so many pixels to a metre; the tip alone.
inline MakeGauge tips_along_z(double pixels_per_metre, double frame_rate) {
  return [=](const Trajectory& truth) -> PictureErrors {
    return [&truth, pixels_per_metre, frame_rate](const Trajectory& drawn) {
      std::vector<double> errors;
      for (double t = 0; t <= truth.times.back() + 1e-9; t += 1 / frame_rate) {
        const double at = std::min(t, truth.times.back());
        const Eigen::VectorXd a = state_at(drawn, at).q, b = state_at(truth, at).q;
        errors.push_back(pixels_per_metre * (a.tail<6>().head<2>() - b.tail<6>().head<2>()).norm());
      }
      return errors;
    };
  };
}

}  // namespace plumb
