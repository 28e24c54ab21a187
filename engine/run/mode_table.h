#pragma once

#include <string>
#include <string_view>

#include "engine/case/case.h"
#include "engine/case/probe_table.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// What is known of the modes of a run, a row each: their numbers from 1 in the place of times, the
/// mode_columns, and what the probes see of their shapes, scaled so that the greatest displacement of a node
/// is 1 m: of a complex mode at the moment when this is. Velocities are the greatest of a vibration; strains,
/// forces, curvatures and moments are changes for such a displacement were it small. Empty of a run without
/// modes.
ProbeTable mode_table(const Case& spec, const Trajectory& trajectory);

/// The mode's displacements from the equilibrium for a greatest one of `reach` (m), at a phase in turns.
Eigen::VectorXd displaced(const VibrationMode& mode, double reach, double phase);

/// The file of a run's modes, and the key of results.json that has them.
inline constexpr std::string_view modes_file = "modes.csv";
inline constexpr std::string_view modes_key = modes_file.substr(0, modes_file.find('.'));

/// "mode,kind,frequency [Hz],…": a line a mode, with 17 significant digits.
std::string modes_csv(const Trajectory& trajectory, const ProbeTable& modes);

}  // namespace plumb
