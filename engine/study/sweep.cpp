#include "engine/study/sweep.h"

namespace plumb {

bool SweepRun::judged() const {
  return outcome != Outcome::not_run && outcome != Outcome::completed;
}

bool SweepRun::wrongly_accurate(double tolerance) const {
  if (outcome != Outcome::accurate) return false;
  // Written so that a distance that is not a number is wrong.
  return !(second_error >= 0 && disagreement >= 0 && second_error <= tolerance + disagreement);
}

}  // namespace plumb
