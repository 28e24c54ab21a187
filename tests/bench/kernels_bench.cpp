#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/kernels/kernels.h"
#include "engine/model/mass.h"
#include "tests/engine/plain_element.h"

namespace plumb {
namespace {

constexpr double EA = 40, EI = 7.95774715459e-5;

/// Elements of more than 64 are as long as those of 64 on a metre, so that they ask the same of the kernels
/// and the matrix stays positive definite.
struct Chain {
  explicit Chain(int count)
      : n(count),
        l(1.0 / std::min(n, 64)),
        constants{EA, EI, l, 8e-3, {0, -9.81, 0}, true, true},
        q(6 * (n + 1)) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int node = 0; node <= n; ++node)
      for (int k = 0; k < 3; ++k) {
        q[6 * node + k] = (k == 0 ? node * l : 0) + 0.005 * l * unit(generator);
        q[6 * node + 3 + k] = (k == 0 ? 1 : 0) + 0.005 * unit(generator);
      }
    f = q;
  }

  int n;
  double l;
  ElementConstants constants;
  Eigen::VectorXd q, f;
};

void per_element(benchmark::State& state) {
  state.counters["ns/element"] =
      benchmark::Counter(static_cast<double>(state.range(0)) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The straightforward force: one element after another with small Eigen vectors.
void force_eigen(benchmark::State& state) {
  Chain chain(static_cast<int>(state.range(0)));
  const PlainElement element(EA, EI, chain.l, StrainModel::green_geometric, QuadratureRule::full);
  for (auto _ : state) {
    chain.f.setZero();
    for (int e = 0; e < chain.n; ++e) element.add_force(chain.q.data() + 6 * e, chain.f.data() + 6 * e);
    benchmark::ClobberMemory();
  }
  per_element(state);
}

void force(benchmark::State& state, const Kernels& kernels) {
  Chain chain(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(kernels.force(chain.constants, chain.n, chain.q.data(), chain.f.data()));
    benchmark::ClobberMemory();
  }
  per_element(state);
}

/// M + ¼h² K at h = 1e-3 with the tangent K.
void system(benchmark::State& state, const Kernels& kernels) {
  Chain chain(static_cast<int>(state.range(0)));
  std::vector<double> columns(static_cast<std::size_t>(block_column_size * (chain.n + 1)));
  for (auto _ : state) {
    kernels.system(chain.constants, 1, 2.5e-7, chain.n, chain.q.data(), columns.data());
    benchmark::ClobberMemory();
  }
  per_element(state);
}

void factor(benchmark::State& state, const Kernels& kernels) {
  Chain chain(static_cast<int>(state.range(0)));
  std::vector<double> columns(static_cast<std::size_t>(block_column_size * (chain.n + 1))), work = columns;
  kernels.system(chain.constants, 1, 2.5e-7, chain.n, chain.q.data(), columns.data());
  for (auto _ : state) {
    work = columns;
    if (kernels.factor(chain.n + 1, work.data()) >= 0) {
      state.SkipWithError("not positive definite");
      break;
    }
    benchmark::ClobberMemory();
  }
  per_element(state);
}

void solve(benchmark::State& state, const Kernels& kernels) {
  Chain chain(static_cast<int>(state.range(0)));
  std::vector<double> columns(static_cast<std::size_t>(block_column_size * (chain.n + 1)));
  kernels.system(chain.constants, 1, 2.5e-7, chain.n, chain.q.data(), columns.data());
  kernels.factor(chain.n + 1, columns.data());
  for (auto _ : state) {
    chain.f = chain.q;
    kernels.solve(chain.n + 1, columns.data(), chain.f.data());
    benchmark::ClobberMemory();
  }
  per_element(state);
}

/// One solution with the factored mass matrix, of a cable pinned at one end.
void mass_solve(benchmark::State& state) {
  Chain chain(static_cast<int>(state.range(0)));
  const MassMatrix mass(chain.constants, chain.n,
                        SupportProjection({.first = Support::pinned}, Vec3::UnitX(), chain.n + 1));
  Eigen::VectorXd scratch;
  for (auto _ : state) {
    // In place, again and again: the numbers grow and are reset before they overflow.
    mass.solve(chain.f, scratch);
    benchmark::ClobberMemory();
    if (!(std::abs(chain.f[7]) < 1e100)) chain.f.setOnes();
  }
  per_element(state);
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int n : {4, 64, 1024, 65536}) b->Arg(n);
}

BENCHMARK(force_eigen)->Apply(sizes);
BENCHMARK(mass_solve)->Apply(sizes);
BENCHMARK_CAPTURE(force, plain, plain_kernels())->Apply(sizes);
BENCHMARK_CAPTURE(force, best, best_kernels())->Apply(sizes);
BENCHMARK_CAPTURE(system, plain, plain_kernels())->Apply(sizes);
BENCHMARK_CAPTURE(system, best, best_kernels())->Apply(sizes);
BENCHMARK_CAPTURE(factor, plain, plain_kernels())->Apply(sizes);
BENCHMARK_CAPTURE(factor, best, best_kernels())->Apply(sizes);
BENCHMARK_CAPTURE(solve, plain, plain_kernels())->Apply(sizes);
BENCHMARK_CAPTURE(solve, best, best_kernels())->Apply(sizes);

}  // namespace
}  // namespace plumb

BENCHMARK_MAIN();
