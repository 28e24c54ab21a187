#pragma once

#include <string>

namespace plumb {

/// The text of a file, or why it cannot be read.
struct FileText {
  std::string text;
  std::string failure;  ///< "No such file or directory"; empty where the text was read
};

/// Reads a whole file. Files of more than 64 MiB are not read: no case is that long.
FileText read_file_text(const std::string& path);

/// The same where there must be one: throws InputError, "PATH: cannot be read: REASON".
std::string read_whole_file(const std::string& path);

}  // namespace plumb
