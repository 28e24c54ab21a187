#pragma once

#include <cstddef>
#include <memory>

namespace plumb {

/// An array of numbers that may be many megabytes, on huge pages where the system has them: what is gone
/// through from end to end else waits for a new page every few nodes. The numbers are not set.
class HugeArray {
 public:
  /// Of no numbers.
  HugeArray() = default;
  /// Throws std::bad_alloc.
  explicit HugeArray(std::size_t size);

  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(double* data) const;
  };
  std::unique_ptr<double, Free> data_;
};

}  // namespace plumb
