#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// A term of the field, or of this program, that pages explain.
struct Term {
  std::string_view id;     ///< of its place in the glossary, after "term-": "horizon"
  std::string_view name;   ///< as the glossary has it
  std::string_view words;  ///< as texts have it, all forms, with "|" between them
  std::string_view text;   ///< two sentences
  std::string_view source;
};

/// All of them, in the order of the alphabet.
std::span<const Term> terms();

/// The body of a page whose terms lead to a glossary at the end of its <main>, which has those that the page
/// uses. In each section the first place of a term is the link; none is made in headings, links, buttons,
/// formulas, code and names of files. A page that uses no term stays as it is.
std::string with_glossary(const std::string& body);

/// The same with a caption in every table that has none: the heading above it. It names the table for who
/// cannot see the page, and on paper it is numbered. What scrolls about a table has that name, and the
/// keyboard reaches it.
std::string with_captions(const std::string& body);

}  // namespace plumb
