#include "render/scene/view_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "render/scene/camera_path.h"

namespace plumb {

namespace {

constexpr double gap = 0.25;  // between runs side by side, in cable lengths

}  // namespace

ViewAxes view_axes(const Trajectory& trajectory, const SceneInput& input) {
  const Motion motion(trajectory);
  const Surroundings surroundings =
      make_surroundings(covered_places(motion), input.length, input.radius, input.gravity);
  const double aspect = 1.0 * input.spec.size[0] / input.spec.size[1];
  const CameraSpec place = CameraPath(input.spec, surroundings, motion, input.radius, aspect, {}).at(0);
  ViewAxes axes;
  axes.back = (place.eye - place.target).normalized();
  axes.parallel = place.view_height > 0;
  const Vec3 right = place.up.cross(axes.back);
  const Vec3 level = right - surroundings.up * surroundings.up.dot(right);
  axes.right = level.norm() > 1e-3 * right.norm() ? level.normalized() : right.normalized();
  return axes;
}

double reach_along(const Trajectory& trajectory, const Vec3& direction) {
  double reach = -std::numeric_limits<double>::infinity();
  for (const Vec3& place : covered_places(Motion(trajectory))) reach = std::max(reach, place.dot(direction));
  return reach;
}

double put_beside(SceneRun& run, const Vec3& right, double end) {
  const double begin = -reach_along(*run.trajectory, -right);
  run.offset = (end + gap * run.length - begin) * right;
  return run.offset.dot(right) + reach_along(*run.trajectory, right);
}

}  // namespace plumb
