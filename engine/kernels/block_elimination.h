#pragma once

#include "engine/kernels/kernels.h"
#include "engine/kernels/lanes.h"

// Elimination of a symmetric positive definite block tridiagonal matrix, node by node from the first to the
// last. With D the diagonal block of a node as the nodes before have left it and B the block below it, what
// is kept of a node are its factors
//   G = B D⁻¹  and  S = D⁻¹,
// and the diagonal block of the next node loses G Bᵀ. Then L y = b is y' = b' − G y from node to node, and
// Lᵀ x = D⁻¹ y is x = S y − Gᵀ x'. Explicit inverses leave a node's numbers a single product to wait for,
// where triangles would have them wait for one another.
namespace plumb::kernels {
namespace {

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
PLUMB_INLINE Six operator+(const Six& x, const Six& y) {
  return {x.a + y.a, x.b + y.b};
}
PLUMB_INLINE Six operator-(const Six& x, const Six& y) {
  return {x.a - y.a, x.b - y.b};
}

/// A 6 by 6 block, column after column: two columns are three vectors, of which the one between them holds
/// the end of the first column and the beginning of the second.
inline constexpr int block_size = 36, two_columns = 12;

/// A x.
PLUMB_INLINE Six multiply(const double* block, const Six& x) {
  Lanes upper = {}, between = {}, lower = {};
#pragma GCC unroll 3
  for (int pair = 0; pair < 3; ++pair) {
    const double* p = block + two_columns * pair;
    const double first = x[2 * pair], second = x[2 * pair + 1];
    const Lanes u = load_lanes(p) * all(first), m = load_lanes(p + 4) * Lanes{first, first, second, second},
                l = load_lanes(p + 8) * all(second);
    upper = pair == 0 ? u : upper + u;
    between = pair == 0 ? m : between + m;
    lower = pair == 0 ? l : lower + l;
  }
  return {upper + __builtin_shufflevector(between, lower, 2, 3, 4, 5),
          __builtin_shufflevector(between, between, 0, 1) + __builtin_shufflevector(lower, lower, 2, 3)};
}

/// Aᵀ x.
PLUMB_INLINE Six multiply_transposed(const double* block, const Six& x) {
  const Lanes turned =
      __builtin_shufflevector(__builtin_shufflevector(x.b, x.b, 0, 1, 0, 1), x.a, 0, 1, 4, 5);
  const Lanes behind =
      __builtin_shufflevector(x.a, __builtin_shufflevector(x.b, x.b, 0, 1, 0, 1), 2, 3, 4, 5);
  Lanes sums[3];
#pragma GCC unroll 3
  for (int pair = 0; pair < 3; ++pair) {
    const double* p = block + two_columns * pair;
    const Lanes u = load_lanes(p) * x.a, m = load_lanes(p + 4) * turned, l = load_lanes(p + 8) * behind;
    // Two numbers each of the first column and of the second.
    sums[pair] = __builtin_shufflevector(u, m, 0, 1, 6, 7) + __builtin_shufflevector(u, l, 2, 3, 4, 5) +
                 __builtin_shufflevector(m, l, 0, 1, 6, 7);
  }
  const Lanes even = __builtin_shufflevector(sums[0], sums[1], 0, 2, 4, 6),
              odd = __builtin_shufflevector(sums[0], sums[1], 1, 3, 5, 7);
  return {even + odd,
          __builtin_shufflevector(sums[2], sums[2], 0, 2) + __builtin_shufflevector(sums[2], sums[2], 1, 3)};
}

/// A symmetric 6 by 6 block: of its first four rows all columns, and of the last two what is on the diagonal.
inline constexpr int symmetric_size = 28;

/// A x of a symmetric block.
PLUMB_INLINE Six multiply_symmetric(const double* block, const Six& x) {
  const Lanes row4 = load_lanes(block + 16), row5 = load_lanes(block + 20);
  const Lanes upper = ((load_lanes(block) * all(x.a[0]) + load_lanes(block + 4) * all(x.a[1])) +
                       (load_lanes(block + 8) * all(x.a[2]) + load_lanes(block + 12) * all(x.a[3]))) +
                      (row4 * all(x.b[0]) + row5 * all(x.b[1]));
  const Lanes of4 = row4 * x.a, of5 = row5 * x.a;
  const Lanes sums =
      __builtin_shufflevector(of4, of5, 0, 1, 4, 5) + __builtin_shufflevector(of4, of5, 2, 3, 6, 7);
  const Lanes corner = load_lanes(block + 24) * __builtin_shufflevector(x.b, x.b, 0, 0, 1, 1);
  return {upper, (__builtin_shufflevector(sums, sums, 0, 2) + __builtin_shufflevector(sums, sums, 1, 3)) +
                     (__builtin_shufflevector(corner, corner, 0, 1) +
                      __builtin_shufflevector(corner, corner, 2, 3))};
}

/// A column of a node: its diagonal block's six numbers above those of the block below.
struct Twelve {
  Lanes a, b, c;

