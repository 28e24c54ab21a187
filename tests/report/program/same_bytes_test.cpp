#include <fmt/format.h>

#include <map>

#include "render/gl/gl_context.h"
#include "render/image/image_difference.h"
#include "render/image/png.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace same_bytes_test {

using Words = std::vector<std::string>;

/// Pictures of one run, each drawn by a process of its own.
class SameBytes : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<TemporaryFolder>();
    const Ended ended =
        plumb_in(folder->path(), {"solve", case_path("pendulum.toml"), "-o", "run", "--set", "time.end=0.12",
                                  "--set", "scene.size=[160,90]", "--set", "scene.color_by=curvature",
                                  "--set", "scene.ghosts=1", "--set", "scene.ghost_interval=0.04"});
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  static void TearDownTestSuite() { folder.reset(); }

  /// Runs `plumb render run` with these variables of the environment.
  static Ended render(const Words& environment, const Words& arguments) {
    Words command = {"/usr/bin/env"};
    command.insert(command.end(), environment.begin(), environment.end());
    command.insert(command.end(), {PLUMB_PROGRAM, "render", "run"});
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_command(command, folder->path());
  }

  /// All pictures of the run by name: frames, animation and figures.
  static std::map<std::string, std::string> pictures(const Words& environment) {
    const Ended ended = render(environment, {"-o", "drawn"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(*folder / "drawn"))
      if (entry.path().extension() == ".png")
        all[fs::relative(entry.path(), *folder / "drawn").string()] = read_text(entry.path());
    fs::remove_all(*folder / "drawn");
    return all;
  }

  static std::unique_ptr<TemporaryFolder> folder;
};
std::unique_ptr<TemporaryFolder> SameBytes::folder;

std::size_t differing_bytes(const std::string& a, const std::string& b) {
  std::size_t count = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

bool egl_draws_in_software() {
  for (const EglDevice& device : egl_devices())
    if (device.software) return true;
  return false;
}

TEST_F(SameBytes, InTwentyProcesses) {
  const Ended first = render({}, {"-o", "-"});
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_GT(first.out.size(), 5000U);
  for (int repeat = 1; repeat < 20; ++repeat) {
    const Ended again = render({}, {"-o", "-"});
    ASSERT_EQ(again.status, 0) << again.err;
    ASSERT_TRUE(again.out == first.out)
        << "repeat " << repeat << ": " << differing_bytes(again.out, first.out) << " bytes differ";
  }
}

TEST_F(SameBytes, WithNoOneAndManyThreadsAndWithoutBeingToldInFramesAndFigures) {
  const auto reference = pictures({});
  ASSERT_GE(reference.size(), 4U + 1U + 3U) << "frames, animation, figures";
  Words backends = {"osmesa"};
  if (egl_draws_in_software()) backends.push_back("egl");
  for (const std::string& backend : backends) {
    std::map<std::string, std::string> first;
    for (const char* threads : {"0", "1", "16"}) {
      const auto drawn = pictures({std::string("LP_NUM_THREADS=") + threads, "PLUMB_GL=" + backend});
      ASSERT_EQ(drawn.size(), reference.size());
      if (first.empty()) first = drawn;
      for (const auto& [name, bytes] : drawn)
        EXPECT_TRUE(bytes == first[name])
            << name << ", " << backend << ", " << threads
            << " threads: " << differing_bytes(bytes, first[name]) << " bytes differ";
    }
    // Files of two backends say so, and have the same pixels.
    for (const auto& [name, bytes] : first) {
      if (name == "animation.png") continue;
      const ImageDifference found =
          difference(decode_png(reference.at(name), name), decode_png(bytes, name), {});
      EXPECT_TRUE(found.identical()) << name << ", " << backend << ": " << found.changed << " pixels differ";
    }
  }
}

TEST_F(SameBytes, OnLowerLevelsOfTheProcessorWithinTheTolerance) {
  const auto reference = pictures({});
  for (const std::string level :
       {"LP_NATIVE_VECTOR_WIDTH=128", "GALLIUM_OVERRIDE_CPU_CAPS=sse4.1", "GALLIUM_OVERRIDE_CPU_CAPS=sse2"}) {
    const auto drawn = pictures({level});
    ASSERT_EQ(drawn.size(), reference.size());
    long pixels = 0, changed = 0;
    int levels = 0;
    for (const auto& [name, bytes] : drawn) {
      if (name == "animation.png") continue;
      const std::string& a_bytes = reference.at(name);
      const Image a = decode_png(a_bytes, name), b = decode_png(bytes, name);
      const ImageDifference found = difference(a, b, {});
      if (level.find("OVERRIDE") != std::string::npos) {
        EXPECT_NE(text_in_png(a_bytes, renderer_keyword, name), text_in_png(bytes, renderer_keyword, name));
      }
      EXPECT_TRUE(found.within({})) << name << ", " << level << ": " << found.beyond << " pixels beyond "
                                    << DifferenceTolerance{}.channel << " levels, greatest density "
                                    << found.density;
      pixels += static_cast<long>(a.width) * a.height;
      changed += found.changed;
      levels = std::max(levels, found.greatest);
    }
    fmt::print("{}: {} of {} pixels differ, by at most {} levels\n", level, changed, pixels, levels);
  }
}

TEST_F(SameBytes, IsNotPromisedWhereTheDriverWouldCrash) {
  const Ended ended = render({"LP_NATIVE_VECTOR_WIDTH=512"}, {"-o", "bad"});
  EXPECT_EQ(ended.status, 2);
  expect_one_line(ended.err);
  EXPECT_NE(ended.err.find("LP_NATIVE_VECTOR_WIDTH=512"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(*folder / "bad"));
}

}  // namespace same_bytes_test
}  // namespace plumb
