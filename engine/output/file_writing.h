#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// Writes a whole file. Throws OutputError with the path and the reason; nothing of the file is left then.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace plumb
