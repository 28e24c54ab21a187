#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/integrate/method_info.h"
#include "engine/read/case_sections.h"
#include "engine/read/method_keys.h"

namespace plumb {
namespace {

/// Null where the name is missing.
const MethodInfo* read_name(TableReader& table) {
  std::vector<std::string> names;
  for (const MethodInfo& info : method_infos()) names.push_back(info.name);
  // Of the words that are allowed; it has been seen to before.
  names.emplace_back(scene_method);
  const auto index = table.choice("name", names, false);
  return index ? &method_infos()[*index] : nullptr;
}

/// "scene", which chooses everything itself.
bool is_left_to_the_scene(const TableReader& table) {
  const TomlValue* name = table.value().find("name");
  return name != nullptr && name->kind == TomlValue::Kind::string && name->string == scene_method;
}

/// A key of another method is not unknown, but out of place.
void refuse_keys_of_others(const TableReader& table, const MethodInfo& method) {
  const std::vector<std::string> own = method_keys(method);
  for (const TomlValue& item : table.value().items) {
    if (item.key == "name" || std::find(own.begin(), own.end(), item.key) != own.end()) continue;
    std::vector<std::string> owners;
    for (const MethodInfo& other : method_infos()) {
      const std::vector<std::string> keys = method_keys(other);
      if (std::find(keys.begin(), keys.end(), item.key) != keys.end()) owners.push_back(other.name);
    }
    if (owners.empty()) continue;
    refuse(item.key_place, table.full_key(item.key), item.written,
           fmt::format("not a key of {}, which takes: {}; it belongs to {}", method.name,
                       fmt::join(own, ", "), fmt::join(owners, ", ")));
  }
}

void check_step(const TableReader& table, double step, const TimeSpec& time) {
  constexpr double most_steps = 1e9;
  if (step > time.end)
    table.refuse_value("step", fmt::format("must be at most the end time, {} (s)", time.end));
  if (time.end / step > most_steps) {
    table.refuse_value("step",
                       fmt::format("gives {:.3g} steps until the end time, {} s; at most {} are allowed",
                                   time.end / step, time.end, most_steps));
  }
}

}  // namespace

TimeSpec read_time(TableReader table, std::optional<double> end) {
  constexpr double most_outputs = 1e6;
  TimeSpec time;
  time.end = end.value_or(0);
  table.read(time, !end);
  // An external run has its own times, and no outputs of ours.
  if (end && !table.has("output_interval")) time.output_interval = time.end;
  table.finish();

  if (time.output_interval > time.end) {
    table.refuse_value("output_interval", fmt::format("must be at most the end time, {} (s)", time.end));
  }
  if (time.end / time.output_interval > most_outputs) {
    table.refuse_value("output_interval",
                       fmt::format("gives {:.3g} outputs until the end time, {} s; at most {} are allowed",
                                   time.end / time.output_interval, time.end, most_outputs));
  }
  return time;
}

MethodSpec read_method(TableReader table, const TimeSpec& time) {
  const Range tolerance{.low = 0, .high = 1, .low_open = true, .high_open = true};
  MethodSpec method;
  if (is_left_to_the_scene(table)) {
    table.has("name");
    for (const TomlValue& item : table.value().items)
      if (item.key != "name")
        refuse(item.key_place, table.full_key(item.key), item.written,
               "not a key of \"scene\", which chooses model, mesh, method and step itself");
    method.name = scene_method;
    table.finish();
    return method;
  }
  const MethodInfo* info = read_name(table);
  if (info == nullptr) {
    // Its other keys cannot be judged, but are not what is wrong.
    for (const MethodInfo& any : method_infos()) {
      for (const std::string& key : method_keys(any)) table.has(key);
    }
    table.finish();
    return method;
  }
  method.name = info->name;
  // Each is asked for, as a key that nobody asks for is unknown.
  const bool has_step = table.has("step"), has_rtol = table.has("rtol"), has_atol = table.has("atol");
  const bool has_tolerances = has_rtol || has_atol;
  if (info->takes_step && info->takes_tolerances && has_step && has_tolerances)
    table.refuse_value("step", fmt::format("{} takes either step or rtol and atol, not both", info->name));
  if (info->takes_step && (has_step || !info->takes_tolerances))
    method.step = table.number("step", Range::positive("s"));
  if (info->takes_tolerances && !method.step) {
    method.rtol = table.number("rtol", tolerance, info->rtol);
    method.atol = table.number("atol", Range::positive("of L, L/T, 1 and 1/T"), *method.rtol);
  }
  for (const MethodParameter& parameter : info->parameters) {
    if (!parameter.words.empty()) {
      const auto chosen = table.choice(parameter.name, parameter.words, true);
      method.parameters[parameter.name] = chosen ? static_cast<double>(*chosen) : parameter.fallback;
      continue;
    }
    Range range = Range::between(parameter.minimum, parameter.maximum, "");
    range.whole = parameter.whole;
    method.parameters[parameter.name] = table.number(parameter.name, range, parameter.fallback);
  }
  refuse_keys_of_others(table, *info);
  table.finish();

  if (method.step) check_step(table, *method.step, time);
  return method;
}

}  // namespace plumb
