#pragma once

#include "engine/kernels/element_mass.h"
#include "engine/kernels/kernels.h"
#include "engine/kernels/lanes.h"

// The mass matrix is a scalar band matrix m times the 3 by 3 identity: 2 by 2 blocks over (r, g) of a node,
// for three components at once. Its L D Lᵀ runs from both ends towards the middle node, so that two chains of
// operations that have to wait for one another go side by side; what goes from node to node stays in
// registers.
namespace plumb::kernels {
namespace {

/// Position and slope vector of a node; the fourth lane is of no meaning.
struct NodeVectors {
  Lanes r, g;
};

PLUMB_INLINE NodeVectors load_node(const double* p) {
  // Sixteen bytes at a time, as the forces are stored, so that what was just stored can be forwarded.
  const Pair top = load_two(p), middle = load_two(p + 2), back = load_two(p + 4);
  const Lanes front = __builtin_shufflevector(top, middle, 0, 1, 2, 3);
  return {front, __builtin_shufflevector(front, __builtin_shufflevector(back, back, 0, 1, 0, 1), 3, 4, 5, 3)};
}
PLUMB_INLINE void store_node(double* p, const NodeVectors& x) {
  store_lanes(p, __builtin_shufflevector(x.r, x.g, 0, 1, 2, 4));
  store_two(p + 4, __builtin_shufflevector(x.g, x.g, 1, 2));
}

/// x of the neighbour without what the node takes off it.
PLUMB_INLINE NodeVectors inwards(const MassFactor& f, const NodeVectors& own, const NodeVectors& neighbour) {
  return {neighbour.r - f.rr * own.r - f.rg * own.g, neighbour.g - f.gr * own.r - f.gg * own.g};
}
PLUMB_INLINE NodeVectors scaled(const MassFactor& f, const NodeVectors& x) {
  return {f.inverse_rr * x.r + f.inverse_rg * x.g, f.inverse_rg * x.r + f.inverse_gg * x.g};
}
PLUMB_INLINE NodeVectors outwards(const MassFactor& f, const NodeVectors& own, const NodeVectors& neighbour) {
  const NodeVectors s = scaled(f, own);
  return {s.r - f.rr * neighbour.r - f.gr * neighbour.g, s.g - f.rg * neighbour.r - f.gg * neighbour.g};
}

/// x := M⁻¹ x, node after node from both ends to the middle, and back as far as is asked each time, so that
/// what a node gives can be used while it is at hand.
class MassSweep {
 public:
  PLUMB_INLINE MassSweep(int nodes, const MassFactors& factors, double* x)
      : nodes_(nodes),
        middle_(nodes / 2),
        factors_(factors),
        x_(x),
        right_(nodes - 1),
        from_left_(load_node(at(0))),
        from_right_(load_node(at(right_))) {}

  /// To the middle, where the solution begins.
  PLUMB_INLINE void inwards_to_middle() {
    // The chains end one node before the middle, which both take something off.
    while (left_ < middle_ - 1 && right_ > middle_ + 1) {
      step_left();
      step_right();
    }
    while (left_ < middle_ - 1) step_left();
    while (right_ > middle_ + 1) step_right();
    const bool both = middle_ + 1 < nodes_;
    NodeVectors center = load_node(at(middle_));
    center = inwards(of_left(left_), from_left_, center);
    if (both) center = inwards(of_right(right_), from_right_, center);
    center = scaled(*factors_.middle, center);
    store_node(at(middle_), center);
    to_left_ = to_right_ = center;
    back_left(from_left_);
    // Without a right half the chain began at the middle node itself.
    right_ = both ? right_ : nodes_;
    if (both) back_right(from_right_);
  }

  /// Goes outwards until the nodes from `first` to `last` are solved for.
  PLUMB_INLINE void outwards_to(int first, int last) {
    while (left_ >= first && right_ <= last) {
      back_left(load_node(at(left_)));
      back_right(load_node(at(right_)));
    }
    while (left_ >= first) back_left(load_node(at(left_)));
    while (right_ <= last) back_right(load_node(at(right_)));
  }

