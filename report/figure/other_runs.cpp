#include "report/figure/other_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "engine/base/errors.h"
#include "render/scene/motion.h"
#include "render/scene/view_axes.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr double same_time = 1e-9;  // of the longer run

/// The folder of a run, or the name of a run file that is not called as they are.
std::string short_name(const std::string& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  const fs::path last = whole.has_filename() ? whole : whole.parent_path();
  if (last.extension() != ".h5") return last.filename().string();
  return last.filename() == "run.h5" ? last.parent_path().filename().string() : last.stem().string();
}

void check_drawable(const std::string& path, const Trajectory& trajectory) {
  try {
    const Motion motion(trajectory);
  } catch (const OutputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace

std::vector<std::string> labels_of_runs(const std::vector<std::string>& paths) {
  std::map<std::string, int> names;
  for (const std::string& path : paths) ++names[short_name(path)];
  std::vector<std::string> labels;
  for (const std::string& path : paths)
    labels.push_back(names[short_name(path)] == 1 ? short_name(path) : path);
  return labels;
}

void add_other_runs(SceneInput& scene, const std::string& path, const Trajectory& motion,
                    const std::vector<OtherRun>& others) {
  if (others.empty()) return;
  check_drawable(path, motion);
  const double end = motion.times.back();
  std::vector<std::string> paths{path};
  for (const OtherRun& other : others) {
    check_drawable(other.path, other.run.trajectory);
    const double other_end = other.run.trajectory.times.back();
    if (std::abs(other_end - end) > same_time * std::max(end, other_end))
      throw InputError(
          fmt::format("{}: ends at {:.10g} s, but {} at {:.10g} s: runs of one scene must end together",
                      other.path, other_end, path, end));
    paths.push_back(other.path);
  }
  const std::vector<std::string> labels = labels_of_runs(paths);
  scene.label = labels.front();
  const ViewAxes axes = view_axes(motion, scene);
  double side = reach_along(motion, axes.right);
  for (std::size_t k = 0; k < others.size(); ++k) {
    const OtherRun& other = others[k];
    SceneRun shown = scene_run(other.run.loaded.spec, other.run.trajectory, labels[k + 1]);
    if (other.beside) side = put_beside(shown, axes.right, side);
    scene.others.push_back(std::move(shown));
  }
}

}  // namespace plumb
