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

void mass_solve(int nodes, const MassFactors& factors, double* x) {
  const int middle = nodes / 2;
  const auto at = [&](int node) { return x + 6 * node; };
  const auto of_left = [&](int node) -> const MassFactor& {
    return factors.from_left[node < factors.settled_left ? node : factors.settled_left - 1];
  };
  const auto of_right = [&](int node) -> const MassFactor& {
    const int place = nodes - 1 - node;
    return factors.from_right[place < factors.settled_right ? place : factors.settled_right - 1];
  };
  int left = 0, right = nodes - 1;
  NodeVectors from_left = load_node(at(left)), from_right = load_node(at(right));
  const auto step_left = [&] {
    store_node(at(left), from_left);
    from_left = inwards(of_left(left), from_left, load_node(at(left + 1)));
    ++left;
  };
  const auto step_right = [&] {
    store_node(at(right), from_right);
    from_right = inwards(of_right(right), from_right, load_node(at(right - 1)));
    --right;
  };
  // The chains end one node before the middle, which both take something off.
  while (left < middle - 1 && right > middle + 1) {
    step_left();
    step_right();
  }
  while (left < middle - 1) step_left();
  while (right > middle + 1) step_right();
  NodeVectors center = load_node(at(middle));
  center = inwards(of_left(left), from_left, center);
  if (middle + 1 < nodes) center = inwards(of_right(right), from_right, center);
  center = scaled(*factors.middle, center);
  store_node(at(middle), center);

  NodeVectors to_left = center, to_right = center;
  const auto back_left = [&](const NodeVectors& own) {
    to_left = outwards(of_left(left), own, to_left);
    store_node(at(left), to_left);
    --left;
  };
  const auto back_right = [&](const NodeVectors& own) {
    to_right = outwards(of_right(right), own, to_right);
    store_node(at(right), to_right);
    ++right;
  };
  back_left(from_left);
  if (middle + 1 < nodes) back_right(from_right);
  // Without a right half the chain began at the middle node itself.
  if (middle + 1 == nodes) right = nodes;
  while (left >= 0 && right < nodes) {
    back_left(load_node(at(left)));
    back_right(load_node(at(right)));
  }
  while (left >= 0) back_left(load_node(at(left)));
  while (right < nodes) back_right(load_node(at(right)));
}

/// Visits M v node by node: `take(node, v of the node, M v of the node)`.
template <class Take>
PLUMB_INLINE void for_each_momentum(const ElementConstants& c, int elements, const double* v, Take take) {
  const ElementMass m(c);
  NodeVectors before{}, own = load_node(v);
  for (int node = 0; node <= elements; ++node) {
    NodeVectors p{}, after{};
    if (node > 0) {
      p.r = m.r1r0 * before.r - m.g1r0 * before.g + m.rr * own.r - m.rg * own.g;
      p.g = m.gg * own.g - m.rg * own.r + m.g1r0 * before.r + m.g1g0 * before.g;
    }
    if (node < elements) {
      after = load_node(v + 6 * (node + 1));
      p.r += m.rr * own.r + m.rg * own.g + m.r1r0 * after.r + m.g1r0 * after.g;
      p.g += m.rg * own.r + m.gg * own.g - m.g1r0 * after.r + m.g1g0 * after.g;
    }
    take(node, own, p);
    before = own;
    own = after;
  }
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
