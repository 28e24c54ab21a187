#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// Number of letters to insert, drop, change or swap with their neighbour to turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to a mistyped one, or an empty one where none shares at least half of its letters.
/// Of very many known words only the first are looked at.
std::string_view nearest(std::string_view word, std::span<const std::string> known);

/// The end of an error about an unknown word: `; did you mean "length"?`, or `; known: area, length` where
/// none is near.
std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace plumb
