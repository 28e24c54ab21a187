#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// A candidate is taken where its estimated picture error times this is at most the scene's tolerance. It has
/// to make up for what an estimate by Richardson extrapolation may miss (Roache 1994 takes 1.25 for three
/// meshes and 3 for two).
inline constexpr double economy_safety = 2;

/// What a run without care for its cost would take: this mesh and method.
inline constexpr int safe_elements = 64;
inline constexpr double safe_tolerance = 1e-8;

/// A model with its mesh and method: one way to compute a scene.
struct Candidate {
  CableSpec cable;
  MethodSpec method;
  double work = 0;  ///< predicted, ns of one core; the same on every machine, so that the choice is
};

/// A candidate that was run.
struct TriedCandidate {
  Candidate candidate;
  Outcome outcome = Outcome::not_run;
  std::string message;       ///< of an outcome other than completed
  double seconds = -1;       ///< that the time loop took
  double estimate = -1;      ///< of its picture error, pixels; -1: none; may be infinite
  double true_error = -1;    ///< against a certified reference, pixels; -1: not known
  double certain_until = 0;  ///< s, up to which its estimate holds
  std::string why;           ///< why it was left, or taken
};

/// What a search for the cheapest candidate that a scene needs has found.
struct Economy {
  double tolerance = 0;   ///< pixels
  int case_elements = 0;  ///< of the mesh that the case names; 0: it names another model than a cable
  std::vector<TriedCandidate> tried;  ///< in the order of their predicted cost
  int chosen = -1;                    ///< place in `tried`
  bool holds = false;          ///< the chosen one's error is within the tolerance, as far as can be told
  std::string finest;          ///< the candidate that the estimates are from
  double finest_error = -1;    ///< its own estimated error, pixels
  double observed_ratio = -1;  ///< of the errors of its two coarser meshes, as far as they tell it
  double time_share = -1;  ///< of the chosen one's error, what its step is guilty of, pixels; -1: not known
  std::string uncertain;   ///< what is uncertain where nothing holds; empty: nothing
  double search_seconds = 0;  ///< that the search took
  double search_work = 0;     ///< predicted work of all that was run, ns
  double safe_work = 0;       ///< predicted of one run at the safe default, ns
  bool reused = false;        ///< taken from an earlier search

  const TriedCandidate* choice() const {
    return chosen < 0 ? nullptr : &tried[static_cast<std::size_t>(chosen)];
  }
};

/// Greatest distance on the picture between the centre lines of two runs, pixels, one for each frame that is
/// drawn and one for the end of a run that goes on after the last frame; each since the frame before.
/// Infinite where one is not in the picture and the other cannot be told. None at all where neither is
/// ever in the picture, which proves nothing.
using PictureErrors = std::function<std::vector<double>(const Trajectory& drawn)>;
/// Makes what holds runs against `truth`, which must outlive it, through the camera of `truth`.
using MakeGauge = std::function<PictureErrors(const Trajectory& truth)>;

}  // namespace plumb
