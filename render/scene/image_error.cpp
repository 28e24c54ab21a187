#include "render/scene/image_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/errors.h"

namespace plumb {

namespace {

constexpr int fewest_points = 64;        // along the cable
constexpr int points_of_an_element = 4;  // between two nodes

// The distance of one pair, as far as the picture shows it.
class PairOnPicture {
 public:
  PairOnPicture(const Camera& camera, const SceneCamera& scene) : camera_(camera), scene_(scene) {}

  double distance(const Vec3& drawn, const Vec3& truth) {
    const Point a = camera_.pixel(drawn), b = camera_.pixel(truth);
    if (!is_seen(a, drawn) && !is_seen(b, truth)) return 0;
    sees_any_ = true;
    const double distance = (a - b).norm();
    return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
  }

  bool sees_any() const { return sees_any_; }

 private:
  bool is_seen(const Point& p, const Vec3& place) const {
    if (!p.allFinite()) return false;
    const double around = scene_.radius() * camera_.pixels_per_metre(place);
    return p.x() > -around && p.x() < scene_.width() + around && p.y() > -around &&
           p.y() < scene_.height() + around;
  }

  const Camera& camera_;
  const SceneCamera& scene_;
  bool sees_any_ = false;
};

}  // namespace

ImageErrorGauge::ImageErrorGauge(const Trajectory& truth, const SceneInput& input) : camera_(truth, input) {
  const Motion& motion = camera_.motion();
  std::vector<double> times = camera_.frame_times();
  if (motion.end() - times.back() > 1e-9 * motion.end()) times.push_back(motion.end());
  samples_.push_back({times.front(), 0});
  for (std::size_t k = 1; k < times.size(); ++k)
    for (int part = 1; part <= parts_of_a_frame; ++part)
      samples_.push_back({times[k - 1] + (times[k] - times[k - 1]) * part / parts_of_a_frame, k});
}

std::vector<double> ImageErrorGauge::distances(const Trajectory& drawn) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> result(samples_.back().frame + 1, 0);
  const Motion& truth = camera_.motion();
  bool seen = false;
  try {
    const Motion motion(drawn);
    const int points =
        std::max(fewest_points, points_of_an_element * std::max(motion.elements(), truth.elements()));
    for (const auto& [time, frame] : samples_) {
      const Camera camera = camera_.at(time);
      PairOnPicture pair(camera, camera_);
      const Eigen::VectorXd a = motion.state(time), b = truth.state(time);
      double greatest = time > motion.end() + 1e-9 ? infinity : 0;
      for (int i = 0; i <= points; ++i) {
        const double at = static_cast<double>(i) / points;
        greatest = std::max(greatest, pair.distance(motion.point(a, at * motion.elements()).position,
                                                    truth.point(b, at * truth.elements()).position));
      }
      result[frame] = std::max(result[frame], greatest);
      seen = seen || pair.sees_any();
    }
  } catch (const OutputError&) {
    // What cannot be drawn is infinitely far off.
    return std::vector<double>(result.size(), infinity);
  }
  if (!seen) return {};
  return result;
}

}  // namespace plumb
