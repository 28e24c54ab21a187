#include "engine/study/stability/energy_histories.h"

#include <fmt/format.h>

#include "engine/integrate/integrate.h"
#include "engine/study/stability/stability_members.h"

namespace plumb {
namespace {

EnergyHistory history_of(const MethodSetting& variant, const Case& of, double parameter, double step,
                         double time_limit) {
  Case spec = of;
  spec.method = variant.with(step);
  const Trajectory run = integrate(spec, {}, time_limit);
  EnergyHistory history;
  history.label = variant.label;
  history.parameter = parameter;
  history.step = step;
  history.outcome = run.outcome;
  history.message = run.message;
  const double scale = run.kinetic_scale();
  for (std::size_t k = 0; k < run.times.size() && scale > 0; ++k) {
    history.times.push_back(run.times[k]);
    history.change.push_back((run.energies[k].total() - run.energies.front().total()) / scale);
  }
  return history;
}

}  // namespace

Runner::Planned<EnergyHistory> plan_energy_histories(const std::vector<MethodSetting>& variants,
                                                     const std::vector<Case>& cases,
                                                     const std::vector<double>& parameters, double step,
                                                     double time_limit, Runner& runner) {
  std::vector<const MethodSetting*> chosen;
  for (const MethodSetting& variant : variants)
    if (variant.by_step && variant.info->family == MethodFamily::structural) chosen.push_back(&variant);
  std::vector<StudyPoint<EnergyHistory>> points;
  for (std::size_t c = 0; c < cases.size(); ++c)
    for (const MethodSetting* variant : chosen)
      points.push_back({fmt::format("{}, parameter {}", variant->label, parameters[c]),
                        [variant = *variant, spec = cases[c], parameter = parameters[c], step, time_limit] {
                          return history_of(variant, spec, parameter, step, time_limit);
                        }});
  return runner.plan("energies", std::move(points));
}

}  // namespace plumb
