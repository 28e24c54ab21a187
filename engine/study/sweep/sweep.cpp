#include "engine/study/sweep/sweep.h"

#include <cmath>

namespace plumb {

bool SweepRun::judged() const {
  return outcome != Outcome::not_run && outcome != Outcome::completed;
}

bool SweepRun::wrongly_accurate(double tolerance) const {
  if (outcome != Outcome::accurate) return false;
  // Written so that a distance that is not a number is wrong, and one to references that disagree without
  // end.
  return !(second_error >= 0 && disagreement >= 0 && std::isfinite(disagreement) &&
           std::isfinite(second_error) && second_error <= tolerance + disagreement);
}

}  // namespace plumb
