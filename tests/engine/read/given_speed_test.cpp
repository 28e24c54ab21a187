#include <gtest/gtest.h>

#include "tests/engine/given_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace given_speed_test {

const std::string tip = "t,tip.x,tip.y,tip.z\n0,1,0,0\n1,1,-1,0\n";

/// A case with a method of Plumb's own and the run `keys`, of files a.csv and b.csv.
CaseSource timed_case(const std::string& keys, const std::string& probe = "at = 1",
                      const std::string& a = tip) {
  CaseSource source;
  source.file = {"case.toml", R"(title = "Timed"
[method]
name = "rk4"
step = 1e-3
[time]
end = 1
output_interval = 0.1
)" + std::string(soft_cable) + "elements = 2\n[[probe]]\nname = \"tip\"\n" +
                                  probe + "\n[[run]]\n" + keys};
  source.given_runs = {{"a.csv", a}, {"b.csv", "Time [ms],X,Y,Z\n0,1,0,0\n1000,1,-1,0\n"}};
  return source;
}

const std::string point_of_b = R"([[run.point]]
file = "b.csv"
seconds = 0.5
columns = { t = "Time", "tip.x" = "X", "tip.y" = "Y", "tip.z" = "Z" }
)";

TEST(GivenSpeed, ARunAndItsPointsHaveTimesThreadsAMachineAndItsYardstick) {
  const LoadedCase loaded = load_case(
      timed_case("file = \"a.csv\"\nseconds = 0.25\nthreads = 4\nmachine = \"laptop\"\nyardstick = 0.125\n" +
                 point_of_b));
  const GivenRunSpec& spec = loaded.spec.given_runs.at(0);
  EXPECT_EQ(spec.seconds, 0.25);
  EXPECT_EQ(spec.threads, 4);
  EXPECT_EQ(spec.machine, "laptop");
  EXPECT_EQ(spec.yardstick, 0.125);
  ASSERT_EQ(spec.points.size(), 1U);
  EXPECT_EQ(spec.points[0].label, "b");
  EXPECT_EQ(spec.points[0].seconds, 0.5);
  const GivenRun& run = loaded.given_runs.at(0);
  ASSERT_EQ(run.points.size(), 1U);
  EXPECT_EQ(run.points[0].times, (std::vector<double>{0, 1}));
  EXPECT_EQ(run.points[0].find("tip.y")->values, (std::vector<double>{0, -1}));
  EXPECT_EQ(loaded.source.given_runs.size(), 2U) << "the texts of all are kept with the case";
}

TEST(GivenSpeed, WithoutAFileOfItsOwnTheLastPointIsTheRun) {
  const LoadedCase loaded =
      load_case(timed_case("name = \"x\"\n[[run.point]]\nfile = \"a.csv\"\nseconds = 1\n" + point_of_b));
  EXPECT_EQ(loaded.spec.given_runs.at(0).file, "b.csv");
  EXPECT_EQ(loaded.given_runs.at(0).time_unit, "ms");
  EXPECT_EQ(loaded.given_runs.at(0).points.size(), 2U);
}

TEST(GivenSpeed, PointsTakeColumnsAndUnitsOfTheirRun) {
  const LoadedCase loaded = load_case(timed_case(
      "columns = { t = \"Time\", \"tip.x\" = \"X\", \"tip.y\" = \"Y\", \"tip.z\" = \"Z\" }\nunits = { "
      "\"tip.x\" = \"mm\" }\n[[run.point]]\nfile = \"b.csv\"\nseconds = 1\nunits = { \"tip.y\" = \"cm\" "
      "}\n"));
  const GivenRun& point = loaded.given_runs.at(0).points.at(0);
  EXPECT_EQ(point.find("tip.x")->values[0], 1e-3);
  EXPECT_EQ(point.find("tip.y")->values[1], -1e-2);
  EXPECT_EQ(point.find("tip.z")->file_unit, "m");
}

