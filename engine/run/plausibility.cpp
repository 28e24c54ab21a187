#include "engine/run/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/integrate/integrate.h"
#include "engine/integrate/linear_stability.h"
#include "engine/integrate/method_info.h"
#include "engine/model/cable.h"
#include "engine/model/greatest_eigenfrequency.h"

namespace plumb {
namespace {

constexpr double lightest = 1, heaviest = 25'000;  // kg/m³: aerogels; osmium has 22,590
constexpr double strongest = 1e10;                 // Pa: of fibres that are made in lengths, up to some 7e9
constexpr double thickest = 0.1;                   // of the length

/// As a step of that length with the method, where the steps of a run are chosen.
MethodSpec with_step(MethodSpec method, double step) {
  method.step = step;
  method.rtol.reset();
  method.atol.reset();
  return method;
}

std::string step_too_long(const Case& spec) {
  const MethodInfo* info = find_method(spec.method.name);
  if (info == nullptr || !info->dynamic || info->implicit || !spec.method.step) return "";
  const std::optional<double> limit = stability_limit(spec.method);
  const double frequency = fastest_frequency_at_start(spec);
  if (!limit || !std::isfinite(*limit) || !(frequency > 0) || *spec.method.step * frequency <= *limit)
    return "";
  return fmt::format(
      "method.step = {:.4g} s is longer than {:.4g} s, up to which {} bears the fastest vibration at the "
      "start, {:.4g} "
      "rad/s",
      *spec.method.step, *limit / frequency, spec.method.name, frequency);
}

std::string stress_in_words(double stress, const std::string& where) {
  return fmt::format("a stress of {:.3g} Pa {}: no material bears more than some {:.0g} Pa", stress, where,
                     strongest);
}

}  // namespace

std::vector<std::string> implausible_inputs(const Case& spec) {
  std::vector<std::string> found;
  const CableSpec& cable = spec.cable;
  if (cable.density < lightest || cable.density > heaviest)
    found.push_back(fmt::format("cable.density = {:.4g} kg/m³: materials have {:g} to {:g} kg/m³",
                                cable.density, lightest, heaviest));
  const double thickness = 2 * std::sqrt(cable.area / std::numbers::pi);
  if (thickness > thickest * cable.length)
    found.push_back(fmt::format(
        "the cable is {:.3g} m thick and {:.3g} m long: above a tenth, shear and the turning of its "
        "sections count, which the model is without",
        thickness, cable.length));
  if (const double stress = cable.youngs_modulus * std::abs(spec.start.stretch - 1); stress > strongest)
    found.push_back(stress_in_words(stress, "at the start"));
  const MethodInfo* info = find_method(spec.method.name);
  if (info == nullptr || !info->dynamic) return found;
  if (const std::string step = step_too_long(spec); !step.empty()) found.push_back(step);
  if (output_times(spec.time).size() <= 2)
    found.push_back(
        fmt::format("time.output_interval = {:.4g} s gives two output times only, 0 and {:.4g} s: what is "
                    "between is not known",
                    spec.time.output_interval, spec.time.end));
  return found;
}

std::string implausible_stress(const Case& spec, const Trajectory& run) {
  if (spec.cable.model == CableModel::rigid || run.q.empty() || !run.vibrations.modes.empty()) return "";
  const Cable cable(spec);
  double greatest = 0, when = 0;
  for (std::size_t k = 0; k < run.q.size(); ++k)
    for (Eigen::Index node = 0; node < cable.nodes(); ++node) {
      const double strain = cable.element().strain(run.q[k].segment<3>(6 * node + 3));
      if (std::abs(strain) <= greatest) continue;
      greatest = std::abs(strain);
      when = run.times[k];
    }
  const double stress = spec.cable.youngs_modulus * greatest;
  return stress > strongest
             ? stress_in_words(stress, fmt::format("at {:.4g} s, where the strain is {:.3g}", when, greatest))
             : "";
}

std::string held_back_by_stability(const Case& spec, const Trajectory& run) {
  constexpr double near = 0.4, few = 0.5;  // of the limit of stability; of the steps
  const MethodInfo* info = find_method(spec.method.name);
  // Implicit stages and tolerances are what it takes to step over vibrations and keep the accuracy.
  const auto others = method_infos();
  const auto other = std::find_if(others.begin(), others.end(), [](const MethodInfo& one) {
    return one.family == MethodFamily::implicit_stages && one.takes_tolerances;
  });
  if (other == others.end() || info == nullptr || info->implicit || !info->dynamic || !spec.method.rtol ||
      spec.method.step || run.outcome != Outcome::completed || run.counters.steps <= 0 ||
      !takes(*other, spec))
    return "";
  const double step = run.end_time / static_cast<double>(run.counters.steps);
  const double turned = step * fastest_frequency_at_start(spec);
  // Of a method for which it is not known, what it is for most.
  constexpr double usual_limit = 1;
  const double limit = stability_limit(with_step(spec.method, step)).value_or(usual_limit);
  if (!(turned >= near * limit)) return "";
  Case tried = spec;
  tried.method = plain_method(*other);
  tried.method.rtol = spec.method.rtol;
  tried.method.atol = spec.method.atol;
  const Trajectory found = integrate(tried, {}, std::max(run.solve_seconds, 1e-3));
  const auto steps = static_cast<double>(found.counters.steps);
  if (found.outcome != Outcome::completed || steps > few * static_cast<double>(run.counters.steps)) return "";
  double apart = 0;
  for (Eigen::Index node = 0; node <= run.elements; ++node)
    apart = std::max(apart, (run.q.back().segment<3>(6 * node) - found.q.back().segment<3>(6 * node)).norm());
  return fmt::format(
      "{} was held back by stability and not by its tolerance: its {} steps turn the fastest vibration by "
      "{:.2g} rad "
      "each; {} with the same tolerances takes {}, in {:.3g} instead of {:.3g} s, and ends {:.2g} m away "
      "(tried)",
      spec.method.name, run.counters.steps, turned, other->name, found.counters.steps, found.solve_seconds,
      run.solve_seconds, apart);
}

}  // namespace plumb
