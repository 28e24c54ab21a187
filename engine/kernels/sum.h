#pragma once

#include <cassert>
#include <cstddef>

namespace plumb {

// Always inlined: the kernels, which are built for other instruction sets than the rest, use these too.
#define PLUMB_ALWAYS_INLINE [[gnu::always_inline]] inline

/// first + Σ factors[i] · terms[i] of arrays of equal length, 6 numbers a node, and where it goes. It holds
/// no numbers of its own: the arrays must have their sizes already and outlive it. Built as it is written
/// down, Sum(q).plus(h, v).plus(0.5 * h * h, a).
struct Sum {
  static constexpr int most = 9;  ///< terms

  template <class Array>
  PLUMB_ALWAYS_INLINE explicit Sum(const Array& array) : first(array.data()) {}
  PLUMB_ALWAYS_INLINE explicit Sum(const double* numbers) : first(numbers) {}

  /// Adds factor · array. At most `most` times.
  template <class Array>
  PLUMB_ALWAYS_INLINE Sum& plus(double factor, const Array& array) {
    return plus(factor, array.data());
  }
  PLUMB_ALWAYS_INLINE Sum& plus(double factor, const double* numbers) {
    assert(count < most);
    factors[count] = factor;
    terms[count++] = numbers;
    return *this;
  }

  /// Where the sum goes.
  template <class Array>
  PLUMB_ALWAYS_INLINE Sum& into(Array& array) {
    result = array.data();
    return *this;
  }

  const double* first;
  int count = 0;
  double factors[most];
  const double* terms[most];
  double* result = nullptr;
};

/// Some sums, one after the other.
struct Sums {
  const Sum* first = nullptr;
  int count = 0;

  Sums() = default;
  /// Of one alone.
  Sums(const Sum& sum) : first(&sum), count(1) {}
  Sums(const Sum* sums, std::size_t size) : first(sums), count(static_cast<int>(size)) {}

  PLUMB_ALWAYS_INLINE const Sum* begin() const { return first; }
  PLUMB_ALWAYS_INLINE const Sum* end() const { return first + count; }
};

/// The coordinates at which accelerations are wanted, as a sum, and what is added up beside them. Where q has
/// a result it is kept. No result of q and `before` may be one of their terms, nor the acceleration one of
/// those; `after` may take it. All of `before` and `after` have results.
struct StageSums {
  const Sum& q;
  Sums before, after;
};

}  // namespace plumb
