#include "engine/study/reference/certified_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"
#include "engine/integrate/processor_time.h"
#include "engine/model/straight_frequency.h"
#include "engine/study/reference/error_norms.h"

namespace plumb {
namespace {

/// The pair of order 5 where that is enough: the error estimate of that of order 8 breaks down at
/// the edge of stability, to which a loose tolerance leads on a fine mesh.
MethodSpec embedded_pair(double tolerance) {
  constexpr double loose = 1e-10;
  MethodSpec spec = plain_method(embedded_explicit());
  spec.parameters["order"] = tolerance > loose ? 5 : 8;
  spec.rtol = spec.atol = tolerance;
  return spec;
}

/// Of another family of formulas, and no code in common with the first but the forces.
MethodSpec unlike(const Case& spec, double step) {
  MethodSpec method =
      plain_method(takes(accurate_explicit(), spec) ? accurate_explicit() : accurate_implicit());
  method.step = step;
  return method;
}

std::string describe(const MethodSpec& method) {
  if (method.step) return fmt::format("{} with step {:.3g} s", method.name, *method.step);
  return fmt::format("{} of order {:g} with rtol {:.3g}", method.name, method.parameters.at("order"),
                     *method.rtol);
}

Trajectory run(const Case& spec, const MethodSpec& method, double time_limit) {
  Case with = spec;
  with.method = method;
  return integrate(with, {}, time_limit);
}

/// True of a distance that was found.
bool known(double distance) {
  return std::isfinite(distance) && distance >= 0;
}

/// -1 where either is not whole.
double tip_distance(const Trajectory& a, const Trajectory& b) {
  const bool whole = a.outcome == Outcome::completed && b.outcome == Outcome::completed;
  return whole ? error_norms(a, b).tip_max : -1;
}

StudyReference reference_of(const Trajectory& trajectory, const MethodSpec& first, const MethodSpec& second,
                            double agreement) {
  StudyReference result;
  result.certificate.elements = trajectory.elements;
  result.certificate.first = describe(first);
  result.certificate.second = describe(second);
  result.certificate.agreement = agreement;
  result.method = first;
  if (trajectory.outcome == Outcome::completed) result.trajectory = trajectory;
  return result;
}

/// A guess at the step from which the second method is stable, by the limit of classical_explicit(). Too long
/// a step only costs a run.
double first_step(const Case& spec) {
  constexpr double limit = 2.828;
  return std::min(limit / straight_frequency(spec.cable), spec.time.output_interval);
}

double dividing(double output_interval, double step) {
  return output_interval / std::ceil(output_interval / step - 1e-9);
}

/// What agrees better than what was there before; a reference that nothing agrees with is better than none.
bool better(const StudyReference& a, const StudyReference& b) {
  if (a.trajectory.times.empty() || b.trajectory.times.empty()) return b.trajectory.times.empty();
  if (!known(a.certificate.agreement) || !known(b.certificate.agreement))
    return !known(b.certificate.agreement);
  return a.certificate.agreement < b.certificate.agreement;
}

}  // namespace

StudyReference hold_together(const Case& spec, const MethodSpec& first, const MethodSpec& second,
                             double time_limit) {
  const Trajectory a = run(spec, first, time_limit);
  return reference_of(a, first, second, tip_distance(a, run(spec, second, time_limit)));
}

StudyReference make_reference(const Case& spec, double target, double time_limit) {
  constexpr double most_steps = 1e7;
  const double interval = spec.time.output_interval;
  const double started = processor_seconds();
  const auto time_left = [&] { return time_limit - (processor_seconds() - started); };
  StudyReference best;
  best.certificate.elements = spec.cable.elements;
  double step = dividing(interval, first_step(spec) / 2);
  Trajectory second;
  // From loose to tight, so that a mesh too dear for the target still has the best that it can have.
  for (const double tolerance : {1e-7, 1e-9, 1e-11, 1e-13}) {
    const Trajectory first = run(spec, embedded_pair(tolerance), time_left());
    if (first.outcome != Outcome::completed) {
      if (better(reference_of(first, embedded_pair(tolerance), unlike(spec, step), -1), best))
        best = reference_of(first, embedded_pair(tolerance), unlike(spec, step), -1);
      if (first.outcome == Outcome::out_of_time) break;
      continue;
    }
    double before = INFINITY;
    while (true) {
      if (second.outcome != Outcome::completed) {
        if (spec.time.end / step > most_steps) break;
        second = run(spec, unlike(spec, step), time_left());
      }
      const double distance = tip_distance(first, second);
      const StudyReference found =
          reference_of(first, embedded_pair(tolerance), unlike(spec, step), distance);
      if (better(found, best)) best = found;
      if (distance >= 0 && distance <= target) return best;
      if (second.outcome == Outcome::out_of_time) return best;
      // Where a shorter step no longer brings them together, it is the first that is to be tightened.
      if (distance >= 0 && distance > before / 3) break;
      double factor = 0.5;
      if (distance >= 0) {
        before = distance;
        factor = std::clamp(0.8 * std::pow(target / distance, 1.0 / 8), 0.25, 0.7);
      }
      step = dividing(interval, step * factor);
      second = {};
    }
  }
  return best;
}

void certify(CertifiedReference& reference, double smallest_error, double mesh_error) {
  constexpr double margin = 10;
  reference.smallest_error = smallest_error;
  reference.certified = false;
  reference.why_not.clear();
  reference.floor = std::max({margin * reference.agreement, mesh_error, 0.0});
  if (!known(reference.agreement))
    reference.why_not = "no two methods completed the reference";
  else if (!known(mesh_error))
    reference.why_not = "the error of its mesh is not known";
  else if (!known(smallest_error))
    reference.why_not = "no run has an error against it";
  else if (smallest_error < margin * reference.agreement)
    reference.why_not = fmt::format(
        "its two methods agree to {:.2g} m, which is not ten times better than the smallest error drawn, "
        "{:.2g} m",
        reference.agreement, smallest_error);
  else if (smallest_error < mesh_error)
    reference.why_not = fmt::format(
        "the error of its mesh, some {:.2g} m, is greater than the smallest error drawn, {:.2g} m",
        mesh_error, smallest_error);
  else
    reference.certified = true;
}

}  // namespace plumb
