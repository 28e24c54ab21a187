#include <benchmark/benchmark.h>

#include "engine/integrate/method.h"
#include "engine/integrate/monitor.h"
#include "engine/model/cable.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace {

/// The pendulum with f = 5: with four elements that of one metre, with more a longer one whose elements are
/// as long as those of 64 on one metre, so that what an element asks of a method does not depend on how many
/// there are. The tip starts at 4 m/s.
Case pendulum_of(int elements) {
  Case spec = pendulum(5, elements);
  spec.cable.length = elements < 64 ? 1 : elements / 64.0;
  spec.start.angular_velocity /= spec.cable.length;
  return spec;
}

/// One step of a method: a fixed step of 1e-3 s for implicit methods, of 1e-5 s for explicit ones, and
/// whatever a method chooses at rtol = 1e-6 if it takes tolerances only. The method starts anew after a
/// hundred steps, so that neither the machine's speed nor the size of the mesh decides which part of the
/// motion is timed.
void step(benchmark::State& state, const std::string& name) {
  const auto elements = static_cast<int>(state.range(0));
  const MethodInfo& info = *find_method(name);
  const MethodSpec spec =
      info.takes_step ? method(name, info.implicit ? 1e-3 : 1e-5) : method(name, {}, 1e-6);
  const Case pendulum_case = pendulum_of(elements);
  const Cable cable(pendulum_case);
  const State start{0, cable.start_q(pendulum_case.start), cable.start_v(pendulum_case.start)};
  Dynamics dynamics(cable);
  std::unique_ptr<Method> integrator;
  constexpr long steps_of_a_run = 100;
  long steps = 0;
  for (auto _ : state) {
    if (steps % steps_of_a_run == 0) {
      state.PauseTiming();
      integrator = make_method(spec, dynamics, start);
      state.ResumeTiming();
    }
    if (!integrator->step(1e6).ok()) {
      state.SkipWithError("the step failed");
      break;
    }
    ++steps;
  }
  state.counters["ns/element"] =
      benchmark::Counter(static_cast<double>(elements) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  const auto a_step = [&](long count) {
    return static_cast<double>(count) / static_cast<double>(std::max(1L, steps));
  };
  state.counters["forces"] = a_step(dynamics.counters.force_evaluations);
  state.counters["tangents"] = a_step(dynamics.counters.tangent_evaluations);
}

/// One look of the Monitor, which comes with every output and with one step in steps_between_looks: to be
/// held against that many of the shortest step, velocity-verlet's.
void look(benchmark::State& state) {
  const Case pendulum_case = pendulum_of(static_cast<int>(state.range(0)));
  const Cable cable(pendulum_case);
  const State start{0, cable.start_q(pendulum_case.start), cable.start_v(pendulum_case.start)};
  const Monitor monitor(cable, start, pendulum_case.time.end);
  for (auto _ : state) benchmark::DoNotOptimize(monitor.check(start).ok());
  state.counters["ns/element"] =
      benchmark::Counter(static_cast<double>(state.range(0)) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(look)->Arg(4)->Arg(64)->Arg(1024)->Arg(65536);

const bool registered = [] {
  for (const MethodInfo& info : method_infos()) {
    if (!info.dynamic) continue;
    for (const int elements : {4, 64, 1024, 65536})
      benchmark::RegisterBenchmark(("step/" + info.name + "/" + std::to_string(elements)).c_str(),
                                   [name = info.name](benchmark::State& state) { step(state, name); })
          ->Arg(elements);
  }
  return true;
}();

}  // namespace
}  // namespace plumb
