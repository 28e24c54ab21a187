#include "engine/case/given_run.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/hdf5.h"
#include "tests/engine/given_case.h"

namespace plumb {
namespace given_run_test {

using Numbers = std::vector<double>;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

GivenRun read(const std::string& file, const std::string& run_keys = "") {
  return load_case(given_case(file, run_keys)).given_runs.at(0);
}

const std::string plain = "t,tip.y\n0,0\n0.5,-0.25\n1,-1\n";

TEST(GivenRun, ATableWithTheNamesOfTheProbesNeedsNothingMore) {
  const LoadedCase loaded = load_case(given_case(plain));
  const GivenRun& run = loaded.given_runs.at(0);
  EXPECT_EQ(run.times, (Numbers{0, 0.5, 1}));
  ASSERT_EQ(run.columns.size(), 1U);
  EXPECT_EQ(run.columns[0].name, "tip.y");
  EXPECT_EQ(run.columns[0].values, (Numbers{0, -0.25, -1}));
  EXPECT_EQ(run.columns[0].file_unit, "m");
  EXPECT_TRUE(run.notes.empty()) << joined(run.notes);
  EXPECT_EQ(loaded.spec.given_runs[0].name, "chrono");
  EXPECT_TRUE(reports_given_run(loaded.spec));
  EXPECT_EQ(reported_name(loaded.spec), "chrono");
  EXPECT_EQ(loaded.spec.time.end, 1) << "where the file ends, without [time]";
}

TEST(GivenRun, ItsOwnNamesAndUnitsAreMappedToThoseOfTheProbes) {
  const GivenRun run =
      read("Clock;X tip;Y tip;eps\n0;1;2;3\n250;4;5;6\n",
           "columns = { t = \"Clock\", \"tip.x\" = \"X tip\", \"tip.y\" = \"Y tip\", strain = "
           "\"eps\" }\nunits = { t = \"ms\", \"tip.x\" = \"mm\", \"tip.y\" = \"ft\", strain = \"%\" }");
  EXPECT_EQ(run.times, (Numbers{0, 0.25}));
  ASSERT_EQ(run.columns.size(), 3U);
  EXPECT_EQ(run.find("tip.x")->values, (Numbers{1 * 1e-3, 4 * 1e-3}));
  EXPECT_EQ(run.find("tip.y")->values, (Numbers{2 * 0.3048, 5 * 0.3048}));
  EXPECT_EQ(run.find("strain")->values, (Numbers{3 * 1e-2, 6 * 1e-2}));
  EXPECT_EQ(run.find("tip.x")->file_column, "X tip");
  EXPECT_EQ(run.find("tip.x")->unit, "m");
  EXPECT_EQ(run.find("tip.z"), nullptr);
}

TEST(GivenRun, AUnitInTheHeaderIsUsedAndOneInTheCaseGoesBeforeItWithARemark) {
  const std::string file = "t [ms],tip.y [mm]\n0,0\n1000,-1000\n";
  EXPECT_EQ(read(file).times, (Numbers{0, 1}));
  EXPECT_EQ(read(file).columns[0].values, (Numbers{0, -1}));
  const GivenRun run = read(file, "units = { \"tip.y\" = \"m\" }");
  EXPECT_EQ(run.columns[0].values, (Numbers{0, -1000}));
  EXPECT_EQ(joined(run.notes), "the column tip.y is read in m, as the case says, though the file says mm\n");
}

TEST(GivenRun, SemicolonsAndDecimalCommasAreReadAndSaidSo) {
  const LoadedCase loaded = load_case(given_case("t;tip.y\n0;0\n0,5;-0,25\n1;-1e0\n"));
  EXPECT_EQ(loaded.given_runs[0].times, (Numbers{0, 0.5, 1}));
  EXPECT_EQ(loaded.given_runs[0].columns[0].values, (Numbers{0, -0.25, -1}));
  EXPECT_EQ(joined(loaded.given_runs[0].notes),
            "its columns are separated by semicolons\nthe commas in its numbers are read as decimal signs\n");
  const auto& remarks = loaded.remarks;
  EXPECT_NE(std::find(remarks.begin(), remarks.end(),
                      "chrono.csv: the commas in its numbers are read as decimal signs"),
            remarks.end())
      << joined(remarks);
}

TEST(GivenRun, TabulatorsByteOrderMarksCarriageReturnsQuotesCommentsAndSpareCellsDoNoHarm) {
  const Numbers times{0, 1}, heights{0, -1};
  for (const std::string& file :
       {std::string("t\ttip.y\n0\t0\n1\t-1\n"), std::string("\xEF\xBB\xBFt,tip.y\r\n0,0\r\n1,-1\r\n"),
        std::string("\"t [s]\",\"tip.y\"\n\"0\",\"0\"\n1,\"-1\"\n"),
        std::string("# made by chrono\n#\n\nt,tip.y\n0,0\n\n1,-1"), std::string("t,tip.y,\n0,0,\n1,-1,\n"),
        std::string("note,t,tip.y\nstart,+0,0.0\nnan,1,-1e0\n"),
        std::string(" t , tip.y [m] \n 0 , 0 \n 1 , -1 \n")}) {
    const GivenRun run = read(file);
    EXPECT_EQ(run.times, times) << file;
    EXPECT_EQ(run.columns.at(0).values, heights) << file;
  }
}

TEST(GivenRun, Hdf5IsReadByItsDataSetsAndTheirUnitsWholeNumbersToo) {
  hdf5::Writer file;
  const Numbers times{0, 500, 1000}, heights{0, -250, -1000};
  file.numbers("time", {3}, times.data(), "ms");
  file.numbers("probes/tip.y", {3}, heights.data(), "mm");
  file.integers("strange/strain", {1, 2, 3});
  file.text("title", "not a column");
  const GivenRun run = read(file.bytes(), "columns = { strain = \"strange/strain\" }");
  EXPECT_EQ(run.times, (Numbers{0, 0.5, 1}));
  EXPECT_EQ(run.find("tip.y")->values, (Numbers{0, -0.25, -1}));
  EXPECT_EQ(run.find("tip.y")->file_column, "probes/tip.y");
  EXPECT_EQ(run.find("strain")->values, (Numbers{1, 2, 3}));
}

TEST(GivenRun, BesideAMethodItIsReadAndNotTheOneThatIsReported) {
  CaseSource source =
      given_case(plain, "tolerances = { \"tip.y\" = 0.5 }\nreason = \"far\"",
                 "[method]\nname = \"rk4\"\nstep = 0.01\n[time]\nend = 1\noutput_interval = 0.5\n");
  source.overrides = {"cable.elements=2"};
  const LoadedCase loaded = load_case(source);
  EXPECT_FALSE(reports_given_run(loaded.spec));
  EXPECT_EQ(reported_name(loaded.spec), "Plumb");
  EXPECT_EQ(loaded.spec.given_runs.at(0).tolerances.at("tip.y"), 0.5);
  EXPECT_EQ(loaded.given_runs.at(0).times.size(), 3U);
}

TEST(GivenRun, WhatItDoesNotHaveMayBeLeftOutInSoManyWords) {
  const LoadedCase loaded = load_case(given_case("t,tip.x\n0,1\n1,2\n", "columns = { \"tip.y\" = \"\" }"));
  EXPECT_EQ(loaded.given_runs[0].find("tip.y"), nullptr);
  EXPECT_NE(loaded.given_runs[0].find("tip.x"), nullptr);
}

TEST(GivenRun, ItsFileIsKeptWithTheCase) {
  const LoadedCase loaded = load_case(given_case(plain));
  ASSERT_EQ(loaded.source.given_runs.size(), 1U);
  EXPECT_EQ(loaded.source.given_runs[0].name, "chrono.csv");
  EXPECT_EQ(loaded.source.given_runs[0].text, plain);
  EXPECT_EQ(load_case(loaded.source).given_runs[0].times, loaded.given_runs[0].times);
}

}  // namespace given_run_test
}  // namespace plumb