 private:
  PLUMB_INLINE double* at(int node) const { return x_ + 6 * node; }
  PLUMB_INLINE const MassFactor& of_left(int node) const {
    return factors_.from_left[node < factors_.settled_left ? node : factors_.settled_left - 1];
  }
  PLUMB_INLINE const MassFactor& of_right(int node) const {
    const int place = nodes_ - 1 - node;
    return factors_.from_right[place < factors_.settled_right ? place : factors_.settled_right - 1];
  }
  PLUMB_INLINE void step_left() {
    store_node(at(left_), from_left_);
    from_left_ = inwards(of_left(left_), from_left_, load_node(at(left_ + 1)));
    ++left_;
  }
  PLUMB_INLINE void step_right() {
    store_node(at(right_), from_right_);
    from_right_ = inwards(of_right(right_), from_right_, load_node(at(right_ - 1)));
    --right_;
  }
  PLUMB_INLINE void back_left(const NodeVectors& own) {
    to_left_ = outwards(of_left(left_), own, to_left_);
    store_node(at(left_), to_left_);
    --left_;
  }
  PLUMB_INLINE void back_right(const NodeVectors& own) {
    to_right_ = outwards(of_right(right_), own, to_right_);
    store_node(at(right_), to_right_);
    ++right_;
  }

  int nodes_, middle_;
  const MassFactors& factors_;
  double* x_;
  int left_ = 0, right_;  // the nodes that come next
  NodeVectors from_left_, from_right_;
  NodeVectors to_left_, to_right_;
};

void mass_solve(int nodes, const MassFactors& factors, double* x) {
  MassSweep sweep(nodes, factors, x);
  sweep.inwards_to_middle();
  sweep.outwards_to(0, nodes - 1);
}

/// M v node by node.
class Momentum {
 public:
  /// `first`: v of the first node.
  PLUMB_INLINE Momentum(const ElementConstants& c, const NodeVectors& first) : m_(c), own_(first) {}

  /// v of the node that comes next in `take`.
  PLUMB_INLINE const NodeVectors& own() const { return own_; }

  /// M v of the next node, with v of the node behind it.
  PLUMB_INLINE NodeVectors take(const NodeVectors& after) {
    NodeVectors p = take_last();
    p.r += m_.rr * own_.r + m_.rg * own_.g + m_.r1r0 * after.r + m_.g1r0 * after.g;
    p.g += m_.rg * own_.r + m_.gg * own_.g - m_.g1r0 * after.r + m_.g1g0 * after.g;
    before_ = own_;
    own_ = after;
    first_ = false;
    return p;
  }

  /// M v of the last node.
  PLUMB_INLINE NodeVectors take_last() const {
    if (first_) return NodeVectors{};
    return {m_.r1r0 * before_.r - m_.g1r0 * before_.g + m_.rr * own_.r - m_.rg * own_.g,
            m_.gg * own_.g - m_.rg * own_.r + m_.g1r0 * before_.r + m_.g1g0 * before_.g};
  }

 private:
  ElementMass m_;
  NodeVectors before_{}, own_;
  bool first_ = true;
};

/// Visits M v: `take(node, v of the node, M v of the node)`.
template <class Take>
PLUMB_INLINE void for_each_momentum(const ElementConstants& c, int elements, const double* v, Take take) {
  Momentum momentum(c, load_node(v));
  for (int node = 0; node < elements; ++node) {
    const NodeVectors own = momentum.own();
    take(node, own, momentum.take(load_node(v + 6 * (node + 1))));
  }
  take(elements, momentum.own(), momentum.take_last());
}

void mass_multiply(const ElementConstants& c, int elements, const double* v, double* y) {
  for_each_momentum(c, elements, v,
                    [&](int node, const NodeVectors&, const NodeVectors& p) { store_node(y + 6 * node, p); });
}

double kinetic_energy(const ElementConstants& c, int elements, const double* v) {
  Lanes twice = {};
  for_each_momentum(c, elements, v, [&](int, const NodeVectors& own, const NodeVectors& p) {
    twice += own.r * p.r + own.g * p.g;
  });
  return 0.5 * ((twice[0] + twice[1]) + twice[2]);
}

}  // namespace
}  // namespace plumb::kernels
