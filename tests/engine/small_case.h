#pragma once

#include <string>
#include <vector>

#include "engine/case/case_source.h"

namespace plumb {

/// The text of a file; fails the test where it cannot be read.
std::string text_of_file(const std::string& path);

/// A small case that uses every section and every key, with its reference: tests/data/small_case.toml.
CaseSource small_case();

/// The text with the one occurrence at which it first holds `from` replaced; fails the test where there is
/// none.
std::string with(std::string text, const std::string& from, const std::string& to);

/// The message of the InputError or UsageError with which the case is refused; "accepted" where it is not.
std::string refusal(const CaseSource& source);

/// True where the message is as expected; each "…" in what is expected stands for anything.
bool matches(const std::string& message, const std::string& expected);

}  // namespace plumb
