#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "engine/run/run.h"
#include "render/scene/scene.h"

namespace plumb {

/// Why the [scene] of a case that was read without a use for it cannot be used; empty: it can.
std::string fault_of_scene(const LoadedCase& loaded);

/// What an animation of a run shows: its motion, or what can be drawn of a given one, and the other given
/// runs over it.
class SceneOfRun {
 public:
  /// `run` must outlive it. Of a run of modes it shows one, by its number from 1; without, the first that is
  /// no rigid-body motion. Throws UsageError where there is none of that number.
  explicit SceneOfRun(const Run& run, std::optional<int> mode = {});
  SceneOfRun(const SceneOfRun&) = delete;
  SceneOfRun& operator=(const SceneOfRun&) = delete;

  /// The motion of the run that is reported; nullptr where there is not enough to draw, or its [scene] cannot
  /// be used.
  const Trajectory* motion() const { return motion_; }
  /// For SceneRenderer, beside the motion; it must not outlive this.
  const SceneInput& input() const { return input_; }
  SceneInput& input() { return input_; }
  /// What external runs are drawn through, or why they are not drawn, or nothing is; a sentence each.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  /// Takes a mode, slowed or quickened to a period that can be watched, for the motion.
  void vibrate(const Run& run, std::optional<int> mode);
  /// The motion of an external run, if there is enough to draw.
  const Trajectory* drawn(const Run& run, std::size_t given_run);

  std::deque<Trajectory> curves_;
  const Trajectory* motion_ = nullptr;
  SceneInput input_;
  std::vector<std::string> notes_;
};

}  // namespace plumb
