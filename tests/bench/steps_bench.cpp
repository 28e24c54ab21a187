#include <benchmark/benchmark.h>

#include "engine/integrate/method.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace {

/// One step of a method on the pendulum with f = 5, from its start on: a fixed step of 1e-3 s for implicit
/// methods, of a hundredth of the time that a wave takes through an element for explicit ones, and whatever a
/// method chooses at rtol = 1e-6 if it takes tolerances only.
void step(benchmark::State& state, const std::string& name) {
  const auto elements = static_cast<int>(state.range(0));
  const MethodInfo& info = *find_method(name);
  const double step = info.implicit ? 1e-3 : 0.01 * (1.0 / elements) / 70.7;
  const MethodSpec spec = info.takes_step ? method(name, step) : method(name, {}, 1e-6);
  const Case pendulum_case = pendulum(5, elements);
  const Cable cable(pendulum_case);
  const State start{0, cable.start_q(pendulum_case.start), cable.start_v(pendulum_case.start)};
  Dynamics dynamics(cable);
  const std::unique_ptr<Method> integrator = make_method(spec, dynamics, start);
  long steps = 0;
  for (auto _ : state) {
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

const bool registered = [] {
  for (const MethodInfo& info : method_infos())
    for (const int elements : {4, 64, 1024, 65536})
      benchmark::RegisterBenchmark(("step/" + info.name + "/" + std::to_string(elements)).c_str(),
                                   [name = info.name](benchmark::State& state) { step(state, name); })
          ->Arg(elements);
  return true;
}();

}  // namespace
}  // namespace plumb
