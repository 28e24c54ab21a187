#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/model/mass.h"
#include "tests/bench/kernel_chain.h"

namespace plumb {
namespace {

void per_element(benchmark::State& state) {
  state.counters["ns/element"] =
      benchmark::Counter(static_cast<double>(state.range(0)) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The straightforward force: one element after another with small Eigen vectors.
void force_eigen(benchmark::State& state) {
  KernelChain chain(static_cast<int>(state.range(0)));
  const PlainElement element(KernelChain::EA, KernelChain::EI, chain.l, StrainModel::green_geometric,
                             QuadratureRule::full);
  for (auto _ : state) chain.plain_force(element);
  per_element(state);
}

void force(benchmark::State& state, const Kernels& kernels) {
  KernelChain chain(static_cast<int>(state.range(0)), kernels);
  for (auto _ : state) chain.force();
  per_element(state);
}

void system(benchmark::State& state, const Kernels& kernels) {
  KernelChain chain(static_cast<int>(state.range(0)), kernels);
  for (auto _ : state) chain.system();
  per_element(state);
}

void factor(benchmark::State& state, const Kernels& kernels) {
  KernelChain chain(static_cast<int>(state.range(0)), kernels);
  chain.system();
  for (auto _ : state) {
    if (kernels.factor(chain.n + 1, chain.columns.data(), chain.factors.data()) >= 0) {
      state.SkipWithError("not positive definite");
      break;
    }
    benchmark::ClobberMemory();
  }
  per_element(state);
}

void solve(benchmark::State& state, const Kernels& kernels) {
  KernelChain chain(static_cast<int>(state.range(0)), kernels);
  chain.system();
  kernels.factor(chain.n + 1, chain.columns.data(), chain.factors.data());
  for (auto _ : state) {
    chain.f = chain.q;
    kernels.solve(chain.n + 1, chain.factors.data(), chain.f.data());
    benchmark::ClobberMemory();
  }
  per_element(state);
}

/// One solution with the factored mass matrix, of a cable pinned at one end.
void mass_solve(benchmark::State& state) {
  KernelChain chain(static_cast<int>(state.range(0)));
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
