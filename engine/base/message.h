#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace plumb {

/// The text as every message shows it: one line of at most 400 bytes, a longer one shortened in its middle.
/// What a terminal or a reader would not see as it is becomes an escape: \n and \t, other control characters
/// and bytes that are no UTF-8 as \x1b, signs that turn the direction of a text or have no width as \u202e.
/// Applied twice it changes nothing more.
std::string one_line(const std::string& text);

/// A value that a user gave, for within a message: the same in at most 40 characters, with … for the rest.
std::string short_value(std::string_view text);

/// Why something failed, in words of this program: the message of its own errors, what the system says of a
/// failed call, and plain words in place of what a library says of itself.
std::string reason(const std::exception& error);

}  // namespace plumb
