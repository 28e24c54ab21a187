#pragma once

#include "engine/kernels/element_force.h"
#include "engine/kernels/element_mass.h"
#include "engine/kernels/element_tangent.h"

// Four elements after the other along the chain. What two elements add to the node between them is summed
// while both are at hand: a node's numbers are written once. The last one to three elements fill the lanes up
// with copies of the last, whose results are not used.
namespace plumb::kernels {
namespace {

inline constexpr int per_node = 6;

/// Where the nodes of up to four elements start, counted from the first.
struct Offsets {
  int of[lanes];

  PLUMB_INLINE explicit Offsets(int count) {
    for (int lane = 0; lane < lanes; ++lane) of[lane] = per_node * (lane < count ? lane : count - 1);
  }
};

PLUMB_INLINE Nodes load_nodes(const double* q, const Offsets& offsets) {
  const LanesPair a = load_pair(q, offsets.of), b = load_pair(q + 2, offsets.of),
                  c = load_pair(q + 4, offsets.of);
  const double* next = q + per_node;
  const LanesPair d = load_pair(next, offsets.of), e = load_pair(next + 2, offsets.of),
                  f = load_pair(next + 4, offsets.of);
  return {{a.first, a.second, b.first},
          {b.second, c.first, c.second},
          {d.first, d.second, e.first},
          {e.second, f.first, f.second}};
}

/// Adds up and stores the numbers of each node, from results of up to four elements: `left` belongs to each
/// element's first node, `right` to its second. The last lane of `before` holds what belongs to the first
/// node from the element before it, and takes what belongs to the node after the last element.
PLUMB_INLINE void store_shared(const Lanes* left, const Lanes* right, int count, Lanes* before, double* to) {
  if (count == lanes) {
    for (int k = 0; k < per_node; k += 2) {
      store_pair(to + k, per_node, left[k] + moved_up(right[k], before[k]),
                 left[k + 1] + moved_up(right[k + 1], before[k + 1]));
      before[k] = right[k];
      before[k + 1] = right[k + 1];
    }
    return;
  }
  for (int k = 0; k < per_node; ++k) {
    double carry = before[k][lanes - 1];
    for (int lane = 0; lane < count; ++lane) {
      to[lane * per_node + k] = left[k][lane] + carry;
      carry = right[k][lane];
    }
    before[k] = all(carry);
  }
}

PLUMB_INLINE int first_unsound(const Mask& sound, int count) {
  for (int lane = 0; lane < count; ++lane)
    if (sound[lane] == 0) return lane;
  return -1;
}

template <bool green, bool full>
int chain_force(const ElementConstants& element, int elements, const double* q, double* f) {
  Lanes before[per_node] = {};
  int unsound = -1;
  const auto add = [&](int e, int count) __attribute__((always_inline)) {
    const Forces o = element_force<green, full>(element, load_nodes(q + per_node * e, Offsets(count)));
    const Mask sound = o.sound;
    if (unsound < 0 && (sound[0] & sound[1] & sound[2] & sound[3]) == 0) {
      const int lane = first_unsound(sound, count);
      if (lane >= 0) unsound = e + lane;
    }
    const Lanes left[per_node] = {o.r0.x, o.r0.y, o.r0.z, o.g0.x, o.g0.y, o.g0.z};
    const Lanes right[per_node] = {o.r1.x, o.r1.y, o.r1.z, o.g1.x, o.g1.y, o.g1.z};
    store_shared(left, right, count, before, f + per_node * e);
  };
  int e = 0;
  for (; e + lanes <= elements; e += lanes) add(e, lanes);
  if (e < elements) add(e, elements - e);
  for (int k = 0; k < per_node; ++k) f[per_node * elements + k] = before[k][lanes - 1];
  return unsound;
}

template <bool green, bool full>
void chain_energy(const ElementConstants& element, int elements, const double* q, double* axial,
                  double* bending) {
  Lanes stretching = {}, turning = {};
  int e = 0;
  for (; e + lanes <= elements; e += lanes) {
    const LanesPair o = element_energy<green, full>(element, load_nodes(q + per_node * e, Offsets(lanes)));
    stretching += o.first;
    turning += o.second;
  }
  *axial = sum(stretching);
  *bending = sum(turning);
  if (e == elements) return;
  const LanesPair o =
      element_energy<green, full>(element, load_nodes(q + per_node * e, Offsets(elements - e)));
  for (int lane = 0; lane < elements - e; ++lane) {
    *axial += o.first[lane];
    *bending += o.second[lane];
  }
}

/// The block columns of a long chain are in no cache when their turn comes: they are asked for this many
/// elements ahead, a share with each column of numbers, or waiting for them would take as long as all else.
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

template <bool green, bool full>
void chain_system(const ElementConstants& element, int elements, const double* q, double* block_columns) {
  constexpr int rows = 12;
  const ElementMass m(element);
  Lanes before[per_node][per_node] = {};  // to the diagonal block of a node, from the element before it
  double spare[lanes * block_column_size];
  for (int e = 0; e < elements; e += lanes) {
    const int count = elements - e < lanes ? elements - e : lanes;
    const Tangents o = element_tangent<green, full>(element, load_nodes(q + per_node * e, Offsets(count)));
    double* const place = block_columns + block_column_size * e;
    double* const to = count == lanes ? place : spare;
    Lanes own[per_node][per_node];
#pragma GCC unroll 6
    for (int j = 0; j < per_node; ++j) {
      constexpr int line = 8, lines = lanes * block_column_size / per_node / line;
      for (int k = 0; k < lines; ++k)
        __builtin_prefetch(place + block_column_size * elements_ahead + line * (lines * j + k), 1, 2);
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
      double* column = to + rows * j;
      store_four(column, own[j][0], own[j][1], own[j][2], own[j][3]);
      store_four(column + 4, own[j][4], own[j][5], below[0], below[1]);
      store_four(column + 8, below[2], below[3], below[4], below[5]);
    }
    if (count < lanes)
      __builtin_memcpy(place, spare, sizeof(double) * static_cast<unsigned>(block_column_size * count));
  }
  // The lanes left over hold copies of the last element, so that the last lane is always its.
  double* last = block_columns + block_column_size * elements;
  for (int j = 0; j < per_node; ++j) {
    for (int i = j; i < per_node; ++i) last[rows * j + i] = before[j][i][lanes - 1];
    for (int i = 0; i < per_node; ++i) last[rows * j + per_node + i] = 0;
  }
}

}  // namespace
}  // namespace plumb::kernels
