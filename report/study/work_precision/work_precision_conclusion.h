#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// A step is fine enough for a mesh where time integration adds no more than this share of what the mesh
/// errs: a finer one gains nothing that could be seen.
inline constexpr double share_of_mesh_error = 0.1;

/// What a mesh is good for.
struct MeshAdvice {
  int elements = 0;
  double error = -1;  ///< of the mesh alone, greatest distance of the tip over time, m; -1: not known
  /// The cheapest run on it, index into WorkPrecision::runs, whose time integration errs by no more than
  /// share_of_mesh_error of that.
  std::optional<std::size_t> run;
};

/// A curve on the mesh of the case whose coarse runs fail.
struct FailingCurve {
  std::size_t curve = 0;    ///< index into WorkPrecision::curves
  std::size_t run = 0;      ///< the finest of those runs, index into WorkPrecision::runs
  bool everywhere = false;  ///< no run of the curve does better
};

/// What a reader who has ten seconds needs of a study.
struct WorkPrecisionConclusion {
  /// On the mesh of the case, which method, with which setting, at what cost, and where the mesh takes over.
  std::string sentence;
  std::string details;  ///< how to come nearer to the continuum, and which methods fail where; may be empty
  /// Cheapest runs against the continuum, or, where that is not known, of time integration on the mesh of
  /// the case: each run once, with the smallest error that it stays below, at most five.
  std::vector<CheapestRun> ways;
  bool of_time_alone = false;         ///< `ways` is of time integration
  std::vector<MeshAdvice> meshes;     ///< from the coarsest
  std::vector<FailingCurve> failing;  ///< those that fail at the smallest step first
};

WorkPrecisionConclusion conclude(const WorkPrecision& study);

/// "unstable", "out-of-time", "stable but wrong": how a failing run ended.
std::string how_it_fails(const WorkPrecisionRun& run);

/// The `conclusion` of results.json. Keys as in output/README.md.
nlohmann::ordered_json conclusion_json(const WorkPrecision& study);

}  // namespace plumb
