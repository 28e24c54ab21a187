#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// The file that says what of a folder is ours.
inline constexpr const char* manifest_name = "manifest.json";

/// What a file was when it was written.
struct ListedFile {
  std::uintmax_t size = 0;  ///< bytes
  std::string sha256;       ///< 64 hexadecimal digits

  friend bool operator==(const ListedFile&, const ListedFile&) = default;
};

/// What a file of these bytes is listed as.
ListedFile listed_as(const std::string& bytes);

/// Files of a folder by their names below it: "frames/0000.png".
using ListedFiles = std::map<std::string, ListedFile>;

/// What of a folder is ours. Only a file that is listed and still is what it was may ever be replaced or
/// removed.
struct Manifest {
  ListedFiles files;
  /// What files are about to become, where they are being put in place one after another: until that is done
  /// each may be either.
  ListedFiles next = {};

  /// All names, there or to be.
  ListedFiles all() const;
};

/// Whether a manifest can list a file of this name: its text is UTF-8.
bool is_name_listed_as_it_is(const std::string& name);

/// Its JSON: `plumb_manifest` (the version, 1), `files[]` with `name`, `size`, `sha256`, and `next[]` where
/// there are such.
std::string encode_manifest(const Manifest& manifest);

/// A manifest that was looked for.
struct FoundManifest {
  bool there = false;   ///< there is a file of that name
  std::string fault;    ///< why it is none; empty where there is none or it is good
  Manifest manifest{};  ///< nothing where there is none or it is at fault
  std::string text{};   ///< its bytes, to tell one that was changed
};

/// Reads the manifest of an open folder. It is not trusted: a link, another version, anything beside what
/// encode_manifest() writes, a name that leads out of the folder or comes twice makes all of it void.
FoundManifest find_manifest(int folder);

/// Whether a file below a folder still is what a list says. Links are not followed. Throws std::system_error
/// where that cannot be found out.
bool is_still(int folder, const std::string& name, const ListedFile& listed);

/// The bytes of such a file; nothing if it is not.
std::optional<std::string> bytes_of(int folder, const std::string& name, const ListedFile& listed);

/// The files that a manifest lists and that still are what it says.
ListedFiles files_that_are_ours(int folder, const Manifest& manifest);

}  // namespace plumb
