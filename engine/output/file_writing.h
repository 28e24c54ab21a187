#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// Writes a whole file. A regular file, old or new, changes only once all is written; anything else (a link,
/// a device, a pipe) is written to as it is. Throws OutputError with the path and the reason; a regular file
/// is as before then.
void write_file(const std::string& path, std::string_view bytes);

/// Writes to standard output, to the end. Throws OutputError if it cannot be.
void write_to_standard_output(std::string_view text);

}  // namespace plumb
