#pragma once

#include <string>

#include "engine/study/stability/stability.h"

namespace plumb {

/// Settings of a map side by side: places [from, to).
struct SettingStretch {
  std::size_t from = 0, to = 0;
  bool empty() const { return from == to; }
};

/// The longest stretch at one value of a map whose runs are accurate; and that whose runs are stable.
SettingStretch accurate_stretch(const OutcomeMap& map, std::size_t at);
SettingStretch stable_stretch(const OutcomeMap& map, std::size_t at);

/// The settings at one value of a map that a user would want: "accurate up to a step of 8.7e-4 s, stable up
/// to 1.0e-3 s; unstable at 1.5e-3 s; the predicted limit is 1.05e-3 s". `at` is the place of the value.
std::string step_in_words(const OutcomeMap& map, std::size_t at);

/// "8.7e-4": a step or tolerance for people, in two digits; three with `digits`.
std::string setting_text(double setting, int digits = 2);

}  // namespace plumb
