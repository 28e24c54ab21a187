#include "engine/study/stability/energy_histories.h"

#include <mutex>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"

namespace plumb {
namespace {

EnergyHistory history_of(const MethodVariant& variant, const Case& of, double parameter, double step,
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

std::vector<EnergyHistory> energy_histories(const std::vector<MethodVariant>& variants,
                                            const std::vector<Case>& cases,
                                            const std::vector<double>& parameters, double step,
                                            double time_limit, const std::function<void(double)>& done) {
  std::vector<const MethodVariant*> chosen;
  for (const MethodVariant& variant : variants)
    if (variant.by_step && variant.info->family == MethodFamily::structural) chosen.push_back(&variant);
  std::vector<EnergyHistory> histories(chosen.size() * cases.size());
  std::mutex saying;
  std::size_t ready = 0;
  for_each_in_parallel(histories.size(), [&](std::size_t k) {
    const std::size_t c = k / chosen.size();
    histories[k] = history_of(*chosen[k % chosen.size()], cases[c], parameters[c], step, time_limit);
    const std::lock_guard lock(saying);
    if (done) done(static_cast<double>(++ready) / static_cast<double>(histories.size()));
  });
  return histories;
}

}  // namespace plumb
