#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>

#include "engine/integrate/integrate.h"
#include "render/png.h"
#include "render/scene.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace {

/// The pendulum of a mesh over half a second.
Trajectory motion(int elements) {
  Case spec = pendulum(5, elements);
  spec.time = {0.5, 0.02};
  spec.method = method("generalized-alpha", 1e-3);
  return integrate(spec);
}

SceneInput scene_of(int width, int height) {
  SceneInput input = scene_input(pendulum(5, 4));
  input.spec.size = {width, height};
  input.spec.supersampling = 2;
  input.title = "Spatial cable pendulum";
  return input;
}

/// One frame drawn and read back.
void frame(benchmark::State& state, int elements) {
  const Trajectory trajectory = motion(elements);
  const GlContext context;
  SceneRenderer scene(context, trajectory,
                      scene_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  int k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(scene.frame(k++ % scene.frame_count()));
}
BENCHMARK_CAPTURE(frame, 4_elements, 4)
    ->Args({960, 540})
    ->Args({1920, 1080})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frame, 64_elements, 64)
    ->Args({960, 540})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frame, 4096_elements, 4096)
    ->Args({960, 540})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// The PNG of one frame.
void encode(benchmark::State& state) {
  const Trajectory trajectory = motion(4);
  const GlContext context;
  SceneRenderer scene(context, trajectory,
                      scene_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  const Image image = scene.frame(7);
  std::size_t bytes = 0;
  for (auto _ : state) bytes = encode_png(image).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(encode)->Args({960, 540})->Args({1920, 1080})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb
