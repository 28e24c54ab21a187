#include "engine/model/huge_array.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace plumb {

HugeArray::HugeArray(std::size_t size) {
  constexpr std::size_t page = 2 << 20, line = 64;
  const std::size_t bytes = size * sizeof(double);
  const std::size_t alignment = bytes >= page ? page : line;
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  data_.reset(static_cast<double*>(std::aligned_alloc(alignment, whole)));
  if (data_ == nullptr) throw std::bad_alloc();
  // A wish: without it the array is as good, if slower.
  if (alignment == page) madvise(data_.get(), whole, MADV_HUGEPAGE);
}

void HugeArray::Free::operator()(double* data) const {
  std::free(data);
}

}  // namespace plumb
