#pragma once

#include <stdexcept>
#include <string>

namespace plumb {

/// A fault in a file or value that the user gave. The message is one line and complete:
/// "cases/a.toml:4:10: cable.length = -1: must be greater than 0 (m)". Ends the program with status 3.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The command line asks for something that does not exist. Ends the program with status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A picture could not be drawn or a file could not be written; says which and why. Ends the program with
/// status 5.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user asked to stop (SIGINT, SIGTERM). Ends the program with status 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace plumb
