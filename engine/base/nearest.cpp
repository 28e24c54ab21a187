#include "engine/base/nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace plumb {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string_view nearest(std::string_view word, std::span<const std::string> known) {
  // No known word is that long, and the work grows with the product of the lengths.
  constexpr std::size_t longest = 100, most_work = 20'000'000;
  if (word.size() > longest) return {};
  std::string_view best;
  std::size_t best_distance = 0, work = 0;
  for (const std::string& candidate : known) {
    // The distance is at least the difference of the lengths.
    const std::size_t more = std::max(word.size(), candidate.size()),
                      less = std::min(word.size(), candidate.size());
    if (2 * (more - less) > more) continue;
    work += more * less;
    if (work > most_work) break;
    const std::size_t distance = edit_distance(word, candidate);
    if (2 * distance > more) continue;
    if (best.empty() || distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  if (const std::string_view near = nearest(word, known); !near.empty())
    return fmt::format("; did you mean \"{}\"?", near);
  if (known.empty()) return {};
  constexpr std::size_t most = 30;
  const auto shown = known.first(std::min(most, known.size()));
  return fmt::format("; known: {}{}", fmt::join(shown, ", "),
                     known.size() > most ? fmt::format(" and {} more", known.size() - most) : "");
}

}  // namespace plumb
