#include "engine/case/key.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "engine/case/case.h"

namespace plumb {
namespace key_test {

struct Row {
  std::string keys, unit;
};

/// The rows of the tables of cases/README.md, by the first cell of their heads: "`[cable]`".
std::map<std::string, std::vector<Row>> tables() {
  std::map<std::string, std::vector<Row>> all;
  std::ifstream readme(PLUMB_SOURCE_DIR "/cases/README.md");
  std::string table;
  for (std::string line; std::getline(readme, line);) {
    if (!line.starts_with("| ")) {
      table.clear();
      continue;
    }
    const std::size_t first = line.find(" |", 1), second = line.find('|', first + 2);
    const Row row{line.substr(2, first - 2), line.substr(first + 2, second - first - 2)};
    if (table.empty())
      table = row.keys;
    else
      all[table].push_back(row);
  }
  return all;
}

template <class Spec>
void expect_described(const std::string& table) {
  const auto all = tables();
  ASSERT_TRUE(all.contains(table)) << "no table " << table << " in cases/README.md";
  for (const Key& key : keys_of<Spec>()) {
    const auto row = std::find_if(all.at(table).begin(), all.at(table).end(), [&](const Row& any) {
      return any.keys.find(fmt::format("`{}`", key.name)) != std::string::npos;
    });
    ASSERT_NE(row, all.at(table).end()) << table << ": " << key.name << " is not described";
    EXPECT_TRUE(row->unit.starts_with(" " + key.range.unit))
        << table << ": the unit of " << key.name << " is \"" << key.range.unit << "\", not \"" << row->unit
        << '"';
  }
}

TEST(Key, OfEveryTableIsDescribedWithItsUnitInTheReadme) {
  expect_described<CableSpec>("`[cable]`");
  expect_described<StartSpec>("`[start]`");
  expect_described<SupportsSpec>("`[supports]`, `[loads]`");
  expect_described<LoadsSpec>("`[supports]`, `[loads]`");
  expect_described<LoadSpec>("`[[load]]`");
  expect_described<MassSpec>("`[[mass]]`");
  expect_described<DampingSpec>("`[damping]`");
  expect_described<TimeSpec>("`[time]`");
  expect_described<ProbeSpec>("`[[probe]]`");
  expect_described<SceneSpec>("`[scene]`");
  expect_described<WorkPrecisionSpec>("`[study.work_precision]`");
  expect_described<StudyExtent>("`[study.work_precision]`");
  expect_described<StabilitySpec>("`[study.stability]`");
  expect_described<SweepSpec>("`[study.sweep]`");
  expect_described<EconomySpec>("`[study.economy]`");
  expect_described<SensitivitySpec>("`[sensitivity]`");
}

/// One field as a range that it must be in, if it is a number.
template <class T>
void expect_default_in_range(const Key& key, const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    EXPECT_TRUE(key.range.contains(static_cast<double>(value)))
        << key.name << " is " << value << " by default, and must be " << key.range.allowed();
  }
}

TEST(Key, HasADefaultThatIsInItsRange) {
  const Case spec;
  const auto expect = [](const Key& key, const auto& value) {
    if (!key.required) expect_default_in_range(key, value);
  };
  visit_motion(spec, [&](const char*, const auto& table) { visit_keys(table, expect); });
  visit_keys(spec.scene, expect);
}

TEST(Key, OfAReportOnACaseHasAMeaningOfItsOwn) {
  std::map<std::string_view, int> meanings;
  const Case spec;
  visit_motion(spec, [&](const char*, const auto& table) {
    visit_keys(table, [&](const Key& key, const auto&) {
      EXPECT_FALSE(key.meaning.empty()) << key.name;
      EXPECT_EQ(++meanings[key.meaning], 1) << key.meaning;
    });
  });
}

}  // namespace key_test
}  // namespace plumb
