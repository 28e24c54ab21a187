#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/hdf5.h"
#include "engine/run/run_file.h"
#include "report/exports/export_formats.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace export_program_test {

/// A run of a swinging cable of two elements and one of three, made once.
class Export : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<TemporaryFolder>();
    for (const char* elements : {"2", "3"}) {
      const Ended ended = plumb_in(
          folder->path(), {"solve", case_path("pendulum.toml"), "-o", std::string("run") + elements, "--set",
                           "time.end=0.1", "--set", std::string("cable.elements=") + elements});
      ASSERT_EQ(ended.status, 0) << ended.err;
    }
  }
  static void TearDownTestSuite() { folder.reset(); }

  static Ended export_(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "export");
    return plumb_in(folder->path(), arguments);
  }
  static plumb::Run run_of(const std::string& name) { return read_run((*folder / name / "run.h5").string()); }

  /// What a script says: the numbers of each of its lines. Skips the test where it ends with 77.
  static std::vector<std::vector<double>> lines(const std::string& text) {
    std::vector<std::vector<double>> all;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      std::istringstream numbers(line);
      all.emplace_back();
      for (double number = 0; numbers >> number;) all.back().push_back(number);
    }
    return all;
  }

  static std::unique_ptr<TemporaryFolder> folder;
};
std::unique_ptr<TemporaryFolder> Export::folder;

constexpr std::size_t pieces = 8;  // of an element

/// Nodes of an exported state are those of the run, to the digit; `places`: three numbers a point.
void expect_nodes(const Trajectory& trajectory, std::size_t output, const double* places) {
  for (int node = 0; node <= trajectory.elements; ++node)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(places[3 * pieces * static_cast<std::size_t>(node) + static_cast<std::size_t>(c)],
                trajectory.q[output][6 * node + c])
          << "output " << output << ", node " << node << ", component " << c;
}

TEST_F(Export, VtkhdfHoldsEveryStateToTheDigitWhereItsStepsSayItIs) {
  ASSERT_EQ(export_({"run2", "--to", "vtkhdf"}).status, 0);
  const hdf5::Reader file(read_text(*folder / "run2/run.vtkhdf"));
  const Trajectory trajectory = run_of("run2").trajectory;
  const std::size_t steps = trajectory.times.size(), points = 2 * pieces + 1;
  EXPECT_EQ(file.numbers("VTKHDF/Steps/Values").values, trajectory.times);
  EXPECT_EQ(file.integers("VTKHDF/NumberOfPoints"), std::vector<long>{static_cast<long>(points)});
  const std::vector<double> places = file.numbers("VTKHDF/Points", {steps * points, 3});
  const std::vector<long> begin = file.integers("VTKHDF/Steps/PointOffsets");
  ASSERT_EQ(begin.size(), steps);
  for (std::size_t k = 0; k < steps; ++k)
    expect_nodes(trajectory, k, places.data() + 3 * static_cast<std::size_t>(begin[k]));
  const std::vector<double> speed = file.numbers("VTKHDF/PointData/velocity", {steps * points, 3});
  const auto tip = 3 * (static_cast<std::size_t>(begin.back()) + points - 1);
  for (int c = 0; c < 3; ++c)
    EXPECT_EQ(speed[tip + static_cast<std::size_t>(c)], trajectory.v.back()[12 + c]) << c;
}

TEST_F(Export, FieldsAreThoseOfTheProbes) {
  ASSERT_EQ(plumb_in(folder->path(),
                     {"solve", case_path("pendulum.toml"), "-o", "probed", "--set", "time.end=0.1", "--set",
                      "probe=[{name='mid',at=0.5},{name='tip',at=1},{name='f',at=0.25,"
                      "quantity='axial-force'},{name='m',at=0.25,quantity='bending-moment'}]"})
                .status,
            0);
  ASSERT_EQ(export_({"probed", "--to", "vtkhdf"}).status, 0);
  const hdf5::Reader file(read_text(*folder / "probed/run.vtkhdf"));
  const plumb::Run probed = run_of("probed");
  const std::size_t points = 4 * pieces + 1, last = (probed.trajectory.times.size() - 1) * points + pieces;
  for (const auto& [field, column] : {std::pair{"axial_force", 6}, {"bending_moment", 7}}) {
    const std::vector<double> values = file.numbers(std::string("VTKHDF/PointData/") + field).values;
    EXPECT_EQ(values.at(last), probed.probes.columns.at(static_cast<std::size_t>(column)).values.back())
        << field;
    EXPECT_NE(values.at(last), 0) << field;
  }
}

