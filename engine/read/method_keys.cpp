#include "engine/read/method_keys.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {
namespace {

bool has(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

const MethodInfo* named_method(const TomlValue& root) {
  const TomlValue* method = root.find("method");
  const TomlValue* name = method != nullptr ? method->find("name") : nullptr;
  return name != nullptr ? find_method(name->string) : nullptr;
}

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

std::vector<std::string> drop_overruled_keys(const TomlValue& file, TomlValue& merged) {
  const MethodInfo* old_method = named_method(file);
  const MethodInfo* new_method = named_method(merged);
  if (old_method == nullptr || new_method == nullptr) return {};
  const std::vector<std::string> old_keys = method_keys(*old_method), new_keys = method_keys(*new_method);
  TomlValue& table = *merged.find("method");
  const auto overridden = [&](const char* key) {
    const TomlValue* value = table.find(key);
    return value != nullptr && value->place.in_override();
  };
  // Of a step and tolerances, a method that takes either is given what was said last.
  const bool either = new_method->takes_step && new_method->takes_tolerances;
  const bool step = either && overridden("step");
  const bool tolerances = either && (overridden("rtol") || overridden("atol"));
  std::vector<std::string> remarks;
  std::erase_if(table.items, [&](const TomlValue& item) {
    if (item.place.in_override()) return false;
    const bool replaced = old_method != new_method && has(old_keys, item.key) && !has(new_keys, item.key);
    const bool overruled =
        (step && (item.key == "rtol" || item.key == "atol")) || (tolerances && item.key == "step");
    if (!replaced && !overruled) return false;
    remarks.push_back(fmt::format("method.{} = {} of the file is not used by {}{}", item.key, item.written,
                                  new_method->name,
                                  replaced ? ""
                                  : step   ? " with a step"
                                           : " with tolerances"));
    return true;
  });
  return remarks;
}

}  // namespace plumb
