#pragma once

#include "engine/kernels/block_elimination.h"
#include "engine/kernels/chain_system.h"
#include "engine/kernels/mass_band.h"
#include "engine/kernels/node_turn.h"
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

/// x := from + change from the last node to the first, with what the way there has left in x and the turns
/// that it has kept, unless there are none.
PLUMB_INLINE void substitute_back(int nodes, const double* factors, const double* turns, const Scaled& from,
                                  double* x, StageCorrection& result) {
  Lanes greatest = {}, greatest_end = {}, zero = {};
  Six next{};
  const auto substitute = [&](int node) __attribute__((always_inline)) {
    const int ahead = node - nodes_ahead;
    ask_for<block_size>(multiplier_of(ahead, factors));
    ask_for<per_node>(x + per_node * ahead);
    ask_for<per_node>(from.numbers + per_node * ahead);
    Six own = load_six(x + per_node * node);
    if (node < nodes - 1) own = own - multiply_transposed(multiplier_of(node, factors), next);
    next = own;
    return own;
  };
  const auto add = [&](int node, const Six& own) __attribute__((always_inline)) {
    const Six old = load_six(from.numbers + per_node * node);
    store_six(x + per_node * node, Six{from.factor * old.a, from.factor * old.b} + own);
    const Lanes end = __builtin_shufflevector(own.b, own.b, 0, 1, 0, 1);
    greatest = larger(magnitude(own.a), greatest);
    greatest_end = larger(magnitude(end), greatest_end);
    zero += 0 * own.a + 0 * end;  // not a number, if one is none
  };
  if (turns == nullptr) {
    for (int node = nodes - 1; node >= 0; --node) add(node, substitute(node));
  } else {
    const int elements = nodes - 1;
    double changes[per_node * lanes];
    const auto take = [&](int first, int count, int group) __attribute__((always_inline)) {
      ask_for<turn_group_size>(turns + group - 2 * turn_group_size);
      for (int i = count - 1; i >= 0; --i) store_six(changes + per_node * i, substitute(first + i));
      GroupTurn::kept(turns + group).turn(count, changes);
      for (int i = count - 1; i >= 0; --i) add(first + i, load_six(changes + per_node * i));
    };
    take(elements, 1, last_turn_group(elements));
    const int left_over = elements % lanes;
    if (left_over > 0) take(elements - left_over, left_over, turn_group(elements - left_over));
    for (int e = elements - left_over - lanes; e >= 0; e -= lanes) take(e, lanes, turn_group(e));
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
                                 const StageTerms& terms, double* factors, double* turns, double* x) {
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

  const bool turning = turns != nullptr && !renews;
  const auto residual = [&](int node, double* force, const NodeVectors& inertia) {
    Six b = load_six(force);
    if (load != loads.end() && load->node == node) b = b + load_six(load++->force);
    b = {terms.force * b.a, terms.force * b.b};
    if (terms.known.numbers != nullptr) {
      const Six known = load_six(terms.known.numbers + per_node * node);
      b = b + Six{terms.known.factor * known.a, terms.known.factor * known.b};
    }
    b = b - Six{terms.mass * __builtin_shufflevector(inertia.r, inertia.g, 0, 1, 2, 4),
                terms.mass * __builtin_shufflevector(inertia.g, inertia.g, 1, 2)};
    store_six(force, b);
    if (node == 0 || node == elements) ends.hold(node != 0, force);
  };
  // Of residuals of `count` nodes from `first` on, whose coordinates are at `at`.
  const auto substitute = [&](int first, int count, int group, const double* at, double* residuals) {
    if (turning)
      GroupTurn::to_slopes(count, at, turns + group).turn_back(count, residuals);
    else if (turns != nullptr)
      GroupTurn::mark(count, at, turns + group);
    for (int i = 0; i < count; ++i) {
      const int node = first + i;
      if (!renews) {
        const int ahead = node + nodes_ahead;
        ask_for<block_size>(multiplier_of(ahead, factors));
        ask_for<symmetric_size>(inverse_of(ahead, nodes, factors));
        ask_for<per_node>(x + per_node * ahead);
      }
      store_six(x + per_node * node,
                forward.take(multiplier_of(node, factors), inverse_of(node, nodes, factors),
                             load_six(residuals + per_node * i)));
    }
  };
  const double* last = nullptr;
  const auto take_group = [&](int e, int count) __attribute__((always_inline)) {
    if (result.singular >= 0) return;
    const double* at = point(e, count);
    last = at + per_node * count;
    forces.take(e, count, at, f);
    if (renews) {
      result.singular = system.take(e, count, at);
      if (result.singular >= 0) return;
    }
    const double* rate = rates(e, count);
    if (e == 0) momentum = Momentum(element, load_node(rate));
    for (int i = 0; i < count; ++i)
      residual(e + i, f + per_node * i, momentum.take(load_node(rate + per_node * (i + 1))));
    if (turning) ask_for<turn_group_size>(turns + turn_group(e) + 2 * turn_group_size);
    substitute(e, count, turn_group(e), at, f);
  };
  for_each_group(elements, take_group);
  result.unsound = forces.unsound();
  if (result.unsound >= 0 || result.singular >= 0) return result;
  forces.end(f);
  residual(elements, f, momentum.take_last());
  substitute(elements, 1, last_turn_group(elements), last, f);
  substitute_back(nodes, factors, turning ? turns : nullptr, terms.from, x, result);
  return result;
}

}  // namespace
}  // namespace plumb::kernels
