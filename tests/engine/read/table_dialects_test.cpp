#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/base/csv.h"
#include "engine/base/file_text.h"
#include "engine/read/table_number.h"
#include "engine/read/table_text.h"
#include "tests/engine/given_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace table_dialects_test {

std::string data(const std::string& name) {
  return read_whole_file(std::string(PLUMB_TEST_DATA) + "/" + name, InputKind::given_run);
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text + "\n";
  return all;
}

/// All of them are the tip at (1 - t², -t²) at 0, 0.5 and 1 s.
void expect_the_tip(const std::string& file, const std::string& keys, const std::string& taken_for,
                    const std::vector<std::string>& notes) {
  const LoadedCase loaded = load_case(given_case(file, keys));
  const GivenRun& run = loaded.given_runs.at(0);
  EXPECT_EQ(run.times, (std::vector<double>{0, 0.5, 1}));
  ASSERT_EQ(run.columns.size(), 2U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(run.columns[0].values[k], 1 - run.times[k] * run.times[k], 1e-15);
    EXPECT_NEAR(run.columns[1].values[k], -run.times[k] * run.times[k], 1e-15);
  }
  EXPECT_EQ(run.taken_for, taken_for);
  for (const std::string& note : notes)
    EXPECT_NE(joined(run.notes).find(note), std::string::npos) << note << " is not in\n" << joined(run.notes);
  EXPECT_NE(joined(loaded.remarks).find(run.notes.front()), std::string::npos) << joined(loaded.remarks);
}

TEST(TableDialects, ColumnsBetweenBlanksWithARowOfUnitsAreRead) {
  expect_the_tip(
      data("moordyn.out"), "columns = { t = \"Time\", \"tip.x\" = \"TipPx\", \"tip.y\" = \"TipPy\" }",
      "a table whose columns are separated by blanks, with a row of units", {"separated by blanks"});
}

TEST(TableDialects, ProseAboveTheNamesIsPassedOver) {
  expect_the_tip(data("openfast.out"),
                 "columns = { t = \"Time\", \"tip.x\" = \"TipX\", \"tip.y\" = \"TipY\" }",
                 "a table whose columns are separated by tabulators, with a row of units",
                 {"3 lines above the names of the columns passed over"});
}

TEST(TableDialects, ExponentsAndCommentsOfFortranAreRead) {
  expect_the_tip(
      data("fortran.txt"), "", "a table whose columns are separated by blanks",
      {"2 lines passed over, which begin with !", "\"0.0D+00\" and its like are read with the exponents"});
}

TEST(TableDialects, DecimalCommasBetweenSemicolonsAreRead) {
  expect_the_tip(data("semicolons.csv"), "", "a table whose columns are separated by semicolons",
                 {"the commas in its numbers are read as decimal signs"});
}

TEST(TableDialects, Utf16IsReadAndSaid) {
  expect_the_tip(data("utf16.csv"), "", "a table whose columns are separated by tabulators",
                 {"its text is UTF-16"});
}

TEST(TableDialects, ARunThatWentOnFromAnEarlierTimeCountsOnce) {
  expect_the_tip(data("restarted.txt"), "",
                 "a table whose columns are separated by blanks, with a row of units",
                 {"its header is repeated at line 6", "2 rows before a repeated header left out"});
}

TEST(TableDialects, NumbersHaveOneMeaning) {
  const std::pair<const char*, double> numbers[] = {
      {"1.5", 1.5},        {"+2", 2},          {"5d-2", 5e-2},    {"-5.0D+02", -500},
      {"1.0-101", 1e-101}, {"1.0+101", 1e101}, {"-.5-3", -.5e-3}, {"1.e3", 1000}};
  for (const auto& [text, value] : numbers) {
    const std::optional<double> found = table_number(text);
    ASSERT_TRUE(found) << text;
    EXPECT_EQ(*found, value) << text;
  }
  for (const char* text :
       {"2024-01", "1-2", "d5", "5d", "1.0-1.0", "1.0--1", "1,5", "0x1", "", "-", "1.0-", "12d3d4"})
    EXPECT_FALSE(table_number(text)) << text << " is " << *table_number(text);
}

struct Fault {
  std::string file, keys, words;
};

