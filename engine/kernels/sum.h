#pragma once

#include <cassert>
#include <span>

namespace plumb {

/// first + Σ factors[i] · terms[i] of arrays of equal length, and where it goes. It holds no numbers of its
/// own: the arrays must outlive it. Built as it is written down, Sum(q).plus(h, v).plus(0.5 * h * h, a).
struct Sum {
  static constexpr int most = 9;  ///< terms

  template <class Array>
  explicit Sum(const Array& array) : first(array.data()) {}

  explicit Sum(const double* numbers) : first(numbers) {}

  /// Adds factor · array. At most `most` times.
  template <class Array>
  Sum& plus(double factor, const Array& array) {
    return plus(factor, array.data());
  }
  Sum& plus(double factor, const double* numbers) {
    assert(count < most);
    factors[count] = factor;
    terms[count++] = numbers;
    return *this;
  }

  /// Where the sum goes; the array must have its size already, and may be one that is added.
  template <class Array>
  Sum& into(Array& array) {
    result = array.data();
    return *this;
  }

  /// Alone, where several may be asked for.
  operator std::span<const Sum>() const { return {this, 1}; }

  const double* first;
  int count = 0;
  double factors[most];
  const double* terms[most];
  double* result = nullptr;
};

/// The coordinates at which accelerations are wanted, as a sum, and what is added up beside them. Where q has
/// a result it is kept. No result of q and `before` may be one of their terms, nor the acceleration one of
/// those; `after` may take it.
struct StageSums {
  const Sum& q;
  std::span<const Sum> before, after;
};

}  // namespace plumb
