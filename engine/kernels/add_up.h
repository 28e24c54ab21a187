#pragma once

#include "engine/kernels/lanes.h"
#include "engine/kernels/sum.h"

namespace plumb::kernels {
namespace {

/// The sum of a number of terms that is known, so that their factors stay in registers, over the nodes from
/// `from` to before `to` into `result`, which holds the first of them.
template <int count>
void add_up_terms(const Sum& sum, int from, int to, double* result) {
  constexpr int per_node = 6, two_nodes = 2 * per_node;
  Lanes factor[count + 1];
  const double* term[count + 1];
#pragma GCC unroll 9
  for (int k = 0; k < count; ++k) {
    factor[k] = all(sum.factors[k]);
    term[k] = sum.terms[k] + per_node * from;
  }
  const double* first = sum.first + per_node * from;
  const int size = per_node * (to - from);
  int i = 0;
  for (; i + two_nodes <= size; i += two_nodes) {
    Lanes a = load_lanes(first + i), b = load_lanes(first + i + 4), c = load_lanes(first + i + 8);
#pragma GCC unroll 9
    for (int k = 0; k < count; ++k) {
      a += factor[k] * load_lanes(term[k] + i);
      b += factor[k] * load_lanes(term[k] + i + 4);
      c += factor[k] * load_lanes(term[k] + i + 8);
    }
    store_lanes(result + i, a);
    store_lanes(result + i + 4, b);
    store_lanes(result + i + 8, c);
  }
  if (i == size) return;
  Lanes a = load_lanes(first + i);
  Pair b = load_two(first + i + 4);
#pragma GCC unroll 9
  for (int k = 0; k < count; ++k) {
    a += factor[k] * load_lanes(term[k] + i);
    b += __builtin_shufflevector(factor[k], factor[k], 0, 1) * load_two(term[k] + i + 4);
  }
  store_lanes(result + i, a);
  store_two(result + i + 4, b);
}

/// The sum over the nodes from `from` to before `to`, to `result`.
PLUMB_INLINE void add_up(const Sum& sum, int from, int to, double* result) {
  // Called by pointers, as the compiler would otherwise merge them and save registers for the largest.
  static constexpr decltype(&add_up_terms<1>) of_count[] = {
      add_up_terms<0>, add_up_terms<1>, add_up_terms<2>, add_up_terms<3>, add_up_terms<4>,
      add_up_terms<5>, add_up_terms<6>, add_up_terms<7>, add_up_terms<8>, add_up_terms<9>};
  static_assert(sizeof(of_count) / sizeof(of_count[0]) == Sum::most + 1);
  of_count[sum.count](sum, from, to, result);
}

/// To where its result goes.
PLUMB_INLINE void add_up(const Sum& sum, int from, int to) {
  add_up(sum, from, to, sum.result + 6 * from);
}

}  // namespace
}  // namespace plumb::kernels
