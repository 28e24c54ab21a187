#pragma once

#include "engine/kernels/element_force.h"

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

/// The forces of a chain, group after group of up to four elements.
template <bool green, bool full>
class ForceChain {
 public:
  PLUMB_INLINE explicit ForceChain(const ElementConstants& element) : element_(element) {}

  /// Takes the `count` elements from `e` on, whose nodes' coordinates are at `nodes`, and sets the forces on
  /// the first nodes of each. All groups but the last are of four elements.
  PLUMB_INLINE void take(int e, int count, const double* nodes, double* f) {
    const Forces o = element_force<green, full>(element_, load_nodes(nodes, Offsets(count)));
    const Mask sound = o.sound;
    if (unsound_ < 0 && (sound[0] & sound[1] & sound[2] & sound[3]) == 0) {
      const int lane = first_unsound(sound, count);
      if (lane >= 0) unsound_ = e + lane;
    }
    const Lanes left[per_node] = {o.r0.x, o.r0.y, o.r0.z, o.g0.x, o.g0.y, o.g0.z};
    const Lanes right[per_node] = {o.r1.x, o.r1.y, o.r1.z, o.g1.x, o.g1.y, o.g1.z};
    store_shared(left, right, count, before_, f);
  }

  /// Sets the forces on the last node.
  PLUMB_INLINE void end(double* f) const {
    for (int k = 0; k < per_node; ++k) f[k] = before_[k][lanes - 1];
  }

  /// The first element with a collapsed slope; -1: none.
  PLUMB_INLINE int unsound() const { return unsound_; }

 private:
  const ElementConstants& element_;
  Lanes before_[per_node] = {};
  int unsound_ = -1;
};

/// Calls `take(first element, count)` for groups of four elements and for what is left over.
template <class Take>
PLUMB_INLINE void for_each_group(int elements, Take take) {
  int e = 0;
  for (; e + lanes <= elements; e += lanes) take(e, lanes);
  if (e < elements) take(e, elements - e);
}

/// `nodes(e, count)` gives the coordinates of `count` elements from `e` on; it is asked in the order of the
/// chain.
template <bool green, bool full, class NodeSource>
PLUMB_INLINE int chain_force(const ElementConstants& element, int elements, NodeSource&& nodes, double* f) {
  ForceChain<green, full> chain(element);
  for_each_group(
      elements, [&](int e, int count) __attribute__((always_inline)) {
        chain.take(e, count, nodes(e, count), f + per_node * e);
      });
  chain.end(f + per_node * elements);
  return chain.unsound();
}

template <bool green, bool full>
int chain_force(const ElementConstants& element, int elements, const double* q, double* f) {
  return chain_force<green, full>(
      element, elements, [q](int e, int) __attribute__((always_inline)) { return q + per_node * e; }, f);
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

}  // namespace
}  // namespace plumb::kernels
