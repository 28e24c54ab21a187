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

  double distance(const Vec3& drawn, const Vec3& truth) const {
    const Point a = camera_.pixel(drawn), b = camera_.pixel(truth);
    if (!is_seen(a, drawn) && !is_seen(b, truth)) return 0;
    const double distance = (a - b).norm();
    return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
  }

 private:
  bool is_seen(const Point& p, const Vec3& place) const {
    if (!p.allFinite()) return false;
    const double around = scene_.radius() * camera_.pixels_per_metre(place);
    return p.x() > -around && p.x() < scene_.width() + around && p.y() > -around &&
           p.y() < scene_.height() + around;
  }

  const Camera& camera_;
  const SceneCamera& scene_;
};

}  // namespace

ImageErrorGauge::ImageErrorGauge(const Trajectory& truth, const SceneInput& input)
    : camera_(truth, input), times_(camera_.frame_times()) {}

std::vector<double> ImageErrorGauge::distances(const Trajectory& drawn) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> result(times_.size(), infinity);
  const Motion& truth = camera_.motion();
  try {
    const Motion motion(drawn);
    const int points =
        std::max(fewest_points, points_of_an_element * std::max(motion.elements(), truth.elements()));
    for (std::size_t k = 0; k < times_.size(); ++k) {
      if (times_[k] > motion.end() + 1e-9) break;
      const Camera camera = camera_.at(times_[k]);
      const PairOnPicture pair(camera, camera_);
      const Eigen::VectorXd a = motion.state(times_[k]), b = truth.state(times_[k]);
      double greatest = 0;
      for (int i = 0; i <= points; ++i) {
        const double at = static_cast<double>(i) / points;
        greatest = std::max(greatest, pair.distance(motion.point(a, at * motion.elements()).position,
                                                    truth.point(b, at * truth.elements()).position));
      }
      result[k] = greatest;
    }
  } catch (const OutputError&) {
    // What cannot be drawn is infinitely far off.
  }
  return result;
}

}  // namespace plumb