  PLUMB_INLINE double operator[](int i) const { return i < 4 ? a[i] : i < 8 ? b[i - 4] : c[i - 8]; }
  PLUMB_INLINE void clear(int i) {
    if (i < 4)
      a[i] = 0;
    else
      b[i - 4] = 0;
  }
};

/// Eliminates one node after the other.
class BlockElimination {
 public:
  /// Makes G and S of the next node from its block column. A pivot that is not positive against the diagonal
  /// that the nodes before have left, or not a number, ends in false.
  ///
  /// D is inverted by Gauss's and Jordan's steps on columns, in place. Up to the sign, the inverse grows as
  /// symmetric as D shrinks, so that each step takes its factors from its own column, and of D only the lower
  /// triangle is read.
  PLUMB_INLINE bool eliminate(const double* block_column, double* multiplier, double* own_inverse) {
    // A smaller pivot is round-off of a zero.
    constexpr double singular_ratio = 1e-14;
    Twelve column[6];
    for (int j = 0; j < 6; ++j) {
      const double* p = block_column + block_rows * j;
      const Lanes b = load_lanes(p + 4);
      const Pair own = __builtin_shufflevector(b, b, 0, 1) - taken_[j].b;
      column[j] = {load_lanes(p) - taken_[j].a,
                   __builtin_shufflevector(b, __builtin_shufflevector(own, own, 0, 1, 0, 1), 4, 5, 2, 3),
                   load_lanes(p + 8)};
    }
    double least[6];
    for (int k = 0; k < 6; ++k) least[k] = singular_ratio * column[k][k];
    bool positive = true;
    // G Bᵀ in the rows 6 to 11 of columns; the first two hold the rows 6 and 7 in their upper lanes.
    Lanes taken_b[6] = {}, taken_c[6] = {};
#pragma GCC unroll 6
    for (int k = 0; k < 6; ++k) {
      const double pivot = column[k][k];
      positive &= pivot > least[k] && least[k] > 0;
      const double inverse = 1 / pivot;
      Twelve l{inverse * column[k].a, inverse * column[k].b, inverse * column[k].c};
      if (k < 4)
        l.a[k] = inverse;
      else
        l.b[k - 4] = inverse;
#pragma GCC unroll 6
      for (int j = 0; j < 6; ++j) {
        if (j == k) continue;
        const double factor = j > k ? column[k][j] : -column[k][j];
        column[j].clear(k);
        column[j].a -= factor * l.a;
        column[j].b -= factor * l.b;
        column[j].c -= factor * l.c;
      }
#pragma GCC unroll 6
      for (int j = 0; j < 6; ++j) {
        const double factor = column[k][6 + j];
        taken_b[j] += factor * l.b;
        taken_c[j] += factor * l.c;
      }
      column[k] = l;
    }
    for (int j = 0; j < 6; ++j) {
      const Lanes below = __builtin_shufflevector(column[j].b, column[j].c, 2, 3, 4, 5);
      store_six(multiplier + 6 * j, {below, __builtin_shufflevector(column[j].c, column[j].c, 2, 3)});
      store_lanes(own_inverse + lanes * j, column[j].a);
      taken_[j] = {__builtin_shufflevector(taken_b[j], taken_c[j], 2, 3, 4, 5),
                   __builtin_shufflevector(taken_c[j], taken_c[j], 2, 3)};
    }
    store_lanes(own_inverse + lanes * 6, __builtin_shufflevector(column[4].b, column[5].b, 0, 1, 4, 5));
    return positive;
  }

 private:
  Six taken_[6] = {};  // off the diagonal block of the node that comes next
};

/// L y = b and D⁻¹ y, one node after the other.
class ForwardSubstitution {
 public:
  PLUMB_INLINE Six take(const double* multiplier, const double* inverse, const Six& b) {
    const Six y = b - taken_;
    taken_ = multiply(multiplier, y);
    return multiply_symmetric(inverse, y);
  }

 private:
  Six taken_ = {};  // off the node that comes next
};

static_assert(factor_size == block_size + symmetric_size);

/// Where the factors of a node are: all G lie before all S, as the way back needs G alone.
PLUMB_INLINE double* multiplier_of(int node, double* factors) {
  return factors + block_size * node;
}
PLUMB_INLINE double* inverse_of(int node, int nodes, double* factors) {
  return factors + block_size * nodes + symmetric_size * node;
}
PLUMB_INLINE const double* multiplier_of(int node, const double* factors) {
  return factors + block_size * node;
}
PLUMB_INLINE const double* inverse_of(int node, int nodes, const double* factors) {
  return factors + block_size * nodes + symmetric_size * node;
}

int factor(int nodes, const double* block_columns, double* factors) {
  BlockElimination elimination;
  for (int node = 0; node < nodes; ++node)
    if (!elimination.eliminate(block_columns + block_column_size * node, multiplier_of(node, factors),
                               inverse_of(node, nodes, factors)))
      return node;
  return -1;
}

void solve(int nodes, const double* factors, double* x) {
  ForwardSubstitution forward;
  for (int node = 0; node < nodes; ++node)
    store_six(x + 6 * node, forward.take(multiplier_of(node, factors), inverse_of(node, nodes, factors),
                                         load_six(x + 6 * node)));
  Six next = load_six(x + 6 * (nodes - 1));
  for (int node = nodes - 2; node >= 0; --node) {
    next = load_six(x + 6 * node) - multiply_transposed(multiplier_of(node, factors), next);
    store_six(x + 6 * node, next);
  }
}

}  // namespace
}  // namespace plumb::kernels
