#include "engine/integrate/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plumb {

std::span<const Outcome> outcomes() {
  static constexpr std::array all{Outcome::not_run,        Outcome::completed, Outcome::accurate,
                                  Outcome::inaccurate,     Outcome::unstable,  Outcome::diverged,
                                  Outcome::no_convergence, Outcome::singular,  Outcome::unstable_equilibrium,
                                  Outcome::out_of_time};
  return all;
}

std::string_view word(Outcome outcome) {
  switch (outcome) {
    case Outcome::not_run:
      return "not-run";
    case Outcome::completed:
      return "completed";
    case Outcome::accurate:
      return "accurate";
    case Outcome::inaccurate:
      return "inaccurate";
    case Outcome::unstable:
      return "unstable";
    case Outcome::diverged:
      return "diverged";
    case Outcome::no_convergence:
      return "no-convergence";
    case Outcome::singular:
      return "singular";
    case Outcome::unstable_equilibrium:
      return "unstable-equilibrium";
    case Outcome::out_of_time:
      return "out-of-time";
  }
  return "not-run";
}

std::span<const CriticalKind> critical_kinds() {
  static constexpr std::array all{CriticalKind::limit_point, CriticalKind::bifurcation};
  return all;
}

std::string_view word(CriticalKind kind) {
  return kind == CriticalKind::limit_point ? "limit-point" : "bifurcation";
}

std::string_view in_words(CriticalKind kind) {
  return kind == CriticalKind::limit_point ? "limit point" : "bifurcation";
}

std::span<const ModeKind> mode_kinds() {
  static constexpr std::array all{ModeKind::vibration, ModeKind::overdamped, ModeKind::rigid_body,
                                  ModeKind::slack, ModeKind::growing};
  return all;
}

std::string_view word(ModeKind kind) {
  switch (kind) {
    case ModeKind::vibration:
      return "vibration";
    case ModeKind::overdamped:
      return "overdamped";
    case ModeKind::rigid_body:
      return "rigid-body";
    case ModeKind::slack:
      return "slack";
    case ModeKind::growing:
      return "growing";
  }
  return "vibration";
}

double greatest_displacement(const VibrationMode& mode) {
  double greatest = 0;
  for (Eigen::Index at = 0; at < mode.shape.size(); at += 6) {
    const Eigen::Vector3d re = mode.shape.segment<3>(at);
    if (mode.quadrature.size() == 0) {
      greatest = std::max(greatest, re.norm());
      continue;
    }
    // An ellipse: its longer half axis.
    const Eigen::Vector3d im = mode.quadrature.segment<3>(at);
    const double sum = re.squaredNorm() + im.squaredNorm();
    const double half = std::hypot(0.5 * (re.squaredNorm() - im.squaredNorm()), re.dot(im));
    greatest = std::max(greatest, std::sqrt(0.5 * sum + half));
  }
  return greatest;
}

namespace {

/// The greater of two numbers; one that is not a number is greater than any.
double worse(double a, double b) {
  return b <= a || std::isnan(a) ? a : b;
}

}  // namespace

std::string Trajectory::remark() const {
  if (unstable_since < 0) return "";
  return fmt::format(
      "unstable start: the motion depends on what the case does not state; the cable keeps to its straight "
      "line only "
      "as nothing disturbs it, and would leave it from {:.3g} s on",
      unstable_since);
}

double Trajectory::energy_drift() const {
  double drift = 0;
  for (const Energies& e : energies) drift = worse(drift, std::abs(e.total() - energies.front().total()));
  return drift;
}

double Trajectory::energy_round_off() const {
  constexpr double units_of_a_step = 8;
  double greatest = 0;
  for (const Energies& e : energies)
    greatest = std::max(greatest, std::abs(e.kinetic) + std::abs(e.axial) + std::abs(e.bending) +
                                      std::abs(e.potential) + std::abs(e.work) + std::abs(e.dissipated));
  const auto steps = static_cast<double>(std::max<long>(counters.steps, std::ssize(energies)));
  return units_of_a_step * std::numeric_limits<double>::epsilon() * std::sqrt(steps) * greatest;
}

double Trajectory::kinetic_scale() const {
  // A start this much slower than what follows is a start from rest.
  constexpr double rest = 1e-6;
  double greatest = 0;
  for (const Energies& e : energies) greatest = std::max(greatest, e.kinetic);
  const double first = energies.empty() ? 0 : energies.front().kinetic;
  return first > rest * greatest ? first : greatest;
}

double Trajectory::relative_energy_drift() const {
  const double drift = energy_drift(), scale = kinetic_scale();
  if (!energies.empty() && drift == 0) return 0;
  const double relative = drift / scale;
  return scale > 0 && std::isfinite(relative) ? relative : -1;
}

Outcome outcome_named(const std::string& name) {
  for (const Outcome outcome : outcomes())
    if (word(outcome) == name) return outcome;
  throw std::runtime_error("the outcome '" + name + "' is unknown");
}

}  // namespace plumb
