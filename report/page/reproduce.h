#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// A word as a POSIX shell takes it: in single quotes where it holds more than letters, digits and
/// _./=:,+@%-.
std::string shell_word(const std::string& word);

/// The command that makes the run of a document again, to be given from where it was: "plumb run
/// cases/pendulum.toml --set cable.elements=1".
std::string command_of(const Document& document);

}  // namespace plumb
