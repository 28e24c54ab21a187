#include "engine/study/uncertainty/uncertainty_runs.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string_view>

#include "engine/base/errors.h"
#include "engine/base/latin_hypercube.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/straight_frequency.h"
#include "engine/read/changed_case.h"
#include "engine/read/uncertain_keys.h"

namespace plumb {
namespace {

/// The value at which a variable of that distribution about `center` stays below with probability p.
double quantile(const UncertainInput& input, double center, double p) {
  const double spread = input.relative ? input.spread * std::abs(center) : input.spread;
  return center + spread * (input.distribution == Distribution::normal ? normal_quantile(p) : 2 * p - 1);
}

}  // namespace

ThreeMeshes three_meshes(int elements) {
  constexpr int fewest = 4;
  if (elements % 4 == 0 && elements / 4 >= fewest)
    return {{elements, elements / 2, elements / 4}, OfThree::finest};
  return {{4 * elements, 2 * elements, elements}, OfThree::coarsest};
}

Case exact_in_time(const Case& spec) {
  Case exact = spec;
  if (!find_method(spec.method.name)->dynamic) return exact;
  constexpr double share_of_limit = 0.25, limit = 2.828;
  exact.method = plain_method(classical_explicit());
  const double step = share_of_limit * limit / straight_frequency(spec.cable);
  exact.method.step = spec.time.output_interval / std::ceil(spec.time.output_interval / step);
  return exact;
}

PlannedRun finer_in_time(const Case& spec) {
  PlannedRun finer{spec, {}};
  MethodSpec& method = finer.spec.method;
  if (method.step)
    *method.step /= refinement_of(method).ratio;
  else if (method.rtol) {
    *method.rtol /= refinement_of(method).ratio;
    *method.atol /= refinement_of(method).ratio;
  } else
    finer.fault = fmt::format("{} has neither a step nor a tolerance", method.name);
  return finer;
}

Refinement refinement_of(const MethodSpec& method) {
  if (!method.step) return {10, 1};
  if (const auto own = method.parameters.find("order"); own != method.parameters.end())
    return {2, own->second};
  // "4", or the lowest of "1 to 5".
  const double stated = std::strtod(find_method(method.name)->order.c_str(), nullptr);
  return {2, stated >= 1 ? stated : 1};
}

PlannedSamples planned_samples(const LoadedCase& loaded, const std::vector<UncertainInput>& inputs) {
  const Case& spec = loaded.spec;
  const UncertaintySpec& uncertainty = *spec.uncertainty;
  const MethodSpec method = exact_in_time(spec).method;
  PlannedSamples planned;
  std::vector<std::string> keys;
  for (const UncertainInput& input : inputs) keys.push_back(input.key);
  for (const std::vector<double>& point :
       latin_hypercube(static_cast<std::size_t>(uncertainty.samples), keys.size(),
                       static_cast<std::uint64_t>(uncertainty.seed))) {
    std::vector<double> values;
    std::string text;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      values.push_back(quantile(inputs[k], *uncertain_value(spec, keys[k]), point[k]));
      text += fmt::format("{}{} = {:.6g}", k == 0 ? "" : ", ", keys[k], values.back());
    }
    PlannedRun run;
    try {
      run.spec = load_changed(loaded.source, uncertain_overrides(spec, keys, values)).spec;
      run.spec.method = method;
    } catch (const InputError& error) {
      // The values are not what a user typed.
      run.fault = error.what();
      constexpr std::string_view prefix = "--set ";
      if (run.fault.starts_with(prefix)) run.fault.erase(0, prefix.size());
    }
    planned.runs.push_back(std::move(run));
    planned.texts.push_back(std::move(text));
  }
  return planned;
}

}  // namespace plumb