TEST(GivenSpeed, BadValuesAreRefusedWhereTheyStand) {
  const std::string a = "file = \"a.csv\"\n", timed = a + "seconds = 1\n";
  const std::string point = "[[run.point]]\nfile = \"a.csv\"\nseconds = 1\n";
  const struct {
    std::string keys, expected;
  } faults[] = {
      {a + "seconds = 0\n", "case.toml:19:11: run.0.seconds = 0: must be a number greater than 0 (s)"},
      {a + "seconds = -1\n", "case.toml:19:11: run.0.seconds = -1: must be a number greater than 0 (s)"},
      {a + "seconds = \"fast\"\n", "case.toml:19:12: run.0.seconds = \"fast\": unknown parameter…"},
      {timed + "threads = 0\n", "case.toml:20:11: run.0.threads = 0: must be a whole number from 1 …"},
      {timed + "threads = 1.5\n", "case.toml:20:11: run.0.threads = 1.5: must be a whole number from 1 …"},
      {timed + "machine = \"\"\n",
       "case.toml:20:11: run.0.machine = \"\": must not be empty: the name of the machine that it ran on"},
      {timed + "machine = 3\n", "case.toml:20:11: run.0.machine = 3: must be a string…"},
      {timed + "yardstick = 0\n",
       "case.toml:20:13: run.0.yardstick = 0: must be a number greater than 0 (s)"},
      {timed + "second = 1\n", "case.toml:20:1: run.0.second…seconds…"},
      {a + "threads = 2\n",
       "case.toml:19:11: run.0.threads = 2: belongs to seconds or [[run.point]], of which the run has none"},
      {a + "machine = \"m\"\n",
       "case.toml:19:11: run.0.machine = \"m\": belongs to seconds or [[run.point]], of which the run has "
       "none"},
      {a + "yardstick = 1\n",
       "case.toml:19:13: run.0.yardstick = 1: belongs to seconds or [[run.point]], of which the run has "
       "none"},
      {a + "[[run.point]]\nseconds = 1\n", "case.toml:19:…run.0.point.0.file: missing; required: …"},
      {"[[run.point]]\nseconds = 1\n", "case.toml:18:…run.0.point.0.file: missing; required: …"},
      {a + "[[run.point]]\nfile = \"a.csv\"\n", "case.toml:19:…run.0.point.0.seconds: missing; required: …"},
      {a + "[[run.point]]\nfile = \"a.csv\"\nseconds = 0\n",
       "case.toml:21:11: run.0.point.0.seconds = 0: must be a number greater than 0 (s)"},
      {a + "[[run.point]]\nfile = \"no.csv\"\nseconds = 1\n",
       "case.toml:20:8: run.0.point.0.file = \"no.csv\": cannot be read…"},
      {a + "[[run.point]]\nfile = \"a.csv\"\nseconds = 1\nlable = \"x\"\n",
       "case.toml:22:1: run.0.point.0.lable…label…"},
      {a + "[[run.point]]\nfile = \"a.csv\"\nseconds = 1\nlabel = \"\"\n",
       "case.toml:22:9: run.0.point.0.label = \"\"…"},
      {a + point + point,
       "case.toml:22:…run.0.point.1.label: must differ from that of every other point of the run "
       "(it is \"a\", from the file's name, unless given)"},
      {a + "[[run.point]]\nfile = \"b.csv\"\nseconds = 1\n",
       "case.toml:19:…run.0.point.0.columns: b.csv has no column \"t\" for the time…"},
      {a + "[[run.point]]\nfile = \"a.csv\"\nseconds = 1\ncolumns = { \"tip.y\" = \"high\" }\n",
       "case.toml:22:…run.0.point.0.columns.tip.y = \"high\": a.csv has no such column…"},
  };
  for (const auto& fault : faults) {
    const std::string message = refusal(timed_case(fault.keys));
    EXPECT_TRUE(matches(message, fault.expected))
        << fault.keys << "refused:  " << message << "\nexpected: " << fault.expected;
  }
}

TEST(GivenSpeed, ATimeNeedsThePositionOfTheTip) {
  const std::string timed = "file = \"a.csv\"\nseconds = 1\n";
  for (const char* probe : {"at = 0.5", "at = 1\nquantity = \"velocity\""}) {
    const std::string message = refusal(timed_case(timed, probe));
    EXPECT_TRUE(matches(message,
                        "case.toml:…run.0.seconds = 1: is shown beside the error of the tip; give "
                        "the case a [[probe]] with at = 1, of the position"))
        << message;
  }
  const std::string flat = "t,tip.x,tip.y\n0,1,0\n1,1,-1\n";
  const std::string message = refusal(timed_case(timed, "at = 1", flat));
  EXPECT_TRUE(matches(message,
                      "case.toml:18:8: run.0.file = \"a.csv\": has no column tip.z, which the error "
                      "beside its seconds needs; name the file's own for it in columns"))
      << message;
  const std::string of_point = refusal(timed_case(
      "name = \"x\"\n[[run.point]]\nfile = \"a.csv\"\nseconds = 1\n" + point_of_b, "at = 1", flat));
  EXPECT_TRUE(matches(of_point, "case.toml:20:8: run.0.point.0.file = \"a.csv\": has no column tip.z…"))
      << of_point;
  EXPECT_EQ(refusal(timed_case("file = \"a.csv\"\n", "at = 1", flat)), "accepted") << "which has no time";
}

TEST(GivenSpeed, OneTimeIsNotThatOfManyFiles) {
  for (const std::string key : {"seconds = 1\n", "[[run.point]]\nfile = \"a.csv\"\nseconds = 1\n"}) {
    const std::string message = refusal(timed_case("file = \"*.csv\"\n" + key));
    EXPECT_TRUE(matches(message,
                        "case.toml:19:…is of one run, but file stands for several; give each a "
                        "[[run]] or a [[run.point]] of its own"))
        << message;
  }
}

}  // namespace given_speed_test
}  // namespace plumb
