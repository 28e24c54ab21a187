#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/hdf5.h"
#include "tests/engine/given_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace given_run_faults_test {

/// A file, keys of its [[run]], and the whole error that it must give.
struct Fault {
  std::string file;
  std::string keys;
  std::string expected;
};

void expect_refused(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    const std::string message = refusal(given_case(fault.file, fault.keys));
    EXPECT_TRUE(matches(message, fault.expected))
        << "file:     " << fault.file.substr(0, fault.file.find('\0')).substr(0, 60)
        << "\nkeys:     " << fault.keys << "\nrefused:  " << message << "\nexpected: " << fault.expected;
  }
}

const std::string good = "t,tip.y\n0,0\n1,-1\n";

TEST(GivenRunFaults, OfARigidRodNeedsNoMethod) {
  CaseSource source =
      given_case("t,tip.x,tip.y,tip.z\n0,1,0,0\n0.5,1,0,0\n1,1,0,0\n", "columns = { strain = \"\" }");
  source.overrides = {"cable.model=rigid", "probe.1.quantity=position", "supports.first=pinned"};
  EXPECT_EQ(refusal(source).find("method"), std::string::npos) << refusal(source);
}

TEST(GivenRunFaults, AMissingColumnIsRefusedWithTheNearestNameAndWhatIsThere) {
  expect_refused({
      {"t,tip_y\n0,0\n", "",
       "case.toml:…chrono.csv has no column of the probes, as tip.x; did you mean \"tip_y\"? The file has: "
       "t, tip_y"},
      {"t,tip.x,tip_y\n0,0,0\n1,0,0\n", "",
       "case.toml:…chrono.csv has no column tip.y, which the reference known needs; name the file's own for "
       "it, or "
       "say that there is none by \"tip.y\" = \"\""},
      {"Time,tip.y\n0,0\n", "",
       "case.toml:…chrono.csv has no column \"t\" for the time; did you mean \"Time\"? The file has: Time, "
       "tip.y; "
       "name it, as in columns = { t = \"Time\" }"},
      {"t,Y tip\n0,0\n", "columns = { \"tip.y\" = \"Y tp\" }",
       "case.toml:4:23: run.0.columns.tip.y = \"Y tp\": chrono.csv has no such column; did you mean \"Y "
       "tip\"? The "
       "file has: t, Y tip"},
      {good, "columns = { \"tp.y\" = \"tip.y\" }",
       "case.toml:4:13: run.0.columns.tp.y = \"tip.y\": not a column of the probes; did you mean \"tip.y\"?"},
  });
}

TEST(GivenRunFaults, TimesThatDoNotRiseAreRefusedWithTheRow) {
  expect_refused({
      {"t,tip.y\n0,0\n1,0\n1,0\n", "",
       "chrono.csv:4:1: t = 1 s: must be greater than the time before it, 1 s"},
      {"tip.y,t\n0,0\n0,2\n\n0,1.5\n", "",
       "chrono.csv:5:3: t = 1.5 s: must be greater than the time before it, 2 s"},
      {"t,tip.y\n-2,0\n-1,0\n", "",
       "case.toml:…run.0.file = \"chrono.csv\": ends at -1 s; must end after 0 s"},
  });
}

TEST(GivenRunFaults, CellsThatAreNoFiniteNumbersAreRefusedWithTheirPlace) {
  expect_refused({
      {"t,tip.y\n0,nan\n", "", "chrono.csv:2:3: tip.y = \"nan\": must be a finite number"},
      {"t,tip.y\n0,0\n1,-inf\n", "", "chrono.csv:3:3: tip.y = \"-inf\": must be a finite number"},
      {"t,tip.y\n0,1e999\n", "", "chrono.csv:2:3: tip.y = \"1e999\": must be a finite number"},
      {"t,tip.y\n0,\n", "", "chrono.csv:2:3: tip.y = \"\": is empty; must be a finite number"},
      {"t,tip.y\nstart,0\n", "", "chrono.csv:2:1: t = \"start\": must be a finite number"},
      {"t,tip.y\n0,1.5 mm\n", "", "chrono.csv:2:3: tip.y = \"1.5 mm\": must be a finite number"},
      {"t,tip.y\n0,1e308\n", "units = { \"tip.y\" = \"km\" }", "chrono.csv:2:3: is not finite in m"},
  });
}

TEST(GivenRunFaults, CommasAsDecimalsBetweenCommasAreRefusedWithTheWayOut) {
  expect_refused({
      {"t,tip.y\n0,5,1,2\n", "",
       "chrono.csv:2:5: the row has 4 cells, the header has 2; decimals with commas need columns separated "
       "by "
       "semicolons"},
      {"t,tip.y\n0,\"1,5\"\n", "",
       "chrono.csv:2:3: tip.y = \"1,5\": must be a finite number; decimals with commas need columns "
       "separated by "
       "semicolons"},
      {"t;tip.y\n0;1,5\n1;2.5\n", "",
       "chrono.csv:2:3: \"1,5\" has a comma and \"2.5\" at chrono.csv:3:3 a point: it cannot be told which "
       "is the "
       "decimal sign"},
      {"t;tip.y\n0;1,234,567\n", "", "chrono.csv:2:3: tip.y = \"1,234,567\": must be a finite number"},
  });
}

