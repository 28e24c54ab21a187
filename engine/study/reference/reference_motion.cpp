#include "engine/study/reference/reference_motion.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/cable.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "engine/study/reference/node_distance.h"
#include "engine/study/reference/trajectory_divergence.h"

namespace plumb {
namespace {

double greatest_frequency(const Cable& cable, const std::vector<Eigen::VectorXd>& states) {
  // A motion is smooth: some of its states show the worst to far less than a percent.
  constexpr std::size_t enough = 50;
  const std::size_t stride = std::max<std::size_t>(1, states.size() / enough);
  double greatest = 0;
  for (std::size_t k = 0; k < states.size(); k += stride)
    greatest = std::max(greatest, fastest_vibration(cable, states[k]).frequency);
  return greatest;
}

/// Up to when the motion is known to a tenth of the tolerance. Where the two methods that gave it part
/// before the end, it is held against a third to see when.
double trusted_until(const Case& spec, const StudyReference& reference, double tolerance, double time_limit) {
  constexpr double share = 0.1, tight = 1e-12;
  if (reference.trajectory.times.empty()) return -1;
  if (reference.certificate.agreement >= 0 && reference.certificate.agreement <= share * tolerance)
    return reference.trajectory.times.back();
  Case with = spec;
  with.method = plain_method(embedded_explicit());
  with.method.parameters["order"] = 5;
  with.method.rtol = with.method.atol = tight;
  return together_until(integrate(with, {}, time_limit), reference.trajectory, share * tolerance);
}

}  // namespace

double ReferenceMotion::horizon() const {
  return std::min(divergence.beyond_end || divergence.horizon < 0 ? summary.duration : divergence.horizon,
                  summary.trusted_until);
}

std::string ReferenceMotion::in_words() const {
  return fmt::format("{} elements, parameter {}", spec.cable.elements, parameter);
}

ReferenceMotion reference_motion(const Case& spec, double parameter, double tolerance, double time_limit) {
  // Far better than what is judged, and yet reached where neighbours part by some powers of ten.
  constexpr double share_of_tolerance = 1e-4;
  ReferenceMotion motion;
  motion.parameter = parameter;
  motion.spec = spec;
  StudyReference reference = make_reference(spec, share_of_tolerance * tolerance, time_limit);
  StabilityReference& summary = motion.summary;
  summary.parameter = parameter;
  summary.elements = spec.cable.elements;
  summary.duration = spec.time.end;
  summary.first = reference.certificate.first;
  summary.second = reference.certificate.second;
  summary.agreement = reference.certificate.agreement;
  summary.trusted_until = trusted_until(spec, reference, tolerance, time_limit);
  const Cable cable(spec);
  const Eigen::VectorXd start = cable.start_q(spec.start);
  summary.frequency_at_start = fastest_vibration(cable, start).frequency;
  summary.frequency_at_worst =
      std::max(summary.frequency_at_start, greatest_frequency(cable, reference.trajectory.q));
  if (!reference.trajectory.times.empty()) motion.method = reference.method;
  motion.trajectory = std::move(reference.trajectory);
  motion.divergence = divergence(spec, parameter, tolerance, start_distance, time_limit);
  return motion;
}

}  // namespace plumb
