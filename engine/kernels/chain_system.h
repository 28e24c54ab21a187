#pragma once

#include "engine/kernels/chain.h"
#include "engine/kernels/element_mass.h"
#include "engine/kernels/element_tangent.h"
#include "engine/kernels/prefetch.h"

namespace plumb::kernels {
namespace {

/// Block columns are asked for this many elements ahead.
inline constexpr int elements_ahead = 4 * lanes;

/// Stores four numbers that lie side by side in the block columns of four nodes.
PLUMB_INLINE void store_four(double* to, const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6),
              ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6),
              cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  store_lanes(to, __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5));
  store_lanes(to + block_column_size, __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5));
  store_lanes(to + 2 * block_column_size, __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7));
  store_lanes(to + 3 * block_column_size, __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7));
}

/// The block columns of mass and stiffness of a chain, group after group of four elements; a last group of
/// fewer has its lanes filled up.
template <bool green, bool full>
class SystemChain {
 public:
  /// EA, EI and ρA of `element` are multiplied with the factors of stiffness and mass already.
  PLUMB_INLINE explicit SystemChain(const ElementConstants& element) : element_(element), mass_(element) {}

  /// Sets four block columns, those of the first nodes of the `count` elements whose nodes' coordinates are
  /// at `nodes`. `ask` is called six times in between.
  template <class Ask>
  PLUMB_INLINE void take(int count, const double* nodes, double* to, Ask ask) {
    const ElementMass& m = mass_;
    Lanes(&before)[per_node][per_node] = before_;
    const Tangents o = element_tangent<green, full>(element_, load_nodes(nodes, Offsets(count)));
    Lanes own[per_node][per_node];
#pragma GCC unroll 6
    for (int j = 0; j < per_node; ++j) {
      ask(j);
      const int c = j % 3;
      Lanes below[per_node];
#pragma GCC unroll 6
      for (int i = 0; i < per_node; ++i) {
        const int r = i % 3, here = 3 * c + r, there = 3 * r + c, symmetric = symmetric_place(r, c);
        const auto with = [&](Lanes x, double mass) { return r == c ? x + mass : x; };
        const auto mass_without = [&](double mass, Lanes x) { return r == c ? mass - x : -x; };
        if (i >= j) {
          Lanes left, right;
          if (i < 3) {
            left = right = with(o.dd.at[symmetric], m.rr);
          } else if (j < 3) {
            left = mass_without(m.rg, o.dg0.at[there]);
            right = with(o.dg1.at[there], -m.rg);
          } else {
            left = with(o.g0g0.at[symmetric], m.gg);
            right = with(o.g1g1.at[symmetric], m.gg);
          }
          own[j][i] = own[i][j] = left + moved_up(right, before[j][i]);
          before[j][i] = right;
        }
        if (i < 3)
          below[i] = j < 3 ? mass_without(m.r1r0, o.dd.at[symmetric]) : with(o.dg0.at[here], -m.g1r0);
        else
          below[i] = j < 3 ? mass_without(m.g1r0, o.dg1.at[there]) : with(o.g1g0.at[here], m.g1g0);
      }
      double* column = to + block_rows * j;
      store_four(column, own[j][0], own[j][1], own[j][2], own[j][3]);
      store_four(column + 4, own[j][4], own[j][5], below[0], below[1]);
      store_four(column + 8, below[2], below[3], below[4], below[5]);
    }
  }

  /// Sets the diagonal block of the last node; what is below it is 0.
  PLUMB_INLINE void end(double* last) const {
    // The lanes left over held copies of the last element, so that the last lane is always its.
    for (int j = 0; j < per_node; ++j) {
      for (int i = j; i < per_node; ++i) last[block_rows * j + i] = before_[j][i][lanes - 1];
      for (int i = 0; i < per_node; ++i) last[block_rows * j + per_node + i] = 0;
    }
  }

 private:
  const ElementConstants& element_;
  ElementMass mass_;
  Lanes before_[per_node][per_node] = {};  // to the diagonal block of a node, from the element before it
};

template <bool green, bool full>
void chain_system(const ElementConstants& element, int elements, const double* q, double* block_columns) {
  SystemChain<green, full> chain(element);
  double spare[lanes * block_column_size];
  for (int e = 0; e < elements; e += lanes) {
    const int count = elements - e < lanes ? elements - e : lanes;
    double* const place = block_columns + block_column_size * e;
    double* const to = count == lanes ? place : spare;
    const auto ask = [&](int j) __attribute__((always_inline)) {
      ask_for_share<lanes * block_column_size, per_node>(place + block_column_size * elements_ahead, j);
    };
    chain.take(count, q + per_node * e, to, ask);
    if (count < lanes)
      __builtin_memcpy(place, spare, sizeof(double) * static_cast<unsigned>(block_column_size * count));
  }
  chain.end(block_columns + block_column_size * elements);
}

}  // namespace
}  // namespace plumb::kernels
