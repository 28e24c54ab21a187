#pragma once

#include "engine/kernels/kernels.h"
#include "engine/kernels/lanes.h"

// L D Lᵀ of a symmetric positive definite block tridiagonal matrix, node by node from both ends towards the
// middle, so that two chains of operations that have to wait for one another run side by side. Block columns
// are as in kernels.h; only the lower triangles of the diagonal blocks are read.
//
// The six columns of a node, with what couples it to the neighbour towards the middle below them, are its
// panel. They are overwritten by those of L, with 1/D on the diagonal and the triangle of L mirrored above
// it, so that both substitutions can go by columns.
namespace plumb::kernels {
namespace {

inline constexpr int block_rows = 12;

/// Six numbers.
struct Six {
  Lanes a;
  Pair b;

  PLUMB_INLINE double operator[](int i) const { return i < lanes ? a[i] : b[i - lanes]; }
};

PLUMB_INLINE Six load_six(const double* p) {
  return {load_lanes(p), load_two(p + lanes)};
}
PLUMB_INLINE void store_six(double* p, const Six& x) {
  store_lanes(p, x.a);
  store_two(p + lanes, x.b);
}
PLUMB_INLINE void subtract(Six& from, double s, const Six& x) {
  from.a -= s * x.a;
  from.b -= s * x.b;
}

/// A column of a panel: twelve numbers, of which the last six belong to the neighbour.
struct Twelve {
  Lanes a, b, c;

  PLUMB_INLINE double operator[](int i) const { return i < 4 ? a[i] : i < 8 ? b[i - 4] : c[i - 8]; }
};

/// Where a panel is: columns of six numbers each, block_rows apart, for the node and for its neighbour, and
/// the neighbour's diagonal block.
struct Panel {
  double* own;
  double* coupling;
  double* next;
};

/// Eliminates a node whose panel has been loaded. A pivot that is not positive against the diagonal that the
/// elimination of the nodes before has left, or not a number, ends in false.
PLUMB_INLINE bool eliminate(Twelve (&column)[6], const Panel& panel) {
  // A smaller pivot is round-off of a zero.
  constexpr double singular_ratio = 1e-14;
  // The neighbour's block in the rows 6 to 11. Rows above its diagonal that lie in the same vectors are
  // carried along; they are read by nobody.
  Lanes next_b[2], next_c[6];
  for (int j = 0; j < 6; ++j) next_c[j] = load_lanes(panel.next + block_rows * j + 2);
  for (int j = 0; j < 2; ++j) {
    const Pair top = load_two(panel.next + block_rows * j);
    next_b[j] = __builtin_shufflevector(top, top, 0, 1, 0, 1);
  }
  double least[6];
  for (int k = 0; k < 6; ++k) least[k] = singular_ratio * column[k][k];
  bool positive = true;
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k) {
    const double pivot = column[k][k];
    positive &= pivot > least[k] && least[k] > 0;
    const double inverse = 1 / pivot;
    const Twelve l{inverse * column[k].a, inverse * column[k].b, inverse * column[k].c};
#pragma GCC unroll 6
    for (int j = k + 1; j < 6; ++j) {
      const double factor = column[k][j];
      if (j < 4) column[j].a -= factor * l.a;
      column[j].b -= factor * l.b;
      column[j].c -= factor * l.c;
    }
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
      const double factor = column[k][6 + j];
      if (j < 2) next_b[j] -= factor * l.b;
      next_c[j] -= factor * l.c;
    }
    double* own = panel.own + block_rows * k;
    double* coupling = panel.coupling + block_rows * k;
    if (k < 4) store_lanes(own, l.a);
    store_two(own + 4, __builtin_shufflevector(l.b, l.b, 0, 1));
    store_two(coupling, __builtin_shufflevector(l.b, l.b, 2, 3));
    store_lanes(coupling + 2, l.c);
    own[k] = inverse;
  }
  for (int k = 0; k < 6; ++k)
    for (int j = k + 1; j < 6; ++j) panel.own[block_rows * j + k] = panel.own[block_rows * k + j];
  for (int j = 0; j < 6; ++j) store_lanes(panel.next + block_rows * j + 2, next_c[j]);
  for (int j = 0; j < 2; ++j)
    store_two(panel.next + block_rows * j, __builtin_shufflevector(next_b[j], next_b[j], 2, 3));
  return positive;
}

/// A node of the left half, whose coupling lies below its diagonal block.
PLUMB_INLINE bool eliminate_forward(double* node) {
  Twelve column[6];
  for (int k = 0; k < 6; ++k) {
    const double* p = node + block_rows * k;
    column[k] = {load_lanes(p), load_lanes(p + 4), load_lanes(p + 8)};
  }
  return eliminate(column, {node, node + 6, node + block_column_size});
}

