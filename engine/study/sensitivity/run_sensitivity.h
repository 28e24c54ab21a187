#pragma once

#include <functional>

#include "engine/run/run.h"
#include "engine/study/runner.h"
#include "engine/study/sensitivity/sensitivity.h"

namespace plumb {

/// Judges a run by the criteria of its case.
using Judge = std::function<std::vector<JudgedCriterion>(const Run& run)>;

/// What the case asks for in [sensitivity], or the defaults.
SensitivitySpec sensitivity_of(const Case& spec);

/// Changes a case, number by number and blunder by blunder, and finds which criteria notice, in parallel over
/// the processors. The references are taken to be those of the case, whatever was changed in it: a program
/// that has a number wrong does not say so. A run that fails is a result. Throws Interrupted if the user
/// stops it.
Sensitivity run_sensitivity(const LoadedCase& loaded, const Judge& judge, Runner& runner);

}  // namespace plumb
