#pragma once

#include <string>
#include <string_view>

#include "engine/base/errors.h"

namespace plumb {

/// A file could not be written, as against a picture that could not be drawn.
class WriteError : public OutputError {
 public:
  /// "PATH: cannot be written: REASON"
  WriteError(const std::string& path, const std::string& reason);
  /// The same with what the system says of an error number.
  WriteError(const std::string& path, int error);
};

/// Writes a whole file. A regular file, old or new, changes only once all is written and on the disk, and
/// keeps its permissions; that holds for one at the end of a link as well, and the link stays. Anything else
/// (a device, a pipe, what the program has open as /dev/stdout) is written to as it is. Throws WriteError; a
/// regular file is as before then.
void write_file(const std::string& path, std::string_view bytes);

/// Where write_file() and others put a file: `path` with the links at its end followed. Empty where it is to
/// be written to as it is.
std::string place_of_file(const std::string& path);

/// Writes all bytes to an open file. Returns the error number, or 0.
int write_all(int file, std::string_view bytes);

/// Writes to standard output, to the end. Throws WriteError if it cannot be.
void write_to_standard_output(std::string_view text);

}  // namespace plumb