TEST(GivenRunFaults, RowsAndHeadersThatDoNotFitAreRefused) {
  expect_refused({
      {"t,tip.x,tip.y\n0,0,0\n1,0\n", "", "chrono.csv:3:3: the row has 2 cells, the header has 3"},
      {"t,tip.x,tip.y\n0,0,0,7\n", "", "chrono.csv:2:7: the row has 4 cells, the header has 3"},
      {"t,tip.y,tip.y [mm]\n0,0,0\n", "",
       "chrono.csv:1:9: the column \"tip.y\" is there twice, first at chrono.csv:1:3"},
      {"t,,tip.y\n0,0,0\n", "", "chrono.csv:1:3: a column has no name"},
      {"t,tip.y\n", "", "chrono.csv: has a header and no rows"},
      {"0,1\n2,3\n", "",
       "chrono.csv:1:1: \"0\" is a number where the header must be: the first line must name the columns"},
      {"# t,tip.y\n0,1\n2,3\n", "",
       "chrono.csv:2:1: \"0\" is a number where the header must be: the first line must name the columns "
       "(lines that begin with #, %, ! or // are passed over)"},
      {"\n\n", "", "chrono.csv: has no header: the first line must name the columns"},
      {"", "", "case.toml:…run.0.file = \"chrono.csv\": is empty"},
      {"t,\"tip.y\n0,0\n", "", "chrono.csv:1:3: a quote is not closed"},
      {std::string("t,tip.y\n0,\0\n", 12), "", "chrono.csv: is neither HDF5 nor text: it holds a 0 byte"},
  });
}

TEST(GivenRunFaults, UnitsThatAreUnknownOrOfAnotherDimensionAreRefused) {
  expect_refused({
      {"t,tip.y [s]\n0,0\n", "",
       "chrono.csv:1:3: tip.y [s]: the unit is a unit of time, not of length; allowed: m, mm,…units of the "
       "[[run]] may name "
       "another"},
      {good, "units = { \"tip.y\" = \"mim\" }",
       "case.toml:4:21: run.0.units.tip.y = \"mim\": is no known unit; did you mean \"mm\"?; allowed: m, mm, "
       "cm, um, "
       "µm, km, in, ft"},
      {good, "units = { t = \"N\" }",
       "case.toml:4:15: run.0.units.t = \"N\": is a unit of force, not of time; allowed: s, ms, us, µs, min"},
      {good, "units = { time = \"ms\" }",
       "case.toml:4:11: run.0.units.time = \"ms\": not a column of the probes;…"},
  });
}

TEST(GivenRunFaults, ARunsOwnKeysAreChecked) {
  expect_refused({
      {good, "name = \"a b\"", "case.toml:4:8: run.0.name = \"a b\": must be letters, digits, - and _,…"},
      {good, "name = \"Plumb\"", "case.toml:4:8: run.0.name = \"Plumb\": is the name of Plumb's own run"},
      {good, "name = \"known\"", "case.toml:4:8: run.0.name = \"known\": is the name of a reference"},
      {good, "nam = \"a\"", "case.toml:4:1: run.0.nam = \"a\":…did you mean \"name\"?"},
      {good, "tolerances = { \"tip.y\" = -1 }",
       "case.toml:4:26: run.0.tolerances.tip.y = -1: must be a number greater than 0 (m)"},
      {good, "tolerances = { \"tip.y\" = 1 }",
       "case.toml:…the run is the one that is reported, and has no distance to itself"},
      {good, "[[run]]\nfile = \"chrono.csv\"", "case.toml:…must differ from that of every other run…"},
      {good, "[[run]]\nfile = \"other.csv\"", "case.toml:5:8: run.1.file = \"other.csv\": cannot be read:…"},
      {good, "[study.sweep]", "case.toml:…belongs to runs of Plumb's own; a case without [method] has none"},
  });
}

TEST(GivenRunFaults, ACaseWithNeitherMethodNorRunIsRefused) {
  CaseSource source = given_case(good);
  source.file.text = with(source.file.text, "[[run]]\nfile = \"chrono.csv\"\n", "");
  EXPECT_TRUE(matches(refusal(source), "case.toml:…method…a table [method], or a [[run]]…"))
      << refusal(source);
}

TEST(GivenRunFaults, AFigureOfTheReportedRunNeedsItsColumns) {
  const std::string message = refusal(given_case(good, "", "[[figure]]\nname = \"far\"\ny = \"tip.x\"\n"));
  EXPECT_TRUE(matches(message,
                      "case.toml:…chrono.csv has no column tip.x, which the figure far needs; the run that "
                      "is reported must have it"))
      << message;
}

TEST(GivenRunFaults, Hdf5ThatDoesNotFitIsRefusedWithItsDataSet) {
  const auto file = [](std::size_t rows, double last, const char* unit) {
    hdf5::Writer writer;
    const std::vector<double> times{0, 1, 2}, heights{0, 0, last};
    writer.numbers("time", {3}, times.data(), "s");
    writer.numbers("probes/tip.y", {rows}, heights.data() + 3 - rows, unit);
    return writer.bytes();
  };
  expect_refused({
      {file(2, 0, "m"), "", "chrono.csv: probes/tip.y: the column has 2 rows, that of the time 3"},
      {file(3, std::nan(""), "m"), "", "chrono.csv: probes/tip.y[2]:…nan: must be a finite number"},
      {file(3, 0, "s"), "",
       "chrono.csv: probes/tip.y: probes/tip.y [s]: the unit is a unit of time, not of length;…"},
      {file(3, 0, "m").substr(0, 600), "", "chrono.csv: cannot be used: it is no HDF5 file"},
      {hdf5::Writer().bytes(), "", "chrono.csv: holds no data set of numbers of one dimension"},
  });
}

}  // namespace given_run_faults_test
}  // namespace plumb
