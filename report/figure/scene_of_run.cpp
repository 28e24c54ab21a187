#include "report/figure/scene_of_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/errors.h"
#include "engine/run/centerline_from_probes.h"
#include "engine/run/mode_table.h"

namespace plumb {
namespace {

/// The scene of a case whose run has no states: nothing to colour it by.
SceneInput scene_without_fields(Case spec) {
  spec.scene.color_by = ColorField::none;
  // Of an external run there is no mesh that fields could be computed on.
  spec.cable.elements = 1;
  return scene_input(spec);
}

}  // namespace

std::string fault_of_scene(const LoadedCase& loaded) {
  if (loaded.uses("scene")) return "";
  try {
    load_case(loaded.source, [](std::string_view section) { return section == "scene"; });
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

SceneOfRun::SceneOfRun(const Run& run, std::optional<int> mode) {
  const Case& spec = run.loaded.spec;
  if (const std::string fault = fault_of_scene(run.loaded); !fault.empty()) {
    notes_.push_back("[scene] cannot be used: " + fault);
    return;
  }
  if (has_modes(run)) {
    vibrate(run, mode);
    return;
  }
  if (mode) throw UsageError("--mode: the run has no modes, which are found with another method");
  const bool reports_given = reports_given_run(spec);
  input_ = reports_given ? scene_without_fields(spec) : scene_input(spec);
  motion_ = reports_given ? drawn(run, 0) : &run.trajectory;
  if (reports_given && spec.scene.color_by != ColorField::none)
    notes_.push_back("It is not coloured, as " + spec.given_runs.front().name + " tells no fields");
  if (motion_ == nullptr) return;
  const bool colored = input_.spec.color_by != ColorField::none;
  for (std::size_t k = reports_given ? 1 : 0; k < spec.given_runs.size(); ++k) {
    if (colored) {
      notes_.push_back(spec.given_runs[k].name + " is not shown where the cable is coloured by a field");
      continue;
    }
    const Trajectory* other = drawn(run, k);
    if (other == nullptr) continue;
    SceneRun beside;
    beside.trajectory = other;
    beside.length = input_.length;
    beside.radius = input_.radius;
    beside.supports = spec.supports;
    beside.label = spec.given_runs[k].name;
    input_.others.push_back(std::move(beside));
  }
  if (!input_.others.empty()) input_.label = reported_name(spec);
}

void SceneOfRun::vibrate(const Run& run, std::optional<int> mode) {
  constexpr double period = 2, reach = 0.1;  // s of the pictures, share of the length
  constexpr int outputs = 48;
  const std::vector<VibrationMode>& modes = run.trajectory.vibrations.modes;
  if (mode && (*mode < 1 || *mode > std::ssize(modes)))
    throw UsageError(fmt::format("--mode {}: the run has {}", *mode,
                                 modes.empty() ? "no modes" : fmt::format("modes 1 to {}", modes.size())));
  Case spec = run.loaded.spec;
  // What a displacement of that size would do to the cable is not what the mode does.
  spec.scene.color_by = ColorField::none;
  input_ = scene_input(spec);
  if (modes.empty()) {
    notes_.push_back("There is no mode to be shown");
    return;
  }
  const auto deforms = [](const VibrationMode& any) { return any.kind != ModeKind::rigid_body; };
  const auto first = std::find_if(modes.begin(), modes.end(), deforms);
  const std::size_t shown = mode                   ? static_cast<std::size_t>(*mode - 1)
                            : first == modes.end() ? 0
                                                   : static_cast<std::size_t>(first - modes.begin());
  const VibrationMode& vibration = modes[shown];
  Trajectory& motion = curves_.emplace_back();
  motion.outcome = Outcome::completed;
  motion.elements = run.trajectory.elements;
  motion.element_length = run.trajectory.element_length;
  motion.end_time = period;
  const double size = reach * spec.cable.length;
  for (int k = 0; k <= outputs; ++k) {
    const double phase = static_cast<double>(k) / outputs;
    motion.times.push_back(period * phase);
    motion.q.push_back(run.trajectory.q.front() + displaced(vibration, size, phase));
    motion.v.push_back(2 * std::numbers::pi / period * displaced(vibration, size, phase + 0.25));
  }
  motion_ = &motion;
  const std::string what = vibration.frequency > 0 ? fmt::format("{:.4g} Hz", vibration.frequency)
                                                   : std::string(word(vibration.kind));
  input_.in_place_of_time = fmt::format("mode {}: {}", shown + 1, what);
  notes_.push_back(
      fmt::format("Mode {} of {}, {}: one period in {:g} s of the pictures, with its greatest displacement "
                  "drawn as a tenth of "
                  "the length and no damping; plumb render --mode N draws another",
                  shown + 1, modes.size(), what, period));
}

const Trajectory* SceneOfRun::drawn(const Run& run, std::size_t given_run) {
  const Case& spec = run.loaded.spec;
  DrawnCurve curve = curve_through_probes(spec, run.loaded.given_runs[given_run],
                                          spec.given_runs[given_run].name, spec.scene.frame_rate);
  notes_.push_back(std::move(curve.in_words));
  if (!curve.motion) return nullptr;
  return &curves_.emplace_back(std::move(*curve.motion));
}

}  // namespace plumb
