#pragma once

#include "engine/integrate/methods/loaded_cable.h"

namespace plumb {

/// Follows the motion of a cable so damped that its inertia does not count, M dq/dτ = R(q, λ), from q to
/// where it comes to rest under that share of the load, and leaves q there: backward Euler's method with
/// steps that grow (pseudo-transient continuation, Kelley and Keyes 1998). Each step makes the potential
/// energy less and turns no slope far, so that the cable goes down the valley that it is in. Where it ends is
/// an equilibrium that the cable would not leave, with K factored there; where it does not, the result says
/// why.
StepResult come_to_rest(LoadedCable& loaded, Eigen::VectorXd& q, double share);

}  // namespace plumb
