#pragma once

#include <string>

namespace plumb {

/// Ends a file, behind what HDF5 reads, with a mark and the CRC-32 of all before it, so that a file that was
/// cut or damaged is known before the library, which trusts what it reads, is given it.
std::string with_check_sum(std::string bytes);

/// The bytes before the mark of what such a file holds. Throws std::runtime_error with the reason if they
/// were damaged, or are those of no `kind` of file ("run file").
std::string without_check_sum(std::string bytes, const std::string& kind);

/// The bytes of such a file before its mark. Throws std::runtime_error with the reason if the file cannot be
/// read, is no `kind` of file ("run file") or was damaged.
std::string read_checked(const std::string& path, const std::string& kind);

}  // namespace plumb
