#pragma once

#include "engine/kernels/add_up.h"
#include "engine/kernels/chain.h"

namespace plumb::kernels {
namespace {

/// Coordinates of a chain as a sum, of which as much is added up as the elements at hand need, and other sums
/// over the same nodes with it. So on long chains memory is read and written while forces are computed.
class SummedNodes {
 public:
  PLUMB_INLINE explicit SummedNodes(const Sum& sum, Sums beside = Sums()) : sum_(sum), beside_(beside) {}

  /// The nodes of the `count` elements from `e` on. Groups come in the order of the chain, and all but the
  /// last are of four elements.
  PLUMB_INLINE const double* operator()(int e, int count) {
    const int from = e > 0 ? e + 1 : 0, to = e + count + 1;
    for (const Sum& sum : beside_) add_up(sum, from, to);
    if (sum_.result != nullptr) {
      add_up(sum_, from, to);
      return sum_.result + per_node * e;
    }
    if (sum_.count == 0) return sum_.first + per_node * e;
    if (e > 0) __builtin_memcpy(made_, made_ + per_node * lanes, per_node * sizeof(double));
    add_up(sum_, from, to, made_ + per_node * (from - e));
    return made_;
  }

 private:
  const Sum& sum_;
  Sums beside_;
  double made_[per_node * (lanes + 1)];
};

}  // namespace
}  // namespace plumb::kernels
