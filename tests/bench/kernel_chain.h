#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <vector>

#include "engine/kernels/kernels.h"
#include "tests/engine/model/plain_element.h"

namespace plumb {

/// A nearly straight chain to run kernels on. Elements of more than 64 are as long as those of 64 on a metre,
/// so that they ask the same of the kernels and the matrix stays positive definite.
struct KernelChain {
  static constexpr double EA = 40, EI = 7.95774715459e-5;

  explicit KernelChain(int count, const Kernels& built = best_kernels())
      : kernels(built),
        n(count),
        l(1.0 / std::min(n, 64)),
        constants{EA, EI, l, 8e-3, {0, -9.81, 0}, true, true},
        q(6 * (n + 1)),
        columns(static_cast<std::size_t>(block_column_size * (n + 1))),
        factors(static_cast<std::size_t>(factor_size * (n + 1))) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int node = 0; node <= n; ++node)
      for (int k = 0; k < 3; ++k) {
        q[6 * node + k] = (k == 0 ? node * l : 0) + 0.005 * l * unit(generator);
        q[6 * node + 3 + k] = (k == 0 ? 1 : 0) + 0.005 * unit(generator);
      }
    f = q;
  }

  void force() {
    benchmark::DoNotOptimize(kernels.force(constants, n, q.data(), f.data()));
    benchmark::ClobberMemory();
  }

  /// The straightforward force: one element after another with small Eigen vectors.
  void plain_force(const PlainElement& element) {
    f.setZero();
    for (int e = 0; e < n; ++e) element.add_force(q.data() + 6 * e, f.data() + 6 * e);
    benchmark::ClobberMemory();
  }

  /// M + ¼h² K at h = 1e-3 with the tangent K.
  void system() {
    kernels.system(constants, 1, 2.5e-7, n, q.data(), columns.data());
    benchmark::ClobberMemory();
  }

  const Kernels& kernels;
  int n;
  double l;
  ElementConstants constants;
  Eigen::VectorXd q, f;
  std::vector<double> columns, factors;
};

}  // namespace plumb
