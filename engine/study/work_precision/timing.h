#pragma once

#include <string>
#include <vector>

namespace plumb {

/// Whether a run has been timed (s each) as often as it is worth. One of a tenth of a second or more is timed
/// once. Shorter ones are disturbed more easily: they are repeated until the two least times agree to 2 %,
/// up to `repeats` times, and below a hundredth of a second four times as often.
bool is_timed(const std::vector<double>& seconds, int repeats);

/// That rule, for people.
std::string timing_rule();

}  // namespace plumb
