#include "engine/read/changed_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/errors.h"
#include "engine/read/value_text.h"

namespace plumb {

CaseChanges::CaseChanges(TableReader& owner, std::string whom) : owner_(&owner), whom_(std::move(whom)) {
  collect(owner.table("set").value(), "");
}

void CaseChanges::collect(const TomlValue& table, const std::string& before) {
  for (const TomlValue& item : table.items) {
    const std::string key = before.empty() ? item.key : fmt::format("{}.{}", before, item.key);
    if (item.kind == TomlValue::Kind::table)
      collect(item, key);
    else
      changes_.push_back({&item, key, fmt::format("{}={}", key, value_text(item))});
  }
}

std::vector<std::string> CaseChanges::overrides() const {
  std::vector<std::string> texts;
  for (const Change& change : changes_) texts.push_back(change.override_text);
  return texts;
}

std::vector<std::string> CaseChanges::keys() const {
  std::vector<std::string> keys;
  for (const Change& change : changes_) keys.push_back(change.key);
  return keys;
}

void CaseChanges::refuse_keys_in(const std::vector<std::string>& closed, std::string_view what) const {
  for (const Change& change : changes_)
    for (const std::string& table : closed)
      if (change.key == table || change.key.starts_with(table + ".")) refuse_key(change.key, what);
}

void CaseChanges::refuse_key(std::string_view key, std::string_view what) const {
  const auto change =
      std::find_if(changes_.begin(), changes_.end(), [&](const Change& any) { return any.key == key; });
  refuse(change->value->place, owner_->full_key("set." + change->key), change->value->written,
         std::string(what));
}

Case CaseChanges::read(const CaseWithOverrides& with, const std::vector<std::string>& before) const {
  std::string fault;
  try {
    return with(joined_overrides(before, overrides()));
  } catch (const InputError& error) {
    fault = error.what();
  } catch (const UsageError& error) {
    fault = error.what();
  }
  for (const Change& change : changes_) {
    const std::string start = fmt::format("--set {}: ", change.override_text);
    if (fault.starts_with(start))
      refuse_key(change.key, fmt::format("{}, in {}", fault.substr(start.size()), whom_));
  }
  const TomlValue* set = owner_->value().find("set");
  refuse(set != nullptr ? set->place : owner_->value().place, owner_->full_key("set"), "",
         fmt::format("{} is no valid case: {}", whom_, fault));
}

std::vector<std::string> joined_overrides(std::vector<std::string> before,
                                          const std::vector<std::string>& more) {
  const auto sets_method = [](const std::string& text) { return text.starts_with("method.name="); };
  if (std::any_of(more.begin(), more.end(), sets_method))
    std::erase_if(before, [](const std::string& text) { return text.starts_with("method."); });
  before.insert(before.end(), more.begin(), more.end());
  return before;
}

}  // namespace plumb
