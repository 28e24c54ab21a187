#pragma once

#include <functional>

#include "engine/case/case.h"
#include "engine/study/runner.h"

namespace plumb {

/// Runs that take no longer than this many times what they would alone are timed with others beside them,
/// one a core.
inline constexpr double undisturbed = 1.05;

/// How many times as long a piece of work takes with one like it on every other core: the least times of a
/// few are held against one another, and the slowest core counts. 1 where there is but one core. `piece` does
/// the work and gives its processor time, s; it is called from several threads at once.
double slowdown_in_company(const std::function<double()>& piece);

/// The same of some milliseconds of a case's motion, as a part of a study that comes before all that is
/// timed.
double slowdown_in_company(const Case& spec, Runner& runner);

/// How points that are timed are to be computed.
inline Company company_of_timed(double slowdown) {
  return slowdown <= undisturbed ? Company::together : Company::alone;
}

/// Which that is, and why, for people.
std::string slowdown_in_words(double slowdown);

}  // namespace plumb