TEST(TableDialects, WhatCannotBeReadIsRefusedByWhatItIs) {
  using namespace std::string_literals;
  for (const Fault& fault : {
           Fault{"t tip.x tip.y\n0 1 0\n1 2\n", "", "chrono.csv:3:3: the row has 2 cells, the header has 3"},
           {"t tip.x tip.y\n0 1 0\n1 2 3 4\n", "", "chrono.csv:3:7: the row has 4 cells, the header has 3"},
           {"t tip.x tip.y\n(s) (m)\n0 1 0\n", "", "the row of units has 2 cells, that of the names 3"},
           {"t tip.x tip.y\n(s) (m) (N)\n0 1 0\n", "", "the unit is a unit of force, not of length"},
           {"\xFF\xFEt", "", "is UTF-16 by its first bytes, and has an odd number of them"},
           {"\xFF\xFE\x00\xDCt\x00"s, "", "is UTF-16 by its first bytes, and damaged at byte 2"},
           {"\xFF\xFE\0\0t\0\0\0"s, "", "is UTF-32 by its first bytes"},
           {"t\0,\0x\0\n\0"s, "", "looks like UTF-16 without the mark at its start"},
           {"t tip.x tip.y\n0 1,5 0\n1 2.5 0\n", "", "it cannot be told which is the decimal sign"},
           {"t tip.x tip.y\n0 1 0\n1 2 ****\n", "",
            "chrono.csv:3:5: tip.y = \"****\": must be a finite number"},
       }) {
    const std::string message = refusal(given_case(fault.file, fault.keys));
    EXPECT_NE(message.find(fault.words), std::string::npos) << message << "\nshould have: " << fault.words;
  }
}

TEST(TableDialects, AHintNamesNoColumnThatIsTwoNames) {
  const std::string message = refusal(given_case("Time tip.y,far\n0,1\n1,2\n"));
  EXPECT_EQ(message.find("did you mean"), std::string::npos) << message;
  EXPECT_NE(message.find("has no column \"t\" for the time"), std::string::npos) << message;
}

TEST(TableDialects, CellsBetweenBlanksKnowWhereTheyStand) {
  const std::vector<CsvLine> lines = parse_csv("  a\t (N m)  \"b c\"\n", "x", ' ');
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].cells.size(), 3U);
  EXPECT_EQ(lines[0].cells[1].text, "(N m)");
  EXPECT_EQ(lines[0].cells[1].column, 6);
  EXPECT_EQ(lines[0].cells[2].text, "b c");
}

/// A case beside two runs in a folder, on the disk.
class FolderOfRuns : public testing::Test {
 protected:
  FolderOfRuns() {
    std::string name = (std::filesystem::temp_directory_path() / "plumb-runs-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    std::filesystem::create_directory(folder_ / "runs");
    for (const char* file : {"runs/b one.csv", "runs/a.csv", "runs/.hidden"})
      write(file, "t,tip.x,tip.y\n0,1,0\n0.5,0.7,-0.2\n1,0,-1\n");
    write("runs/note.txt", "t tip.x tip.y\n0 1 0\n0.5 0.7 -0.3\n1 0 -1\n");
  }
  ~FolderOfRuns() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string load_with(const std::string& file, const std::string& keys = "") {
    CaseSource source = given_case("", keys);
    write("known.toml", source.references.front().text);
    write("case.toml", with(source.file.text, "chrono.csv", file));
    loaded_ = load_case((folder_ / "case.toml").string());
    std::string names;
    for (const GivenRunSpec& run : loaded_.spec.given_runs) names += run.name + " ";
    return names;
  }

  std::filesystem::path folder_;
  LoadedCase loaded_;
};

TEST_F(FolderOfRuns, EveryFileOfAFolderOrPatternIsARunNamedAfterIt) {
  EXPECT_EQ(load_with("runs"), "a b_one note ");
  EXPECT_EQ(load_with("runs/*.csv"), "a b_one ");
  EXPECT_EQ(loaded_.spec.given_runs[1].file, "runs/b one.csv");
  EXPECT_EQ(loaded_.source.given_runs.size(), 2U);
}

TEST_F(FolderOfRuns, TheSameRunsAreFoundInWhatIsStored) {
  for (const char* file : {"runs", "runs/*.csv", "runs/"}) {
    load_with(file);
    const CaseSource stored = loaded_.source;
    std::filesystem::rename(folder_ / "runs", folder_ / "gone");
    const LoadedCase again = load_case(stored);
    std::filesystem::rename(folder_ / "gone", folder_ / "runs");
    ASSERT_EQ(again.given_runs.size(), loaded_.given_runs.size()) << file;
    for (std::size_t k = 0; k < again.given_runs.size(); ++k)
      EXPECT_EQ(again.spec.given_runs[k].name, loaded_.spec.given_runs[k].name) << file;
  }
}

TEST_F(FolderOfRuns, WhatCannotStandForManyIsRefused) {
  const auto fault = [&](const std::string& file, const std::string& keys) -> std::string {
    try {
      return "read: " + load_with(file, keys);
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_NE(fault("runs", "name = \"x\"").find("several files cannot have one name"), std::string::npos)
      << fault("runs", "name = \"x\"");
  EXPECT_NE(fault("runs/*.h5", "").find("there is no file in it"), std::string::npos)
      << fault("runs/*.h5", "");
  EXPECT_NE(fault("missing/a.csv", "").find("cannot be read"), std::string::npos);
  for (int k = 0; k < 101; ++k)
    write("runs/r" + std::to_string(k) + ".csv", "t,tip.x,tip.y\n0,1,0\n1,0,-1\n");
  EXPECT_NE(fault("runs", "").find("at most 100 runs are allowed"), std::string::npos) << fault("runs", "");
}

}  // namespace table_dialects_test
}  // namespace plumb
