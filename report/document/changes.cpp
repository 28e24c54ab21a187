#include "report/document/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/base/document_value.h"

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

/// The same of numbers that `in_words` does not tell apart.
std::string in_full(const Document& value) {
  return value.is_null() || value.is_string() ? in_words(value) : value.dump();
}

void add_values(Document& changes, const std::string& what, const Document& before, const Document& now) {
  const bool alike = in_words(before) == in_words(now);
  add(changes, what, alike ? in_full(before) : in_words(before), alike ? in_full(now) : in_words(now));
}

/// The keys of two objects, those of `now` first.
std::vector<std::string> keys_of(const Document& before, const Document& now) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : now.items()) keys.push_back(key);
  for (const auto& [key, value] : before.items())
    if (!now.contains(key)) keys.push_back(key);
  return keys;
}

/// A list of objects as an object, so that its items are compared key by key.
Document by_number(const Document& value) {
  if (!value.is_array() || value.empty() || !value.front().is_object()) return value;
  Document numbered = Document::object();
  for (std::size_t k = 0; k < value.size(); ++k) numbered[std::to_string(k)] = value[k];
  return numbered;
}

void compare_members(Document& changes, const std::string& prefix, const Document& before,
                     const Document& now) {
  for (const std::string& key : keys_of(before, now)) {
    const Document was = before.contains(key) ? by_number(before[key]) : Document("–");
    const Document is = now.contains(key) ? by_number(now[key]) : Document("–");
    if (was.is_object() && is.is_object())
      compare_members(changes, prefix + key + ".", was, is);
    else if (was != is)
      add_values(changes, prefix + key, was, is);
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

bool all_numbers(const Document& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const Document& value) { return value.is_number(); });
}

std::string verdict_in_words(const Document& verdict) {
  const std::string status = verdict.at("status").get<std::string>();
  if (status == word(VerdictStatus::not_run)) return status;
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
  else if (times != old_times || !all_numbers(times))
    move.unlike = fmt::format("the earlier report has other output times ({}, this run {})", old_times.size(),
                              times.size());
  else if (values.size() != times.size() || old_values.size() != times.size())
    move.unlike = fmt::format("there are {} values in the earlier report and {} in this run at {} times",
                              old_values.size(), values.size(), times.size());
  else if (times.size() < 2)
    move.unlike = "there is no output after the start, where every run is the same";
  if (!move.unlike.empty()) return move;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double a = number_of(old_values[i]), b = number_of(values[i]);
    move.largest = std::max(move.largest, std::abs(a));
    const double distance = std::abs(b - a);
    // One that is not a number stays, and is a move wherever it stands.
    if (distance <= move.greatest || std::isnan(move.greatest)) continue;
    move.greatest = distance;
    move.time = number_of(times[i]);
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

Document case_differences(Document before, Document now) {
  // Where a case is, what its text looks like and with which options it was given say nothing of what it is;
  // what they bring about is in the other keys.
  for (Document* one : {&before, &now})
    for (const char* key : {"file", "text", "overrides"}) one->erase(key);
  Document differences = Document::array();
  compare_members(differences, "", before, now);
  return differences;
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
    add_values(changes, key, before.at("solve").at(key), now.at("solve").at(key));
  Document old_tools = before.at("provenance"), tools = now.at("provenance");
  for (Document* one : {&old_tools, &tools}) one->erase("made at");
  compare_members(changes, "", old_tools, tools);
  add(changes, "renderer", in_words(before.value("renderer", Document(""))),
      in_words(now.value("renderer", Document(""))));
  return changes;
}

}  // namespace plumb