TEST_F(Export, RunsOfOtherTimesStandInOneFile) {
  ASSERT_EQ(plumb_in(folder->path(), {"solve", case_path("pendulum.toml"), "-o", "short", "--set",
                                      "time.end=0.05", "--set", "time.output_interval=0.05"})
                .status,
            0);
  ASSERT_EQ(export_({"run2", "short", "--to", "vtkhdf", "-o", "both.vtkhdf"}).status, 0);
  const hdf5::Reader file(read_text(*folder / "both.vtkhdf"));
  const std::vector<double> times = file.numbers("VTKHDF/Steps/Values").values;
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_EQ(times.back(), 0.1);
  EXPECT_EQ(file.integers("VTKHDF/CellData/run"), (std::vector<long>{0, 1}));
  EXPECT_EQ(file.texts("plumb/runs"), (std::vector<std::string>{"run2", "short"}));
  const std::vector<long> ended = file.integers("VTKHDF/CellData/ended");
  ASSERT_EQ(ended.size(), 2 * times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_EQ(ended[2 * k], 0) << times[k];
    EXPECT_EQ(ended[2 * k + 1], times[k] > 0.0501 ? 1 : 0) << times[k];
  }
}

TEST_F(Export, VtkReadsTheStatesThatTheRunHas) {
  for (const auto& [format, name] : {std::pair{"vtp", "run.pvd"}, {"vtkhdf", "run.vtkhdf"}}) {
    ASSERT_EQ(export_({"run3", "--to", format}).status, 0);
    const Ended seen =
        run_command({"/usr/bin/python3", std::string(PLUMB_SOURCE_DIR) + "/tests/vtk_states.py",
                     (*folder / "run3" / name).string()},
                    folder->path());
    if (seen.status == 77) GTEST_SKIP() << seen.out;
    ASSERT_EQ(seen.status, 0) << seen.err;
    const Trajectory trajectory = run_of("run3").trajectory;
    const std::vector<std::vector<double>> states = lines(seen.out);
    // VTK below 9.3 sees the first step of a VTKHDF file alone.
    ASSERT_TRUE(states.size() == trajectory.times.size() ||
                (format == std::string("vtkhdf") && states.size() == 1))
        << states.size();
    for (std::size_t k = 0; k < states.size(); ++k) {
      ASSERT_EQ(states[k].size(), 1 + 3 * (3 * pieces + 1));
      EXPECT_EQ(states[k].front(), trajectory.times[k]);
      expect_nodes(trajectory, k, states[k].data() + 1);
    }
    if (format == std::string("vtp")) {
      EXPECT_NE(seen.err.find("velocity [m/s] slope [1] axial_strain [1] axial_force [N] curvature [1/m] "
                              "bending_moment [N m]"),
                std::string::npos)
          << seen.err;
    }
  }
}

/// The two chunks of a GLB file.
struct GlbParts {
  nlohmann::json json;
  std::string bytes;

  std::vector<float> numbers(std::size_t accessor) const {
    const auto& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()];
    std::vector<float> result(view["byteLength"].get<std::size_t>() / sizeof(float));
    std::memcpy(result.data(), bytes.data() + view["byteOffset"].get<std::size_t>(),
                result.size() * sizeof(float));
    return result;
  }
};

GlbParts glb_parts(const std::string& file) {
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, file.data() + at, sizeof value);
    return static_cast<std::size_t>(value);
  };
  EXPECT_EQ(number(8), file.size());
  const std::size_t text = number(12);
  return {nlohmann::json::parse(file.substr(20, text)), file.substr(28 + text)};
}

