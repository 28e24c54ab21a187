#pragma once

#include "engine/kernels/chain.h"
#include "engine/kernels/kernels.h"

// How nodes have turned since a matrix was made. The stiffness of a cable turns with it and its mass, a
// scalar times the identity, does not feel that, so that with the turns R of all nodes R A⁻¹ Rᵀ of an old
// matrix A is nearer to the inverse of the present one than A⁻¹ is.
namespace plumb::kernels {
namespace {

/// Numbers of a group of four nodes: directions a and b, k.
inline constexpr int turn_group_size = 7 * lanes;

/// Six numbers a node of up to four nodes, one node a lane; left over lanes are copies of the last.
struct NodeLanes {
  Lanes3 r, g;
};

PLUMB_INLINE NodeLanes load_node_lanes(const double* p, int count) {
  const Offsets offsets(count);
  const LanesPair a = load_pair(p, offsets.of), b = load_pair(p + 2, offsets.of),
                  c = load_pair(p + 4, offsets.of);
  return {{a.first, a.second, b.first}, {b.second, c.first, c.second}};
}

PLUMB_INLINE void store_node_lanes(const NodeLanes& x, int count, double* p) {
  if (count == lanes) {
    store_pair(p, per_node, x.r.x, x.r.y);
    store_pair(p + 2, per_node, x.r.z, x.g.x);
    store_pair(p + 4, per_node, x.g.y, x.g.z);
    return;
  }
  for (int lane = 0; lane < count; ++lane, p += per_node) {
    p[0] = x.r.x[lane];
    p[1] = x.r.y[lane];
    p[2] = x.r.z[lane];
    p[3] = x.g.x[lane];
    p[4] = x.g.y[lane];
    p[5] = x.g.z[lane];
  }
}

/// The shortest rotations R of up to four nodes from a direction a to a direction b: with s = a + b and
/// k = 1/(1 + a·b),
///   R x = x − k s (s·x) + 2 b (a·x),  and Rᵀ with a and b exchanged.
class GroupTurn {
 public:
  /// Keeps a, the directions of the slopes of `count` nodes, whose six numbers each are at `nodes`.
  PLUMB_INLINE static void mark(int count, const double* nodes, double* turns) {
    store(directions(count, nodes), turns);
  }
  /// With the a that were kept, b the directions of slopes, which are kept too. None where a and b are nearly
  /// opposite, where there is no shortest one.
  PLUMB_INLINE static GroupTurn to_slopes(int count, const double* nodes, double* turns) {
    constexpr double nearly_opposite = -0.9;
    GroupTurn made(load(turns), directions(count, nodes), Lanes{});
    const Lanes along = dot(made.a_, made.b_);
    const Mask is_near = along > all(nearly_opposite);  // false for what is not a number
    made.b_ = {is_near ? made.b_.x : made.a_.x, is_near ? made.b_.y : made.a_.y,
               is_near ? made.b_.z : made.a_.z};
    made.k_ = 1 / (1 + (is_near ? along : all(1)));
    store(made.b_, turns + 3 * lanes);
    store_lanes(turns + 6 * lanes, made.k_);
    return made;
  }
  /// As they were kept.
  PLUMB_INLINE static GroupTurn kept(const double* turns) {
    return GroupTurn(load(turns), load(turns + 3 * lanes), load_lanes(turns + 6 * lanes));
  }

  /// R of six numbers a node.
  PLUMB_INLINE void turn(int count, double* x) const {
    const NodeLanes old = load_node_lanes(x, count);
    store_node_lanes({turned(old.r, a_, b_), turned(old.g, a_, b_)}, count, x);
  }
  /// Rᵀ of them.
  PLUMB_INLINE void turn_back(int count, double* x) const {
    const NodeLanes old = load_node_lanes(x, count);
    store_node_lanes({turned(old.r, b_, a_), turned(old.g, b_, a_)}, count, x);
  }

 private:
  PLUMB_INLINE GroupTurn(const Lanes3& a, const Lanes3& b, Lanes k) : a_(a), b_(b), k_(k) {}

  PLUMB_INLINE static Lanes3 directions(int count, const double* nodes) {
    const Lanes3 g = load_node_lanes(nodes, count).g;
    const Lanes square = dot(g, g), zero = {};
    // Where there is none, any direction will do that stays.
    const Mask is_some = square > zero;
    const Lanes inverse = 1 / root(is_some ? square : all(1));
    return {is_some ? inverse * g.x : all(1), is_some ? inverse * g.y : zero, is_some ? inverse * g.z : zero};
  }
  PLUMB_INLINE static Lanes3 load(const double* p) {
    return {load_lanes(p), load_lanes(p + lanes), load_lanes(p + 2 * lanes)};
  }
  PLUMB_INLINE static void store(const Lanes3& x, double* p) {
    store_lanes(p, x.x);
    store_lanes(p + lanes, x.y);
    store_lanes(p + 2 * lanes, x.z);
  }
  PLUMB_INLINE Lanes3 turned(const Lanes3& x, const Lanes3& from, const Lanes3& to) const {
    const Lanes3 s = from + to;
    return x - (k_ * dot(s, x)) * s + (2 * dot(from, x)) * to;
  }

  Lanes3 a_, b_;
  Lanes k_;
};

/// Where the turns of a group of nodes are. The last node of a chain makes a group of its own.
PLUMB_INLINE int turn_group(int first_node) {
  return turn_group_size * (first_node / lanes);
}
PLUMB_INLINE int last_turn_group(int elements) {
  return turn_group(elements + lanes - 1);
}

/// Calls `take(first node, count, where its turns are)` for all groups of a chain.
template <class Take>
PLUMB_INLINE void for_each_turn_group(int elements, Take take) {
  for_each_group(elements, [&](int e, int count) { take(e, count, turn_group(e)); });
  take(elements, 1, last_turn_group(elements));
}

void mark_slopes(int nodes, const double* q, double* turns) {
  for_each_turn_group(nodes - 1, [&](int node, int count, int group) {
    GroupTurn::mark(count, q + per_node * node, turns + group);
  });
}

void turn_back(int nodes, const double* q, double* turns, double* x) {
  for_each_turn_group(nodes - 1, [&](int node, int count, int group) {
    GroupTurn::to_slopes(count, q + per_node * node, turns + group).turn_back(count, x + per_node * node);
  });
}

void turn(int nodes, const double* turns, double* x) {
  for_each_turn_group(nodes - 1, [&](int node, int count, int group) {
    GroupTurn::kept(turns + group).turn(count, x + per_node * node);
  });
}

}  // namespace
}  // namespace plumb::kernels
