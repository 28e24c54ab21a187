#pragma once

#include <vector>

#include "engine/study/reference/method_settings.h"
#include "engine/study/runner.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// Plans the energy over time of the schemes among `variants` that structural dynamics uses (family
/// `structural`), all with one step (s), on each of the cases. `parameters`
/// are those of the cases.
Runner::Planned<EnergyHistory> plan_energy_histories(const std::vector<MethodSetting>& variants,
                                                     const std::vector<Case>& cases,
                                                     const std::vector<double>& parameters, double step,
                                                     double time_limit, Runner& runner);

}  // namespace plumb
