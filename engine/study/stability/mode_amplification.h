#pragma once

#include <vector>

#include "engine/study/reference/method_settings.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// What each fixed-step variant does to a small vibration of the straight, unloaded cable of a case, beside
/// amplification(). The cable starts in the shape of its fastest vibration, a strain of some 1e-7, so that
/// nothing else moves and nothing but the method changes the amplitude; the step is the period over each of
/// `steps_a_period`. A variant that has no prediction is left out; a run that did not last is measured at -1.
std::vector<ModeAmplification> mode_amplifications(const std::vector<MethodSetting>& variants,
                                                   const Case& spec, const std::vector<int>& steps_a_period);

/// The modulus of the greatest root of the recurrence x[k+1] = a x[k] + b x[k−1] that fits a series best by
/// least squares: what a step does to a vibration sampled at every step, as Prony found. -1 where it has
/// fewer than four values or does not move.
double growth_a_step(const std::vector<double>& series);

}  // namespace plumb
