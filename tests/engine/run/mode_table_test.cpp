#include "engine/run/mode_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "engine/integrate/integrate.h"
#include "engine/run/run_file.h"
#include "tests/engine/made_case.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace mode_table_test {

constexpr double pi = std::numbers::pi;

/// A pinned cable of 2 m whose modes were found, with probes at its middle.
plumb::Run found_modes(const std::string& more = "") {
  plumb::Run run{
      load_case(CaseSource{
          {"wire.toml",
           std::string("title = \"Wire\"\n") + soft_cable +
               "elements = 16\n[supports]\nfirst = \"pinned\"\nlast = \"pinned\"\n[method]\nname = "
               "\"modes\"\ncount = 4\n[[probe]]\nname = \"mid\"\nat = 0.5\nquantity = "
               "\"position\"\n[[probe]]\nname = \"bend\"\nat = 0.5\nquantity = "
               "\"curvature\"\n[[probe]]\nname = \"speed\"\nat = 0.5\nquantity = \"velocity\"\n" +
               more},
          {},
          {}}),
      {},
      {},
      {}};
  run.trajectory = integrate(run.loaded.spec);
  run.probes = probe(run.loaded.spec, run.trajectory);
  run.modes = mode_table(run.loaded.spec, run.trajectory);
  return run;
}

TEST(ModeTable, ProbesSeeAShapeWhoseGreatestDisplacementIsOneMetre) {
  const plumb::Run run = found_modes();
  ASSERT_EQ(run.trajectory.outcome, Outcome::completed) << run.trajectory.message;
  const ProbeTable& table = run.modes;
  EXPECT_EQ(table.times, (std::vector<double>{1, 2, 3, 4}));
  const auto value = [&](const char* column, std::size_t mode) {
    return table.find(column)->values[mode - 1];
  };
  EXPECT_NEAR(value("mid.y", 1), 1, 1e-9);
  EXPECT_NEAR(value("mid.z", 2), 1, 1e-9);
  EXPECT_NEAR(value("mid.y", 3), 0, 1e-6) << "a node of the second vibration";
  EXPECT_NEAR(value("bend", 1), pi * pi / 4, 1e-2) << "of sin(πx/L)";
  EXPECT_NEAR(value("speed.y", 1), 2 * pi * value("frequency", 1), 1e-9 * value("angular_frequency", 1));
  EXPECT_NEAR(value("angular_frequency", 1), 2 * pi * value("frequency", 1),
              1e-12 * value("angular_frequency", 1));
}

TEST(ModeTable, OfAMotionIsEmpty) {
  const Case spec = tiny_pendulum("0.01", "").spec;
  EXPECT_TRUE(mode_table(spec, integrate(spec)).columns.empty());
}

TEST(ModeTable, CsvHasALineAModeWithItsKind) {
  const plumb::Run run = found_modes();
  const std::string csv = modes_csv(run.trajectory, run.modes);
  EXPECT_TRUE(csv.starts_with(
      "mode,kind,frequency [Hz],angular_frequency [rad/s],damping_ratio [1],decay [1/s],mid.x [m]"))
      << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_NE(csv.find("\n4,vibration,"), std::string::npos) << csv;
}

TEST(RunFile, KeepsModesToTheLastBit) {
  for (const char* more : {"", "[damping]\nmaterial = 1e-3\n"}) {
    const plumb::Run run = found_modes(more);
    ASSERT_EQ(run.trajectory.outcome, Outcome::completed) << run.trajectory.message;
    const std::string path = (std::filesystem::temp_directory_path() / "plumb_modes_run.h5").string();
    std::ofstream(path, std::ios::binary) << encode_run(run);
    const plumb::Run read = read_run(path);
    std::filesystem::remove(path);
    const std::vector<VibrationMode>&wrote = run.trajectory.vibrations.modes,
          &back = read.trajectory.vibrations.modes;
    ASSERT_EQ(back.size(), wrote.size());
    for (std::size_t k = 0; k < wrote.size(); ++k) {
      EXPECT_EQ(back[k].kind, wrote[k].kind);
      EXPECT_EQ(back[k].frequency, wrote[k].frequency);
      EXPECT_EQ(back[k].damping_ratio, wrote[k].damping_ratio);
      EXPECT_EQ(back[k].shape, wrote[k].shape);
      EXPECT_EQ(back[k].quadrature, wrote[k].quadrature);
    }
    EXPECT_EQ(modes_csv(read.trajectory, read.modes), modes_csv(run.trajectory, run.modes));
  }
}

}  // namespace mode_table_test
}  // namespace plumb
