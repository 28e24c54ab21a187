#include <fmt/format.h>

#include <algorithm>

#include "engine/base/errors.h"
#include "engine/base/nearest.h"
#include "engine/read/case_sections.h"
#include "engine/read/changed_case.h"

namespace plumb {
namespace {

constexpr std::size_t longest_name = 80;

/// A change of these would change what is compared, not how it is computed.
const std::vector<std::string> closed_tables = {"title",       "time",         "probe",      "reference",
                                                "run",         "figure",       "scene",      "study",
                                                "uncertainty", "error_budget", "sensitivity"};
constexpr std::string_view closed_reason =
    "is no part of how the motion is computed, and cannot be set in an error budget";

void read_item(TableReader& table, const CaseWithOverrides& with, const std::vector<std::string>& base,
               std::vector<BudgetItemSpec>& items, std::vector<std::string>& keys_together) {
  BudgetItemSpec item;
  item.name = table.text("name", "a name");
  const CaseChanges changes(table, fmt::format("the item \"{}\"", item.name));
  item.overrides = changes.overrides();
  item.reason = table.optional_prose("reason");
  item.together = table.flag("together", true);
  item.numerical = table.flag("numerical", false);
  table.finish();

  if (item.name.size() > longest_name)
    table.refuse_value("name", fmt::format("must be at most {} bytes long", longest_name));
  const auto same = [&](const BudgetItemSpec& other) { return other.name == item.name; };
  if (std::any_of(items.begin(), items.end(), same))
    table.refuse_value("name", "is the name of another item");
  if (item.overrides.empty())
    table.refuse_value("set", "must change at least one key, as in set = { cable.elements = 64 }");
  changes.refuse_keys_in(closed_tables, closed_reason);
  for (const std::string& key : changes.keys()) {
    if (!item.together) break;
    if (std::find(keys_together.begin(), keys_together.end(), key) != keys_together.end())
      changes.refuse_key(
          key,
          "is set by another item already, so that they cannot be changed together; together = false "
          "leaves this one out");
    keys_together.push_back(key);
  }
  changes.read(with, base);
  items.push_back(std::move(item));
}

}  // namespace

BudgetSpec read_error_budget(TableReader table, const std::vector<ReferenceUse>& references,
                             const CaseWithOverrides& with) {
  BudgetSpec spec;
  spec.reference = table.text("reference", "the name of a [[reference]]");
  const CaseChanges base(table, "the computation behind the reference");
  spec.overrides = base.overrides();
  spec.interval = table.number("interval", Range::positive("s"), 0);
  std::vector<TableReader> items = table.tables("item");
  table.finish();

  std::vector<std::string> names;
  for (const ReferenceUse& reference : references) names.push_back(reference.name);
  if (std::find(names.begin(), names.end(), spec.reference) == names.end())
    table.refuse_value("reference", "is the name of no [[reference]]" + suggestion(spec.reference, names));
  base.refuse_keys_in(closed_tables, closed_reason);
  const Case computed = base.read(with);
  spec.interval = std::min(spec.interval, computed.time.end);
  constexpr double most_times = 1e6;
  if (spec.interval > 0 && computed.time.end / spec.interval > most_times)
    table.refuse_value("interval", "must give at most 1,000,000 times");
  if (items.empty()) table.refuse_value("item", "must have at least one table [[error_budget.item]]");

  std::vector<std::string> keys_together;
  for (TableReader& item : items) read_item(item, with, spec.overrides, spec.items, keys_together);
  std::vector<std::string> together = spec.overrides;
  for (const BudgetItemSpec& item : spec.items)
    if (item.together) together = joined_overrides(std::move(together), item.overrides);
  std::string fault;
  try {
    with(together);
  } catch (const InputError& error) {
    fault = error.what();
  } catch (const UsageError& error) {
    fault = error.what();
  }
  if (!fault.empty()) table.refuse_value("item", "all items together are no valid case: " + fault);
  return spec;
}

}  // namespace plumb
