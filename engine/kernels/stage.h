#pragma once

#include "engine/kernels/block_elimination.h"
#include "engine/kernels/chain_system.h"
#include "engine/kernels/mass_band.h"
#include "engine/kernels/summed_nodes.h"

namespace plumb::kernels {
namespace {

/// Factors are asked for this many nodes ahead.
inline constexpr int nodes_ahead = 12;

/// The matrix of a chain, of which no more is made than is eliminated at once.
template <bool green, bool full>
class SystemElimination {
 public:
  /// EA, EI and ρA of `scaled` are multiplied with the factors of stiffness and mass already.
  PLUMB_INLINE SystemElimination(const ElementConstants& scaled, int elements, const HeldEnds& ends,
                                 double* factors)
      : chain_(scaled), ends_(ends), elements_(elements), factors_(factors) {}

  /// Takes the `count` elements from `e` on, whose nodes' coordinates are at `nodes`, and eliminates the
  /// first node of each; with the last element, the last node too. Returns the node that ended it, or -1. Its
  /// code is long, and a call is nothing beside what it does.
  [[gnu::noinline]] int take(int e, int count, const double* nodes) {
    // A share with each column.
    const auto ask = [&](int share) __attribute__((always_inline)) {
      const int node = e + nodes_ahead;
      ask_for_share<lanes * block_size, per_node>(multiplier_of(node, factors_), share);
      ask_for_share<lanes * symmetric_size, per_node>(inverse_of(node, elements_ + 1, factors_), share);
    };
    chain_.take(count, nodes, columns_, ask);
    if (e == 0) ends_.hold_first(columns_);
    const bool ends = e + count == elements_;
    if (ends) {
      double* last = columns_ + block_column_size * count;
      chain_.end(last);
      ends_.hold_last(last - block_column_size, last);
    }
    for (int i = 0; i < count + (ends ? 1 : 0); ++i)
      if (!elimination_.eliminate(columns_ + block_column_size * i, multiplier_of(e + i, factors_),
                                  inverse_of(e + i, elements_ + 1, factors_)))
        return e + i;
    return -1;
  }

 private:
  SystemChain<green, full> chain_;
  BlockElimination elimination_;
  const HeldEnds& ends_;
  int elements_;
  double* factors_;
  double columns_[block_column_size * (lanes + 1)];
};

template <bool green, bool full>
int chain_factors(const ElementConstants& scaled, int elements, const HeldEnds& ends, const double* q,
                  double* factors) {
  SystemElimination<green, full> system(scaled, elements, ends, factors);
  for (int e = 0; e < elements; e += lanes) {
    const int count = elements - e < lanes ? elements - e : lanes;
    if (const int node = system.take(e, count, q + per_node * e); node >= 0) return node;
  }
  return -1;
}

PLUMB_INLINE Lanes magnitude(Lanes x) {
  return larger(x, -x);
}

/// x := from + change from the last node to the first, with what the way there has left in x.
PLUMB_INLINE void substitute_back(int nodes, const double* factors, const Scaled& from, double* x,
                                  StageCorrection& result) {
  Lanes greatest = {}, greatest_end = {}, zero = {};
  Six next{};
  for (int node = nodes - 1; node >= 0; --node) {
    double* const at = x + per_node * node;
    const int ahead = node - nodes_ahead;
    ask_for<block_size>(multiplier_of(ahead, factors));
    ask_for<per_node>(x + per_node * ahead);
    ask_for<per_node>(from.numbers + per_node * ahead);
    Six own = load_six(at);
    if (node < nodes - 1) own = own - multiply_transposed(multiplier_of(node, factors), next);
    const Six old = load_six(from.numbers + per_node * node);
    store_six(at, Six{from.factor * old.a, from.factor * old.b} + own);
    const Lanes end = __builtin_shufflevector(own.b, own.b, 0, 1, 0, 1);
    greatest = larger(magnitude(own.a), greatest);
    greatest_end = larger(magnitude(end), greatest_end);
    zero += 0 * own.a + 0 * end;  // not a number, if one is none
    next = own;
  }
  const auto of = [](double a, double b) { return a > b ? a : b; };
  result.position = of(of(greatest[0], greatest[1]), greatest[2]);
  result.slope = of(of(greatest[3], greatest_end[0]), greatest_end[1]);
  result.finite = sum(zero) == 0;
}

/// One correction of Newton's iteration: on the way to the last node all that a node's equations need is
/// computed, with the matrix too where it is renewed, and on the way back the corrections are added.
template <bool green, bool full>
StageCorrection chain_correction(const ElementConstants& element, const ElementConstants& scaled, bool renews,
                                 int elements, const HeldEnds& ends, const NodeForces& loads,
                                 const StageTerms& terms, double* factors, double* x) {
  const int nodes = elements + 1;
  StageCorrection result;
  const Sum point_sum = terms.point(), rates_sum = terms.accelerations();
  SummedNodes point(point_sum), rates(rates_sum);
  ForceChain<green, full> forces(element);
  SystemElimination<green, full> system(scaled, elements, ends, factors);
  ForwardSubstitution forward;
  Momentum momentum(element, NodeVectors{});
  double f[per_node * (lanes + 1)];
  const NodeForce* load = loads.begin();

  const auto take_node = [&](int node, double* force, const NodeVectors& inertia) {
    Six b = load_six(force);
    if (load != loads.end() && load->node == node) b = b + load_six(load++->force);
    b = {terms.force * b.a, terms.force * b.b};
    if (terms.known.numbers != nullptr) {
      const Six known = load_six(terms.known.numbers + per_node * node);
      b = b + Six{terms.known.factor * known.a, terms.known.factor * known.b};
    }
    b = b - Six{terms.mass * __builtin_shufflevector(inertia.r, inertia.g, 0, 1, 2, 4),
                terms.mass * __builtin_shufflevector(inertia.g, inertia.g, 1, 2)};
    if (node == 0 || node == elements) {
      store_six(force, b);
      ends.hold(node != 0, force);
      b = load_six(force);
    }
    if (!renews) {
      const int ahead = node + nodes_ahead;
      ask_for<block_size>(multiplier_of(ahead, factors));
      ask_for<symmetric_size>(inverse_of(ahead, nodes, factors));
      ask_for<per_node>(x + per_node * ahead);
    }
    store_six(x + per_node * node,
              forward.take(multiplier_of(node, factors), inverse_of(node, nodes, factors), b));
  };
  const auto take_group = [&](int e, int count) __attribute__((always_inline)) {
    if (result.singular >= 0) return;
    const double* at = point(e, count);
    forces.take(e, count, at, f);
    if (renews) {
      result.singular = system.take(e, count, at);
      if (result.singular >= 0) return;
    }
    const double* rate = rates(e, count);
    if (e == 0) momentum = Momentum(element, load_node(rate));
    for (int i = 0; i < count; ++i)
      take_node(e + i, f + per_node * i, momentum.take(load_node(rate + per_node * (i + 1))));
  };
  for_each_group(elements, take_group);
  result.unsound = forces.unsound();
  if (result.unsound >= 0 || result.singular >= 0) return result;
  forces.end(f);
  take_node(elements, f, momentum.take_last());
  substitute_back(nodes, factors, terms.from, x, result);
  return result;
}

}  // namespace
}  // namespace plumb::kernels
