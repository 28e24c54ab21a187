#include "engine/base/csv.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/base/errors.h"

namespace plumb {
namespace csv_test {

using Texts = std::vector<std::vector<std::string>>;

Texts texts(const std::string& csv, char separator = ',') {
  Texts result;
  for (const CsvLine& line : parse_csv(csv, "a.csv", separator)) {
    result.emplace_back();
    for (const CsvCell& cell : line.cells) result.back().push_back(cell.text);
  }
  return result;
}

TEST(Csv, CellsLinesAndQuotes) {
  EXPECT_EQ(texts("t [s],x\n0, 1 \r\n\n2,\"a,\"\"b\"\"\nc\"\n"),
            (Texts{{"t [s]", "x"}, {"0", "1"}, {"2", "a,\"b\"\nc"}}));
  EXPECT_EQ(texts("a;b\n1,5;2\n", ';'), (Texts{{"a", "b"}, {"1,5", "2"}}));
  EXPECT_EQ(texts("\xEF\xBB\xBFt,x"), (Texts{{"t", "x"}})) << "with a byte order mark";
  EXPECT_EQ(texts("1,,\n"), (Texts{{"1", "", ""}}));
  EXPECT_EQ(texts("a\tb\n", '\t'), (Texts{{"a", "b"}}));
  EXPECT_TRUE(texts("").empty());
}

TEST(Csv, KnowsWhereACellIs) {
  const auto lines = parse_csv("t,x\n\n0, ü,  3\n", "a.csv");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[1].number, 3);
  EXPECT_EQ(lines[1].cells[2].column, 8) << "characters, not bytes, and without the blanks before it";
}

TEST(Csv, BadQuotesAreRefusedWithTheirPlace) {
  for (const auto& [csv, place] : {std::pair{"a\n1,\"2\n3", "a.csv:2:3"}, {"\"a\"b,c\n", "a.csv:1:4"}}) {
    try {
      parse_csv(csv, "a.csv");
      ADD_FAILURE() << csv << " was taken";
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(place)) << error.what();
    }
  }
}

RC_GTEST_PROP(CsvProperty, WhatIsWrittenIsRead, ()) {
  const auto cells = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(
      rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab ,\"\n\r;.1")))));
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
  if (cells.front().empty()) return;  // an empty line, or one that begins so
  RC_ASSERT(texts(line + "\n") == Texts{cells});
}

}  // namespace csv_test
}  // namespace plumb
