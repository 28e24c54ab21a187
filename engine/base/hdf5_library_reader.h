#pragma once

#include "engine/base/hdf5.h"

namespace plumb::hdf5 {

/// What is in a file, by the library, which trusts what it reads: only for within a confined process.
class LibraryReader {
 public:
  /// From the bytes of a file, which must outlive the reader. Throws if they are no HDF5 file.
  explicit LibraryReader(const std::string& bytes);
  ~LibraryReader();
  LibraryReader(const LibraryReader&) = delete;
  LibraryReader& operator=(const LibraryReader&) = delete;

  /// Whether there is a data set of that path; the group it is in may be missing too.
  bool has(const std::string& path) const;
  /// Numbers of any shape.
  Numbers numbers(const std::string& path) const;
  /// Numbers of the shape that is expected. Throws for another one before any memory is taken for it.
  std::vector<double> numbers(const std::string& path, const std::vector<hsize_t>& shape) const;
  std::vector<long> integers(const std::string& path) const;
  std::vector<std::string> texts(const std::string& path) const;
  std::string bytes(const std::string& path) const;

  // Of files that other programs wrote:

  /// Paths of the data sets of numbers with one dimension, at most 10,000.
  std::vector<std::string> series() const;
  /// The numbers of one of them, whole ones too. Throws for more than `most`.
  std::vector<double> series_values(const std::string& path, hsize_t most) const;
  /// The text of its attribute `unit`; empty where it has none.
  std::string unit(const std::string& path) const;

 private:
  hid_t file_;
};

}  // namespace plumb::hdf5