/// A node of the right half, whose coupling is the transpose of what lies below the neighbour's diagonal
/// block; the panel takes that place, by columns.
PLUMB_INLINE bool eliminate_backward(double* node) {
  double* neighbour = node - block_column_size;
  const double* below = neighbour + 6;
  Twelve column[6];
  for (int k = 0; k < 6; ++k) {
    const double* row = below + k;
    const Six own = load_six(node + block_rows * k);
    column[k] = {own.a, Lanes{own.b[0], own.b[1], row[0], row[block_rows]},
                 Lanes{row[2 * block_rows], row[3 * block_rows], row[4 * block_rows], row[5 * block_rows]}};
  }
  return eliminate(column, {node, neighbour + 6, neighbour});
}

/// The middle node, which has no neighbour left.
PLUMB_INLINE bool eliminate_last(double* node) {
  Twelve column[6];
  for (int k = 0; k < 6; ++k) {
    const Six own = load_six(node + block_rows * k);
    column[k] = {own.a, Lanes{own.b[0], own.b[1], 0, 0}, Lanes{}};
  }
  double nothing[block_column_size] = {}, none[block_column_size] = {};
  return eliminate(column, {node, nothing, none});
}

int factor(int nodes, double* block_columns) {
  const int middle = nodes / 2;
  const auto node = [&](int i) { return block_columns + block_column_size * i; };
  int left = 0, right = nodes - 1;
  for (; left < middle && right > middle; ++left, --right) {
    const bool left_well = eliminate_forward(node(left)), right_well = eliminate_backward(node(right));
    if (!left_well) return left;
    if (!right_well) return right;
  }
  for (; left < middle; ++left)
    if (!eliminate_forward(node(left))) return left;
  for (; right > middle; --right)
    if (!eliminate_backward(node(right))) return right;
  return eliminate_last(node(middle)) ? -1 : middle;
}

/// L y = x of one node: x becomes D⁻¹ y, and what y takes off the neighbour is taken off.
PLUMB_INLINE void substitute_inwards(const double* own, const double* coupling, double* x,
                                     double* neighbour) {
  Six rest = load_six(x), next = load_six(neighbour);
  double scaled[6];
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k) {
    const double y = rest[k];
    // The rows up to k are not wanted any more.
    subtract(rest, y, load_six(own + block_rows * k));
    subtract(next, y, load_six(coupling + block_rows * k));
    scaled[k] = y * own[block_rows * k + k];
  }
  store_six(neighbour, next);
  store_six(x, {Lanes{scaled[0], scaled[1], scaled[2], scaled[3]}, Pair{scaled[4], scaled[5]}});
}

/// Lᵀ x = z of a diagonal block, with z in `rest`.
PLUMB_INLINE void substitute_upwards(const double* own, Six rest, double* x) {
#pragma GCC unroll 6
  for (int k = 5; k >= 0; --k) {
    const double value = rest[k];
    subtract(rest, value, load_six(own + block_rows * k));
    x[k] = value;
  }
}

/// Lᵀ x = z of one node, with z in x, once the neighbour is known.
PLUMB_INLINE void substitute_outwards(const double* own, const double* coupling, const double* neighbour,
                                      double* x) {
  const Six known = load_six(neighbour);
  Six rest = load_six(x);
  double sums[6];
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k) {
    const Six column = load_six(coupling + block_rows * k);
    const Lanes a = column.a * known.a;
    const Pair b = column.b * known.b;
    sums[k] = (a[0] + a[2]) + (a[1] + a[3]) + (b[0] + b[1]);
  }
  rest.a -= Lanes{sums[0], sums[1], sums[2], sums[3]};
  rest.b -= Pair{sums[4], sums[5]};
  substitute_upwards(own, rest, x);
}

void solve(int nodes, const double* block_columns, double* x) {
  const int middle = nodes / 2;
  const auto node = [&](int i) { return block_columns + block_column_size * i; };
  const auto right_in = [&](int i) {
    substitute_inwards(node(i), node(i - 1) + 6, x + 6 * i, x + 6 * (i - 1));
  };
  const auto left_in = [&](int i) { substitute_inwards(node(i), node(i) + 6, x + 6 * i, x + 6 * (i + 1)); };
  int left = 0, right = nodes - 1;
  for (; left < middle && right > middle; ++left, --right) {
    left_in(left);
    right_in(right);
  }
  for (; left < middle; ++left) left_in(left);
  for (; right > middle; --right) right_in(right);

  double nothing[6] = {};
  const double none[block_column_size] = {};
  substitute_inwards(node(middle), none, x + 6 * middle, nothing);
  substitute_upwards(node(middle), load_six(x + 6 * middle), x + 6 * middle);

  const auto left_out = [&](int i) { substitute_outwards(node(i), node(i) + 6, x + 6 * (i + 1), x + 6 * i); };
  const auto right_out = [&](int i) {
    substitute_outwards(node(i), node(i - 1) + 6, x + 6 * (i - 1), x + 6 * i);
  };
  left = middle - 1;
  right = middle + 1;
  for (; left >= 0 && right < nodes; --left, ++right) {
    left_out(left);
    right_out(right);
  }
  for (; left >= 0; --left) left_out(left);
  for (; right < nodes; ++right) right_out(right);
}

}  // namespace
}  // namespace plumb::kernels
