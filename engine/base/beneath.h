#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {

/// An open file or folder, closed with it.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int get() const { return number_; }
  /// Leaves it open for someone else to close.
  int release() { return std::exchange(number_, -1); }
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_ = -1;
};

/// Whether a name can only mean a file below a folder: "frames/0000.png"; not "/etc/passwd", "../a", "a//b",
/// "./a", and nothing with a zero byte.
bool is_name_beneath(std::string_view name);

/// A file below a folder by the folder it lies in, reached without following any link, and its last name.
struct Beneath {
  Descriptor folder;  ///< closed where there is no such folder: missing, a link or a file (errno tells)
  std::string name;
};

/// `name` is one that is_name_beneath(); with `make`, folders that are missing are made.
Beneath find_beneath(int root, const std::string& name, bool make = false);

/// Opens a folder for reading, without following a link at its end.
Descriptor open_folder(const std::string& path);

/// What is in a folder.
struct Entry {
  std::string name;
  bool folder = false, file = false;  ///< a regular one
};

/// All in an open folder; nullopt where it cannot be read.
std::optional<std::vector<Entry>> entries_of(int folder);

/// Makes what an open file or folder holds outlast a power cut. Returns the error number, or 0; that the file
/// system knows no way to do so is no error.
int flush_to_disk(int descriptor);

}  // namespace plumb
