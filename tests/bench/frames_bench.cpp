#include <benchmark/benchmark.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "engine/integrate/integrate.h"
#include "render/gl/canvas.h"
#include "render/scene/frame_stream.h"
#include "render/scene/scene.h"
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
  for (auto _ : state) bytes = encode_png(image, {}, PngEffort::quick).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(encode)->Args({960, 540})->Args({1920, 1080})->Unit(benchmark::kMillisecond);

/// Seconds that something takes: the least of some repeats.
template <typename Work>
double seconds(const Work& work) {
  double least = 1e9;
  for (int repeat = 0; repeat < 8; ++repeat) {
    const auto started = std::chrono::steady_clock::now();
    work();
    least =
        std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count());
  }
  return least;
}

/// What part of the work of one frame, done piece by piece, is drawing, reading back and encoding, in
/// percent.
void count_shares(benchmark::State& state, const GlContext& context, SceneRenderer& scene) {
  Image image = scene.frame(7);
  const double whole = seconds([&] { scene.frame(7, image); });
  Canvas canvas(context, image.width, image.height);
  canvas.begin_flat(Color{0.5F, 0.5F, 0.5F, 1});
  Image copy = canvas.read();
  const double reading = seconds([&] { canvas.read_into(copy); });
  const double encoding = seconds([&] { encode_png(image, {}, PngEffort::quick); });
  const double percent = 100 / (whole + encoding);
  state.counters["draw%"] = percent * (whole - reading);
  state.counters["read%"] = percent * reading;
  state.counters["encode%"] = percent * encoding;
}

/// Frames of half a second, drawn, encoded and on the disk.
void frames_to_disk(benchmark::State& state) {
  const Trajectory trajectory = motion(4);
  const GlContext context;
  SceneInput input = scene_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  input.spec.frame_rate = 100;
  SceneRenderer scene(context, trajectory, input);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("plumb_frames_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  scene.frame(0);  // the driver compiles its shaders with the first picture
  count_shares(state, context, scene);
  for (auto _ : state)
    stream_frames(scene, {0, scene.frame_count() - 1}, {}, PngEffort::quick,
                  [&](int k, const std::string& png) {
                    std::ofstream(folder / (std::to_string(k) + ".png"), std::ios::binary) << png;
                  });
  std::filesystem::remove_all(folder);
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(scene.frame_count()),
                                                  benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(frames_to_disk)
    ->Args({960, 540})
    ->Args({1920, 1080})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace plumb
