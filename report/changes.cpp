#include "report/changes.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A value of a document in words; what is not finite has no number in JSON.
std::string in_words(const Document& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (value.is_null()) return "not finite";
  return value.dump();
}

void add(Document& changes, const std::string& what, const std::string& before, const std::string& now) {
  if (before != now) changes.push_back({{"what", what}, {"before", before}, {"now", now}});
}

/// The keys of two objects, those of `now` first.
std::vector<std::string> keys_of(const Document& before, const Document& now) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : now.items()) keys.push_back(key);
  for (const auto& [key, value] : before.items())
    if (!now.contains(key)) keys.push_back(key);
  return keys;
}

void compare_members(Document& changes, const std::string& prefix, const Document& before,
                     const Document& now) {
  for (const std::string& key : keys_of(before, now)) {
    const bool had = before.contains(key), has = now.contains(key);
    if (had && has && before[key].is_object() && now[key].is_object())
      compare_members(changes, prefix + key + ".", before[key], now[key]);
    else if (!had || !has || before[key] != now[key])
      add(changes, prefix + key, had ? in_words(before[key]) : "–", has ? in_words(now[key]) : "–");
  }
}

/// What the case says, apart from its text, of which only is told that it changed.
void compare_cases(Document& changes, Document before, Document now) {
  if (before.value("text", "") != now.value("text", ""))
    add(changes, "text of the case", "another one", "as below");
  for (Document* one : {&before, &now}) {
    one->erase("text");
    one->erase("file");
  }
  compare_members(changes, "", before, now);
}

std::string verdict_in_words(const Document& verdict) {
  const std::string status = verdict.at("status").get<std::string>();
  if (status == "not run") return status;
  return fmt::format("{}: {} {}", status, in_words(verdict.at("value")),
                     verdict.at("unit").get<std::string>());
}

std::string verdict_named(const Document& document, const std::string& name) {
  for (const Document& verdict : document.at("verdicts"))
    if (verdict.at("name") == name) return verdict_in_words(verdict);
  return "–";
}

void compare_verdicts(Document& changes, const Document& before, const Document& now) {
  for (const Document& verdict : now.at("verdicts")) {
    // Verdicts of regression are about changes themselves.
    if (verdict.at("kind") == "regression") continue;
    const std::string name = verdict.at("name").get<std::string>();
    add(changes, name, verdict_named(before, name), verdict_in_words(verdict));
  }
  for (const Document& verdict : before.at("verdicts")) {
    const std::string name = verdict.at("name").get<std::string>();
    if (verdict.at("kind") != "regression" && verdict_named(now, name) == "–")
      add(changes, name, verdict_in_words(verdict), "–");
  }
}

double number(const Document& value) {
  return value.is_number() ? value.get<double>() : nan;
}

ProbeMove move_of(const std::string& column, const Document& before, const Document& now) {
  ProbeMove move;
  move.column = column;
  const Document &old_probes = before.at("probes"), &probes = now.at("probes");
  if (!old_probes.contains(column)) move.unlike = "the earlier report has no such column";
  if (!probes.contains(column)) move.unlike = "this run has no such column";
  if (!move.unlike.empty()) return move;
  move.unit = probes[column].at("unit").get<std::string>();
  const Document &times = probes.at("t").at("values"), &old_times = old_probes.at("t").at("values");
  const Document &values = probes[column].at("values"), &old_values = old_probes[column].at("values");
  if (old_probes[column].at("unit") != move.unit)
    move.unlike = "the earlier report has another unit";
  else if (times != old_times || values.size() != old_values.size() || values.size() != times.size())
    move.unlike = fmt::format("the earlier report has other output times ({}, this run {})", old_times.size(),
                              times.size());
  if (!move.unlike.empty()) return move;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double a = number(old_values[i]), b = number(values[i]);
    if (std::isnan(a) && std::isnan(b)) continue;
    move.largest = std::max(move.largest, std::abs(a));
    const double distance = std::abs(b - a);
    if (distance <= move.greatest || std::isnan(move.greatest)) continue;
    move.greatest = distance;
    move.time = number(times[i]);
  }
  return move;
}

}  // namespace

std::vector<ProbeMove> probe_moves(const Document& before, const Document& now) {
  std::vector<ProbeMove> moves;
  for (const std::string& column : keys_of(before.at("probes"), now.at("probes")))
    if (column != "t") moves.push_back(move_of(column, before, now));
  return moves;
}

Document changes_between(const Document& before, const Document& now) {
  Document changes = Document::array();
  add(changes, "outcome", in_words(before.at("outcome")), in_words(now.at("outcome")));
  compare_verdicts(changes, before, now);
  for (const ProbeMove& move : probe_moves(before, now)) {
    if (!move.unlike.empty())
      add(changes, move.column, "–", move.unlike);
    else if (!(move.greatest == 0))
      add(changes, move.column, "",
          fmt::format("moved by at most {:.3g} {}, at {:.4g} s", move.greatest, move.unit, move.time));
  }
  compare_cases(changes, before.at("case"), now.at("case"));
  for (const char* key : {"elements", "end_time", "steps", "rejected_steps", "force_evaluations",
                          "tangent_evaluations", "newton_iterations"})
    add(changes, key, in_words(before.at("solve").at(key)), in_words(now.at("solve").at(key)));
  Document old_tools = before.at("provenance"), tools = now.at("provenance");
  for (Document* one : {&old_tools, &tools}) one->erase("made at");
  compare_members(changes, "", old_tools, tools);
  add(changes, "renderer", in_words(before.value("renderer", Document(""))),
      in_words(now.value("renderer", Document(""))));
  return changes;
}

}  // namespace plumb
