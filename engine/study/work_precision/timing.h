#pragma once

#include <functional>
#include <string>
#include <vector>

namespace plumb {

/// Runs that take no longer than this many times what they would alone are timed with others beside them,
/// one a core.
inline constexpr double undisturbed = 1.05;

/// How many times as long a piece of work takes with one like it on every other core: the least times of a
/// few are held against one another, and the slowest core counts. 1 where there is but one core. `piece` does
/// the work and gives its processor time, s; it is called from several threads at once.
double slowdown_in_company(const std::function<double()>& piece);

/// Whether a run has been timed (s each) as often as it is worth. One of a tenth of a second or more is timed
/// once. Shorter ones are disturbed more easily: they are repeated until the two least times agree to 2 %,
/// up to `repeats` times, and below a hundredth of a second four times as often.
bool is_timed(const std::vector<double>& seconds, int repeats);

/// That rule, for people.
std::string timing_rule();

}  // namespace plumb
