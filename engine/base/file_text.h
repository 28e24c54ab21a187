#pragma once

#include <cstdint>
#include <string>

namespace plumb {

/// What a file is read as, which says how long it may be.
enum class InputKind {
  case_file,  ///< TOML, 4 MiB
  reference,  ///< TOML, 16 MiB
  given_run,  ///< CSV or HDF5 of another program, 64 MiB
  document,   ///< JSON that Plumb wrote and what stands beside it, 64 MiB
  picture,    ///< PNG or a film, 256 MiB
  run_file,   ///< run.h5, study.h5: 16 GiB
};

/// The longest file of that kind, bytes.
std::uint64_t longest(InputKind kind);

/// The text of a file, or why it cannot be read.
struct FileText {
  std::string text;
  std::string failure;  ///< "No such file or directory"; empty where the text was read
};

/// Reads a whole file. Only regular files are read: a named pipe, a device, a socket or a folder is refused
/// without waiting for it, as is a file that is longer than its kind may be, or that changes its length while
/// it is read. Throws Interrupted.
FileText read_file_text(const std::string& path, InputKind kind = InputKind::document);

/// The same where there must be one: throws InputError, "PATH: cannot be read: REASON".
std::string read_whole_file(const std::string& path, InputKind kind = InputKind::document);

}  // namespace plumb
