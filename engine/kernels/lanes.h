#pragma once

// Four elements side by side: what is done to one number of an element is done to those of four neighbours at
// once. Only for sources that are compiled once for each instruction set. All is in an unnamed namespace so
// that no function built for a newer processor can stand in for one that must run on an older.

namespace plumb::kernels {
namespace {

#define PLUMB_INLINE [[gnu::always_inline]] inline

using Lanes [[gnu::vector_size(32)]] = double;
/// The outcome of a comparison for each lane: all bits set, or none.
using Mask [[gnu::vector_size(32)]] = long long;
using Pair [[gnu::vector_size(16)]] = double;
/// The same anywhere in memory that doubles may be.
using UnalignedPair [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;
using UnalignedLanes [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

inline constexpr int lanes = 4;

PLUMB_INLINE Lanes load_lanes(const double* p) {
  return *reinterpret_cast<const UnalignedLanes*>(p);
}
PLUMB_INLINE void store_lanes(double* p, Lanes x) {
  *reinterpret_cast<UnalignedLanes*>(p) = x;
}
PLUMB_INLINE Pair load_two(const double* p) {
  return *reinterpret_cast<const UnalignedPair*>(p);
}
PLUMB_INLINE void store_two(double* p, Pair x) {
  *reinterpret_cast<UnalignedPair*>(p) = x;
}

PLUMB_INLINE Lanes all(double x) {
  return Lanes{x, x, x, x};
}
PLUMB_INLINE Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}
PLUMB_INLINE Lanes root(Lanes a) {
  return Lanes{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
}
PLUMB_INLINE double sum(Lanes a) {
  return (a[0] + a[2]) + (a[1] + a[3]);
}
/// The lanes one place up, behind the last of `before`.
PLUMB_INLINE Lanes moved_up(Lanes a, Lanes before) {
  return __builtin_shufflevector(before, a, 3, 4, 5, 6);
}

/// A vector in space for each lane.
struct Lanes3 {
  Lanes x, y, z;
};

PLUMB_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PLUMB_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PLUMB_INLINE Lanes3 operator*(Lanes s, const Lanes3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
PLUMB_INLINE Lanes3 operator*(double s, const Lanes3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
PLUMB_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
PLUMB_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Two numbers a node of four nodes, to one number a lane.
struct LanesPair {
  Lanes first, second;
};

/// Numbers `p[0]` and `p[1]` of four nodes; `offset` holds where each node's numbers start.
PLUMB_INLINE LanesPair load_pair(const double* p, const int* offset) {
  // Sixteen bytes at a time, so that what was just stored can be forwarded.
  const Pair a = load_two(p + offset[0]), b = load_two(p + offset[1]);
  const Pair c = load_two(p + offset[2]), d = load_two(p + offset[3]);
  const Lanes even = __builtin_shufflevector(a, c, 0, 1, 2, 3);
  const Lanes odd = __builtin_shufflevector(b, d, 0, 1, 2, 3);
  return {__builtin_shufflevector(even, odd, 0, 4, 2, 6), __builtin_shufflevector(even, odd, 1, 5, 3, 7)};
}

/// Stores a number of each lane at `p[0]` and another at `p[1]`, lanes `stride` numbers apart; with `base` on
/// top of what is there at the same places.
PLUMB_INLINE void store_pair(double* p, int stride, Lanes first, Lanes second, const double* base = nullptr) {
  const Lanes even = __builtin_shufflevector(first, second, 0, 4, 2, 6);
  const Lanes odd = __builtin_shufflevector(first, second, 1, 5, 3, 7);
  const auto store = [&](int lane, Pair value) {
    if (base != nullptr) value += load_two(base + lane * stride);
    store_two(p + lane * stride, value);
  };
  store(0, __builtin_shufflevector(even, even, 0, 1));
  store(1, __builtin_shufflevector(odd, odd, 0, 1));
  store(2, __builtin_shufflevector(even, even, 2, 3));
  store(3, __builtin_shufflevector(odd, odd, 2, 3));
}

}  // namespace
}  // namespace plumb::kernels
