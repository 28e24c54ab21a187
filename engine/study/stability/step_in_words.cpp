#include "engine/study/stability/step_in_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

template <class Holds>
SettingStretch longest(const OutcomeMap& map, std::size_t at, Holds holds) {
  const std::size_t n = map.settings.size();
  SettingStretch best, now;
  for (std::size_t k = 0; k < n; ++k) {
    if (!holds(map.points[at * n + k].outcome)) {
      now = {k + 1, k + 1};
      continue;
    }
    now.to = k + 1;
    if (now.to - now.from > best.to - best.from) best = now;
  }
  return best;
}

std::string limit_in_words(const OutcomeMap& map, std::size_t at) {
  if (map.limit_kind == LimitKind::always) return "; by theory a vibration grows at every step";
  if (at >= map.limits.size()) return "";
  const PredictedLimit& limit = map.limits[at];
  if (map.limit_kind == LimitKind::contraction && limit.at_start > 0 && std::isfinite(limit.at_start))
    return fmt::format("; Newton's iteration is expected to contract up to {} s",
                       setting_text(limit.at_start, 3));
  if (map.limit_kind != LimitKind::vibration) return "";
  const double step = limit.at_worst > 0 ? limit.at_worst : limit.at_start;
  if (!(step > 0) || !std::isfinite(step)) return "";
  return fmt::format("; the predicted limit is {} s", setting_text(step, 3));
}

}  // namespace

SettingStretch accurate_stretch(const OutcomeMap& map, std::size_t at) {
  return longest(map, at, [](Outcome outcome) { return outcome == Outcome::accurate; });
}

SettingStretch stable_stretch(const OutcomeMap& map, std::size_t at) {
  return longest(map, at, is_stable);
}

std::string setting_text(double setting, int digits) {
  if (!(setting > 0) || !std::isfinite(setting)) return fmt::format("{:g}", setting);
  if (setting >= 0.01 && setting < 1000) return fmt::format("{:.{}g}", setting, digits);
  const std::string text = fmt::format("{:.{}e}", setting, digits - 1);
  const std::size_t e = text.find('e');
  return fmt::format("{}e{}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

std::string step_in_words(const OutcomeMap& map, std::size_t at) {
  const std::size_t n = map.settings.size();
  if (n == 0) return map.by_step ? "no step was tried" : "no tolerance was tried";
  const SettingStretch accurate = accurate_stretch(map, at), stable = stable_stretch(map, at);
  const auto text = [&](std::size_t k) {
    return fmt::format("{}{}", setting_text(map.settings[k]), map.by_step ? " s" : "");
  };
  const char* what = map.by_step ? "a step" : "rtol";
  std::string words;
  if (accurate.empty())
    words = fmt::format("accurate at none of {} from {} to {}", map.by_step ? "the steps" : "the tolerances",
                        text(0), text(n - 1));
  else if (n == 1)
    words = fmt::format("accurate at the only {} that was tried, {}", map.by_step ? "step" : "tolerance",
                        text(0));
  else if (accurate.from == 0)
    words = accurate.to == n ? fmt::format("accurate at all of {}, up to {}",
                                           map.by_step ? "the steps" : "the tolerances", text(n - 1))
                             : fmt::format("accurate up to {} of {}", what, text(accurate.to - 1));
  else if (accurate.from + 1 == accurate.to)
    words = fmt::format("accurate only with {} of {}", what, text(accurate.from));
  else
    words = fmt::format("accurate with {} from {} to {}", what, text(accurate.from), text(accurate.to - 1));
  if (accurate.from > 0 && !accurate.empty())
    words += fmt::format(" ({} at {})", word(map.points[at * n + accurate.from - 1].outcome),
                         text(accurate.from - 1));
  if (!stable.empty() && stable.to > accurate.to) {
    if (stable.from > accurate.from)
      words += fmt::format(", stable only from {} to {}", text(stable.from), text(stable.to - 1));
    else if (stable.to == n)
      words += fmt::format(", stable up to the {}, {}", map.by_step ? "longest" : "loosest", text(n - 1));
    else
      words += fmt::format(", stable up to {}", text(stable.to - 1));
  }
  const std::size_t next = std::max(stable.to, accurate.to);
  if (next < n) words += fmt::format("; {} at {}", word(map.points[at * n + next].outcome), text(next));
  return words + limit_in_words(map, at);
}

}  // namespace plumb
