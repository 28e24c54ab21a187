#pragma once

#include <string>
#include <vector>

#include "engine/study/economy/economy.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// "47 µs", "1.2 s"; "not run" below 0.
std::string seconds_in_words(double seconds);

/// "0.12 px", "1e-05 px", "more than can be told".
std::string pixels_in_words(double pixels);

/// "At 960 by 540 pixels this scene needs a cable of 16 elements, …; the 4 elements of the case are 8.1 px
/// off.", or what is uncertain.
std::string economy_sentence(const Economy& economy, const SceneSpec& scene);

/// The candidates tried, from cheap to dear, a line each: cost, estimated and true error, why it was left;
/// then what the estimates are from, and what the search cost.
std::vector<std::string> explain(const Economy& economy);

/// Verification: the chosen candidate's estimated picture error, times the safety factor, against the
/// tolerance.
Verdict economy_verdict(const Economy& economy);

/// The same of a run whose choice is not at hand: not run. `tolerance` is in pixels.
Verdict verdict_without_choice(double tolerance);

}  // namespace plumb
