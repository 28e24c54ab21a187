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

/// Adds up and stores the numbers from `first` (even) to per_node of each node, `stride` apart, from results
/// of up to four elements: `left` belongs to each element's first node, `right` to its second. The last lane
/// of `before` holds what belongs to the first node from the element before it, and takes what belongs to the
/// node after the last element.
PLUMB_INLINE void store_shared(const Lanes* left, const Lanes* right, int first, int count, Lanes* before,
                               double* to, int stride) {
  if (count == lanes) {
    for (int k = first; k < per_node; k += 2) {
      store_pair(to + k, stride, left[k] + moved_up(right[k], before[k]),
                 left[k + 1] + moved_up(right[k + 1], before[k + 1]));
      before[k] = right[k];
      before[k + 1] = right[k + 1];
    }
    return;
  }
  for (int k = first; k < per_node; ++k) {
    double carry = before[k][lanes - 1];
    for (int lane = 0; lane < count; ++lane) {
      to[lane * stride + k] = left[k][lane] + carry;
      carry = right[k][lane];
    }
    before[k] = all(carry);
  }
}

/// Stores six numbers of each element at its first node.
PLUMB_INLINE void store_own(const Lanes* numbers, int count, double* to, int stride) {
  for (int k = 0; k < per_node; k += 2) {
    if (count == lanes) {
      store_pair(to + k, stride, numbers[k], numbers[k + 1]);
    } else {
      for (int lane = 0; lane < count; ++lane) {
        to[stride * lane + k] = numbers[k][lane];
        to[stride * lane + k + 1] = numbers[k + 1][lane];
      }
    }
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
    store_shared(left, right, 0, count, before, f + per_node * e, per_node);
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

/// Puts block + s I at rows `row` … and columns `column` … of a 6 by 6 block held by columns.
PLUMB_INLINE void put(Lanes* to, int row, int column, const Block3& block, double s) {
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      to[6 * (column + j) + row + i] = i == j ? block.at[3 * j + i] + s : block.at[3 * j + i];
}

template <bool green, bool full>
void chain_system(const ElementConstants& element, int elements, const double* q, double* block_columns) {
  constexpr int rows = 12, block = 36;
  Lanes before[block] = {};
  const auto add = [&](int e, int count) __attribute__((always_inline)) {
    const Tangents o = element_tangent<green, full>(element, load_nodes(q + per_node * e, Offsets(count)));
    Lanes left[block], right[block], below[block];
    const Block3 dd = o.dd.full(), minus_dg0 = -1.0 * o.dg0;
    const ElementMass m(element);
    put(left, 0, 0, dd, m.rr);
    put(left, 3, 0, transposed(minus_dg0), m.rg);
    put(left, 0, 3, minus_dg0, m.rg);
    put(left, 3, 3, o.g0g0.full(), m.gg);
    put(right, 0, 0, dd, m.rr);
    put(right, 3, 0, transposed(o.dg1), -m.rg);
    put(right, 0, 3, o.dg1, -m.rg);
    put(right, 3, 3, o.g1g1.full(), m.gg);
    put(below, 0, 0, -1.0 * dd, m.r1r0);
    put(below, 3, 0, -1.0 * transposed(o.dg1), m.g1r0);
    put(below, 0, 3, o.dg0, -m.g1r0);
    put(below, 3, 3, o.g1g0, m.g1g0);
    double* to = block_columns + block_column_size * e;
    for (int column = 0; column < per_node; ++column) {
      const int first =
          column / 2 * 2;  // the rows above the diagonal are not wanted, but for what makes a pair
      store_shared(left + per_node * column, right + per_node * column, first, count,
                   before + per_node * column, to + rows * column, block_column_size);
      store_own(below + per_node * column, count, to + rows * column + per_node, block_column_size);
    }
  };
  int e = 0;
  for (; e + lanes <= elements; e += lanes) add(e, lanes);
  if (e < elements) add(e, elements - e);
  double* last = block_columns + block_column_size * elements;
  for (int column = 0; column < per_node; ++column)
    for (int k = 0; k < per_node; ++k) {
      last[rows * column + k] = before[per_node * column + k][lanes - 1];
      last[rows * column + per_node + k] = 0;
    }
}

}  // namespace
}  // namespace plumb::kernels
