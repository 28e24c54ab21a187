#include "engine/input/method_keys.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {
namespace {

bool has(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// The method that a case names, or nullptr where there is none by that name.
const MethodInfo* named_method(const TomlValue& root) {
  const TomlValue* method = root.find("method");
  const TomlValue* name = method != nullptr ? method->find("name") : nullptr;
  return name != nullptr ? find_method(name->string) : nullptr;
}

}  // namespace

std::vector<std::string> method_keys(const MethodInfo& method) {
  std::vector<std::string> keys;
  if (method.takes_step) keys.emplace_back("step");
  if (method.takes_tolerances) {
    keys.emplace_back("rtol");
    keys.emplace_back("atol");
  }
  for (const MethodParameter& parameter : method.parameters) keys.push_back(parameter.name);
  return keys;
}

std::vector<std::string> drop_keys_of_replaced_method(const TomlValue& file, TomlValue& merged) {
  const MethodInfo* old_method = named_method(file);
  const MethodInfo* new_method = named_method(merged);
  if (old_method == nullptr || new_method == nullptr || old_method == new_method) return {};
  const std::vector<std::string> old_keys = method_keys(*old_method), new_keys = method_keys(*new_method);
  std::vector<std::string> remarks;
  std::erase_if(merged.find("method")->items, [&](const TomlValue& item) {
    if (item.place.in_override() || !has(old_keys, item.key) || has(new_keys, item.key)) return false;
    remarks.push_back(fmt::format("method.{} = {} of the file is not used by {}", item.key, item.written,
                                  new_method->name));
    return true;
  });
  return remarks;
}

std::vector<std::string> drop_replaced_step_control(TomlValue& merged) {
  const MethodInfo* info = named_method(merged);
  if (info == nullptr || !info->takes_step || !info->takes_tolerances) return {};
  const auto is_tolerance = [](const TomlValue& item) { return item.key == "rtol" || item.key == "atol"; };
  auto& items = merged.find("method")->items;
  bool new_step = false, new_tolerance = false;
  for (const TomlValue& item : items) {
    if (!item.place.in_override()) continue;
    new_step |= item.key == "step";
    new_tolerance |= is_tolerance(item);
  }
  std::vector<std::string> remarks;
  std::erase_if(items, [&](const TomlValue& item) {
    const bool replaced = is_tolerance(item) ? new_step : item.key == "step" && new_tolerance;
    if (item.place.in_override() || !replaced) return false;
    remarks.push_back(
        fmt::format("method.{} = {} of the file is not used: {} takes either a step or rtol and atol",
                    item.key, item.written, info->name));
    return true;
  });
  return remarks;
}

}  // namespace plumb
