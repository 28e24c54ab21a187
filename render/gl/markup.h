#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb {

enum class Script { none, above, below };

/// A stretch of text on one base line, UTF-8.
struct TextRun {
  std::string text;
  Script script = Script::none;

  friend bool operator==(const TextRun&, const TextRun&) = default;
};

/// Reads the markup of labels:
/// - `^{…}` and `_{…}` set what the braces enclose as a superscript or a subscript: "10^{-3}", "ω_{max}". It
///   has no braces in it and is not empty.
/// - `^` or `_` before a character beyond ASCII do the same to that one: "ρ_∞".
/// - `\` before one of `\^_{}` takes it as it is.
/// All else is shown as it stands, so a name like "mid_y" needs no care. A hyphen before a digit in a script
/// becomes a minus sign.
std::vector<TextRun> read_markup(std::string_view text);

/// Markup that shows a text just as it is.
std::string literal(std::string_view text);

}  // namespace plumb
