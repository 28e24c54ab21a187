#pragma once

#include "engine/integrate/method.h"

namespace plumb {

/// A place where a cable rests.
struct Rest {
  Eigen::VectorXd q;
  StepResult failure;  ///< why there is none; `completed` where there is
};

/// Where a cable rests under the loads at the end of the run (RunTimes::duration), from the start q: in the
/// frame that turns with Cable::spin. It is the start where that is an equilibrium already, else what statics
/// finds. Where statics finds nothing, as nothing but the load holds the cable, and in a frame that turns, it
/// is what Newton's iteration finds from the start, with a mass on all that would turn or move for nothing,
/// which gets less and less. A cable that would leave such a place is followed by damped motion; where that
/// comes nowhere to rest the place is returned.
Rest find_rest(Dynamics& dynamics, const Eigen::VectorXd& start);

}  // namespace plumb
