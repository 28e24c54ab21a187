#include "engine/integrate/trajectory.h"

#include <algorithm>
#include <cmath>

namespace plumb {

std::string_view word(Outcome outcome) {
  switch (outcome) {
    case Outcome::not_run:
      return "not-run";
    case Outcome::completed:
      return "completed";
    case Outcome::unstable:
      return "unstable";
    case Outcome::diverged:
      return "diverged";
    case Outcome::no_convergence:
      return "no-convergence";
    case Outcome::singular:
      return "singular";
  }
  return "not-run";
}

double Trajectory::energy_drift() const {
  double drift = 0;
  for (const Energies& e : energies) drift = std::max(drift, std::abs(e.total() - energies.front().total()));
  return drift;
}

double Trajectory::relative_energy_drift() const {
  const double scale = energies.empty() ? 0 : energies.front().kinetic;
  return scale > 0 ? energy_drift() / scale : 0;
}

}  // namespace plumb