TEST_F(Export, LastNodeOfTheGlbMovesAsTheTipDoes) {
  ASSERT_EQ(export_({"run2", "--to", "glb"}).status, 0);
  const GlbParts glb = glb_parts(read_text(*folder / "run2/run.glb"));
  const auto& animation = glb.json["animations"][0];
  const std::size_t tip = glb.json["skins"][0]["joints"].back();
  std::size_t channels = 0;
  for (const auto& channel : animation["channels"]) {
    if (channel["target"]["node"] != tip || channel["target"]["path"] != "translation") continue;
    ++channels;
    const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
    const std::vector<float> places = glb.numbers(sampler["output"]), times = glb.numbers(sampler["input"]);
    ASSERT_EQ(places.size(), 3 * times.size());
    const Trajectory trajectory = run_of("run2").trajectory;
    EXPECT_EQ(times.back(), static_cast<float>(trajectory.times.back()));
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(places[static_cast<std::size_t>(c)], static_cast<float>(trajectory.q.front()[12 + c])) << c;
      EXPECT_EQ(places[places.size() - 3 + static_cast<std::size_t>(c)],
                static_cast<float>(trajectory.q.back()[12 + c]))
          << c;
    }
  }
  EXPECT_EQ(channels, 1U);
}

TEST_F(Export, KhronosValidatorFindsNothingInTheGlb) {
  ASSERT_EQ(export_({"run2", "run3", "--to", "glb", "-o", "two.glb"}).status, 0);
  const Ended said = run_command({"env", "NODE_PATH=" PLUMB_SOURCE_DIR "/node_modules", "node",
                                  std::string(PLUMB_SOURCE_DIR) + "/tests/gltf_validator.js", "two.glb"},
                                 folder->path());
  if (said.status == 77 || said.status == 127) GTEST_SKIP() << said.out << said.err;
  EXPECT_EQ(said.status, 0) << said.out;
}

TEST_F(Export, TheSameRunGivesTheSameBytes) {
  for (const ExportFormat& format : export_formats()) {
    if (format.many_files) continue;
    std::string bytes[2];
    for (std::string& one : bytes) {
      ASSERT_EQ(export_({"run2", "--to", std::string(format.name), "-o", "same"}).status, 0);
      one = read_text(*folder / "same");
    }
    EXPECT_EQ(bytes[0], bytes[1]) << format.name;
  }
}

TEST_F(Export, ExportsStayWithTheirRunAndGoWithIt) {
  const std::vector<std::string> solve{"solve",       case_path("pendulum.toml"), "-o", "kept", "--set",
                                       "time.end=0.1"};
  ASSERT_EQ(plumb_in(folder->path(), solve).status, 0);
  for (const char* format : {"vtkhdf", "vtp", "glb"}) ASSERT_EQ(export_({"kept", "--to", format}).status, 0);
  ASSERT_EQ(plumb_in(folder->path(), {"render", "kept", "--frames", "0", "--size", "64x36"}).status, 0);
  const std::vector<std::string> files{"run.vtkhdf", "run.pvd", "vtp/0000.vtp", "vtp/0005.vtp", "run.glb"};
  for (const std::string& file : files) EXPECT_TRUE(fs::exists(*folder / "kept" / file)) << file;
  ASSERT_EQ(plumb_in(folder->path(), solve).status, 0);
  for (const std::string& file : files) EXPECT_FALSE(fs::exists(*folder / "kept" / file)) << file;
}

TEST_F(Export, RefusesWhatCannotBeMeant) {
  struct Refused {
    std::vector<std::string> arguments;
    int status;
    const char* words;
  };
  for (const Refused& refused :
       {Refused{{"run2", "--to", "obj"}, 2, "--to obj: must be one of vtkhdf, vtp, glb"},
        {{"run2"}, 2, "--to is required"},
        {{"run2", "--to", ""}, 2, "--to"},
        {{"run2", "run3", "--to", "glb"}, 2, "-o says where it goes"},
        {{"missing", "--to", "glb"}, 3, "missing"},
        {{"run2", "--to", "glb", "-o", "nowhere/a.glb"}, 5, "there is no folder"},
        {{"run2", "--to", "glb", "-o", "-"}, 2, "-o -"},
        {{"run2", "--to", "glb", "-o", "run2/run.h5"}, 2, "is what is read"}}) {
    const Ended ended = export_(refused.arguments);
    EXPECT_EQ(ended.status, refused.status) << ended.err;
    EXPECT_NE(ended.err.find(refused.words), std::string::npos) << ended.err;
    expect_one_line(ended.err);
  }
}

}  // namespace export_program_test
}  // namespace plumb
