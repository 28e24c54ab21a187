#include "report/document/history.h"

#include <gtest/gtest.h>

#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace history_test {

Document made_entry() {
  static const Document document = document_of(evaluate(run_with("made"), {}), {});
  return history_entry(document);
}

TEST(History, HoldsWhatEachCriterionFoundAndMayFind) {
  const Document entry = made_entry();
  EXPECT_EQ(entry.at("case"), "by<hand>");
  ASSERT_EQ(entry.at("criteria").size(), 1U);
  const Document& criterion = entry["criteria"][0];
  EXPECT_EQ(criterion.at("name"), "known: tip.y");
  EXPECT_NEAR(criterion.at("value").get<double>(), 0.1, 1e-12);
  EXPECT_EQ(criterion.at("limit"), 0.125);
  EXPECT_EQ(criterion.at("status"), "passed");
}

TEST(History, GivesBackWhatWasWritten) {
  const Document none = entry_without_report("gone", {"a=1"}, "crashed (signal 11)");
  const History history = history_in(history_line(made_entry()) + history_line(none));
  EXPECT_TRUE(history.damaged.empty());
  ASSERT_EQ(history.entries.size(), 2U);
  EXPECT_EQ(history.entries[0], made_entry());
  EXPECT_EQ(history.entries[1], none);
}

TEST(History, PassesOverDamagedLinesAndNumbersThem) {
  const std::string line = history_line(made_entry());
  const History history = history_in(line + "no JSON\n\n" + line + line.substr(0, line.size() / 2));
  EXPECT_EQ(history.entries.size(), 2U);
  EXPECT_EQ(history.damaged, (std::vector<std::size_t>{2, 5}));
}

TEST(History, TakesNoLineThatLacksAKeyOrHasAnotherType) {
  const Document whole = made_entry();
  const auto expect_damaged = [](const Document& entry, const std::string& what) {
    const History history = history_in(history_line(entry));
    EXPECT_EQ(history.damaged.size(), 1U) << what;
    EXPECT_TRUE(history.entries.empty()) << what;
  };
  for (const auto& [key, value] : whole.items()) {
    Document entry = whole;
    entry.erase(key);
    expect_damaged(entry, key + " is missing");
    entry = whole;
    entry[key] = Document::object();
    if (key != "criteria") expect_damaged(entry, key + " is an object");
  }
  for (const auto& [key, value] : whole["criteria"][0].items()) {
    Document entry = whole;
    entry["criteria"][0].erase(key);
    expect_damaged(entry, "criteria." + key + " is missing");
    entry["criteria"][0][key] = Document::array();
    expect_damaged(entry, "criteria." + key + " is a list");
  }
  Document later = whole;
  later["plumb_history"] = 2;
  expect_damaged(later, "another version");
}

TEST(History, OfACaseIsThatWithTheSameOverridesAndTheLatest) {
  History history;
  for (int k = 0; k < 100; ++k) {
    Document entry = made_entry();
    entry["steps"] = k;
    if (k % 3 == 1) entry["case"] = "another";
    if (k % 3 == 2) entry["overrides"] = {"cable.elements=8"};
    history.entries.push_back(entry);
  }
  const std::vector<Document> same = of_same_case(history, made_entry());
  ASSERT_EQ(same.size(), most_runs_of_history);
  EXPECT_EQ(same.back().at("steps"), 99);
  EXPECT_EQ(same.front().at("steps"), 99 - 3 * (static_cast<int>(most_runs_of_history) - 1));
}

}  // namespace history_test
}  // namespace plumb
