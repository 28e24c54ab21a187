#include "report/figure/scene_of_run.h"

#include <utility>

#include "engine/base/errors.h"
#include "engine/run/centerline_from_probes.h"

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

SceneOfRun::SceneOfRun(const Run& run) {
  const Case& spec = run.loaded.spec;
  if (const std::string fault = fault_of_scene(run.loaded); !fault.empty()) {
    notes_.push_back("[scene] cannot be used: " + fault);
    return;
  }
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

const Trajectory* SceneOfRun::drawn(const Run& run, std::size_t given_run) {
  const Case& spec = run.loaded.spec;
  DrawnCurve curve = curve_through_probes(spec, run.loaded.given_runs[given_run],
                                          spec.given_runs[given_run].name, spec.scene.frame_rate);
  notes_.push_back(std::move(curve.in_words));
  if (!curve.motion) return nullptr;
  return &curves_.emplace_back(std::move(*curve.motion));
}

}  // namespace plumb
