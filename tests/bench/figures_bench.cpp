#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <limits>
#include <numbers>

#include "engine/integrate/method.h"
#include "engine/model/cable.h"
#include "tests/bench/kernel_chain.h"
#include "tests/engine/model/plain_element.h"
#include "tests/engine/pendulum.h"

// What one thing costs as a multiple of another. Both are timed in turn, many times over, and the least of
// each counts: whatever else the machine does meets both.
namespace plumb {
namespace {

double seconds_of(const std::function<void()>& work, long times) {
  const auto started = std::chrono::steady_clock::now();
  for (long i = 0; i < times; ++i) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

/// Least seconds of each of some pieces of work, each called often enough to take 50 µs at a time.
template <std::size_t n>
std::array<double, n> least_seconds(const std::array<std::function<void()>, n>& works) {
  constexpr double slice = 50e-6, budget = 0.4;
  std::array<double, n> least;
  std::array<long, n> times;
  for (std::size_t i = 0; i < n; ++i) {
    works[i]();
    const double once = std::min({seconds_of(works[i], 1), seconds_of(works[i], 1), seconds_of(works[i], 1)});
    times[i] = std::max(1L, static_cast<long>(slice / once));
    least[i] = std::numeric_limits<double>::infinity();
  }
  double spent = 0;
  for (int round = 0; round < 5 || spent < budget; ++round)
    for (std::size_t i = 0; i < n; ++i) {
      const double taken = seconds_of(works[i], times[i]);
      spent += taken;
      least[i] = std::min(least[i], taken / static_cast<double>(times[i]));
    }
  return least;
}

void report(benchmark::State& state, double ratio) {
  for (auto _ : state) {
  }
  state.counters["ratio"] = ratio;
}

/// The force against its straightforward form: at most a half is asked.
void force_over_eigen(benchmark::State& state) {
  KernelChain chain(static_cast<int>(state.range(0)));
  const PlainElement element(KernelChain::EA, KernelChain::EI, chain.l, StrainModel::green_geometric,
                             QuadratureRule::full);
  const auto [ours, plain] = least_seconds<2>({[&] { chain.force(); }, [&] { chain.plain_force(element); }});
  report(state, ours / plain);
}

/// M + ¼h² K against the force: at most four is asked.
void tangent_over_force(benchmark::State& state) {
  KernelChain chain(static_cast<int>(state.range(0)));
  const auto [tangent, force] = least_seconds<2>({[&] { chain.system(); }, [&] { chain.force(); }});
  report(state, tangent / force);
}

/// A fixed step of an explicit method on four elements against its force evaluations, each with the mass
/// solve that waits for it, and nothing else: at most 1.3 is asked.
void step_over_forces(benchmark::State& state, const std::string& name, int evaluations) {
  const Case spec = pendulum(5, 4);
  const Cable cable(spec);
  Dynamics dynamics(cable);
  const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
  const std::unique_ptr<Method> integrator = make_method(method(name, 1e-5), dynamics, start);
  const Kernels& kernels = best_kernels();
  Eigen::VectorXd f(cable.size()), scratch;
  const auto [step, evaluation] = least_seconds<2>(
      {[&] { benchmark::DoNotOptimize(integrator->step(1e6).ok()); },
       [&] {
         benchmark::DoNotOptimize(kernels.force(cable.constants(), 4, start.q.data(), f.data()));
         cable.mass().solve(f, scratch);
         benchmark::ClobberMemory();
       }});
  report(state, step / (evaluations * evaluation));
}

/// A free cable of which every metre, of 64 elements, moves as the others do: a step asks the same of every
/// element, however many there are.
struct WavyCable {
  explicit WavyCable(int elements) : spec(wavy(elements)), cable(spec), dynamics(cable) {
    start = {0, cable.start_q(spec.start), cable.start_v(spec.start)};
    for (int node = 0; node <= elements; ++node) {
      const double phase = 2 * std::numbers::pi * node / 64;
      start.v[6 * node + 1] += std::sin(phase);
      start.v[6 * node + 4] += 2 * std::numbers::pi * std::cos(phase);
    }
  }

  static Case wavy(int elements) {
    Case spec = pendulum(5, elements);
    spec.cable.length = elements / 64.0;
    spec.supports.first = Support::free;
    spec.start.angular_velocity.setZero();
    return spec;
  }

  /// Seconds a step and element of `steps` steps behind the first.
  double seconds(MethodSpec method, int steps) {
    // Newton's tolerance is a share of the cable's length, of which an element must be as near everywhere.
    if (const auto tolerance = method.parameters.find("newton_tolerance");
        tolerance != method.parameters.end())
      tolerance->second /= spec.cable.length;
    const std::unique_ptr<Method> integrator = make_method(method, dynamics, start);
    well &= integrator->step(1e6).ok();  // the first to touch its memory
    dynamics.counters.force_evaluations = dynamics.counters.tangent_evaluations = 0;
    const auto taken = seconds_of([&] { well &= integrator->step(1e6).ok(); }, steps);
    forces = static_cast<double>(dynamics.counters.force_evaluations) / steps;
    tangents = static_cast<double>(dynamics.counters.tangent_evaluations) / steps;
    return taken / steps / cable.elements();
  }

  Case spec;
  Cable cable;
  Dynamics dynamics;
  State start;
  bool well = true;
  double forces = 0, tangents = 0;  // a step
};

/// A step's cost per element with many elements against that with 64: between 0.75 and 1.25 is asked.
void large_over_64(benchmark::State& state, const MethodSpec& method) {
  constexpr int steps = 16;
  WavyCable large(static_cast<int>(state.range(0))), small(64);
  double of_large = std::numeric_limits<double>::infinity(), of_small = of_large, spent = 0;
  for (int round = 0; round < 5 || spent < 2; ++round) {
    const double taken = large.seconds(method, steps);
    spent += taken * steps * large.cable.elements();
    of_large = std::min(of_large, taken);
    for (int i = 0; i < 20; ++i) of_small = std::min(of_small, small.seconds(method, steps));
  }
  if (!large.well || !small.well) state.SkipWithError("a step failed");
  report(state, of_large / of_small);
  state.counters["ns"] = 1e9 * of_large;
  state.counters["ns of 64"] = 1e9 * of_small;
  state.counters["forces"] = large.forces;
  state.counters["of 64"] = small.forces;
  state.counters["tangents"] = large.tangents;
  state.counters["tangents of 64"] = small.tangents;
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int n : {4, 64, 1024, 65536}) b->Arg(n);
  b->Iterations(1);
}
void large_sizes(benchmark::internal::Benchmark* b) {
  for (const int n : {1024, 65536}) b->Arg(n);
  b->Iterations(1);
}

BENCHMARK(force_over_eigen)->Apply(sizes);
BENCHMARK(tangent_over_force)->Apply(sizes);
BENCHMARK_CAPTURE(step_over_forces, velocity_verlet, "velocity-verlet", 1)->Iterations(1);
BENCHMARK_CAPTURE(step_over_forces, rk4, "rk4", 4)->Iterations(1);
BENCHMARK_CAPTURE(step_over_forces, runge_kutta_nystrom, "runge-kutta-nystrom", 8)->Iterations(1);
BENCHMARK_CAPTURE(large_over_64, rk4, method("rk4", 1e-5))->Apply(large_sizes);
BENCHMARK_CAPTURE(large_over_64, generalized_alpha, method("generalized-alpha", 1e-3))->Apply(large_sizes);

}  // namespace
}  // namespace plumb
