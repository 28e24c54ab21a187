#pragma once

#include <hdf5.h>

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/confined_process.h"

/// Small owning types around the C interface of HDF5: just the shapes that run files hold. Every failure
/// throws std::runtime_error with the name of what failed; the library's own messages are silenced.
namespace plumb::hdf5 {

/// A file built in memory, so that the disk sees one plain write that can fail in one plain way. Throws
/// std::bad_alloc where the memory for it is not there.
class Writer {
 public:
  Writer();
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Numbers with the given shape, row-major; groups in the path are made as needed.
  void numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
               std::string_view unit);
  void number(const std::string& path, double value, std::string_view unit) {
    numbers(path, {}, &value, unit);
  }
  void integer(const std::string& path, long value);
  void integers(const std::string& path, const std::vector<long>& values) {
    integers(path, values, {values.size()});
  }
  void integers(const std::string& path, const std::vector<long>& values, const std::vector<hsize_t>& shape);
  void text(const std::string& path, std::string_view value);
  void texts(const std::string& path, const std::vector<std::string>& values);
  /// Bytes of any kind, a file within the file.
  void bytes(const std::string& path, std::string_view value);

  // Of groups that hold something; the formats of others ask for them:

  void attribute(const std::string& group, const std::string& name, long value);
  void attribute(const std::string& group, const std::string& name, const std::vector<long>& values);
  /// Of ASCII alone, and of fixed length.
  void attribute(const std::string& group, const std::string& name, std::string_view value);

  /// The bytes of the finished file.
  std::string bytes();

 private:
  void open_empty();
  void put_attribute(const std::string& group, const std::string& name, hid_t type,
                     const std::vector<hsize_t>& shape, const void* values);

  hid_t file_;
};

struct Numbers {
  std::vector<hsize_t> shape;
  std::vector<double> values;
};

/// What is in a file. The library, which trusts what it reads, reads it in a confined process: whatever the
/// file holds, it costs seconds and some memory at most, and then throws.
class Reader {
 public:
  /// From the bytes of a file. Throws if they are no HDF5 file.
  explicit Reader(const std::string& bytes);

  /// Whether there is a data set of that path; the group it is in may be missing too.
  bool has(const std::string& path) const;
  /// Numbers of any shape.
  Numbers numbers(const std::string& path) const;
  /// Numbers of the shape that is expected. Throws for another one before any memory is taken for it.
  std::vector<double> numbers(const std::string& path, const std::vector<hsize_t>& shape) const;
  double number(const std::string& path) const;
  long integer(const std::string& path) const;
  std::vector<long> integers(const std::string& path) const;
  std::string text(const std::string& path) const;
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
  mutable ConfinedProcess process_;
};

}  // namespace plumb::hdf5
